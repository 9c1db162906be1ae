"""A recording: both cameras by frame number, with what is known of cameras and floor."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from pathlib import Path
from threading import Lock

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask
from tracking.errors import RecordingError
from tracking.geometry import Ground, Rectification, StereoCalibration, View
from tracking.recording.depth_pictures import Depth, DepthSource
from tracking.recording.fingerprint import Fingerprint, fingerprint
from tracking.recording.frame import Image, StereoFrame
from tracking.recording.image_pairs import ImagePairs
from tracking.recording.locate import Located
from tracking.recording.manifest import TRUTH_NAME
from tracking.recording.pictures import PictureSource
from tracking.recording.recording_calibration import Calibrated
from tracking.translation import Message, msg

_DARK = 40
_FLAT = 6
_LEAST_BAR_SHARE = 0.03
_LEAST_LIKENESS = 0.5
_LEAST_UNEVEN_SHARE = 0.1
"""Of the time of a frame, by which stamps of cameras differ from an even rate to be kept."""


class Recording:
    """An opened recording; made by `open_recording`.

    Frames are exact and counted from 0. Both cameras of a frame are of the same instant: by number,
    or where a camera lost frames and its times tell, by time (see `pair_frames`). A camera whose
    pictures all come late is not noticed here; see `Instants`. `read` may be called from several
    threads.

    Attributes:
        path: what was opened.
        folder: what the paths of its manifest are relative to.
        name: for people.
        fps: frames per second; the manifest's counts before the video's.
        frame_count: the number of frames; of two cameras that differ, the shorter one's.
        size: width and height of one camera's pictures in px.
        right_lag: frames by which the right camera is late, where the manifest tells; see
            `Instants`.
        calibration, ground, view, rectification: None where not known; a rectification needs two
            calibrated cameras, or one and depth, a view a calibrated left camera and the floor.
        looked_at: (height, width) uint8, 255 where people are looked for in the left picture;
            None: everywhere.
        manifest_text, calibration_text: as read; the manifest's is made up where there is none,
            or where options said otherwise.
        calibration_files: that text is of; they may lie outside the folder.
        own_manifest: whether that text is the folder's recording.toml, as read.
        manifest_folder: of a recording.toml that says all but the sources, or all; None: there is
            none, or options said otherwise.
        trusted: whether that text may name files outside the folder.
        truth_path: the truth.txt in the recording's folder; None without one.
    """

    def __init__(
        self,
        located: Located,
        cameras: ImagePairs,
        calibrated: Calibrated,
        depth: DepthSource | None = None,
        calibration_files: Sequence[Path] = (),
    ) -> None:
        self.path: Path = located.path
        self.folder: Path = located.folder
        self.name: str = located.manifest.name
        self.frame_count: int = cameras.frame_count
        self.size: tuple[int, int] = cameras.size
        self.fps: float = _rate(located, cameras)
        self.right_lag: int | None = located.manifest.right_lag
        self.calibration: StereoCalibration | None = calibrated.calibration
        self.ground: Ground | None = located.manifest.ground
        self.view: View | None = calibrated.view
        self.rectification: Rectification | None = calibrated.rectification
        self.looked_at: Mask | None = located.manifest.region.pixels(cameras.size)
        self.manifest_text: str = located.text
        self.own_manifest: bool = located.own
        self.manifest_folder: Path | None = _manifest_folder(located)
        self.trusted: bool = located.trusted
        self.calibration_text: str = calibrated.text
        self.calibration_files: tuple[Path, ...] = tuple(calibration_files)
        truth = located.path / TRUTH_NAME
        self.truth_path: Path | None = truth if truth.is_file() else None
        self._cameras = cameras
        self._depth = depth
        self._times_s = _uneven_times(cameras, self.fps, self.frame_count)
        self._lock = Lock()
        self._opening_notes = (
            *located.notes,
            *_manifest_notes(located, cameras, self.fps),
            *calibrated.notes,
        )
        self._opening_notes += self._first_frame_notes()

    @property
    def is_stereo(self) -> bool:
        """Whether there is a right camera."""
        return self._cameras.is_stereo

    @property
    def has_depth(self) -> bool:
        """Whether a depth picture stands beside each left one, in place of a right camera."""
        return self._depth is not None

    @property
    def duration_s(self) -> float:
        """Length in seconds, the last frame's own time included."""
        last = self.frame_count - 1
        return self.time_s(last) + 1 / self.fps

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities to tell the user, in words; grows where broken frames are met."""
        sources = [note for source in self._cameras.sources for note in source.notes]
        depth = self._depth.notes if self._depth is not None else ()
        return (*self._opening_notes, *self._cameras.notes, *sources, *depth)

    @property
    def sources(self) -> tuple[Path, ...]:
        """Where the pictures are, the left (or only) camera first; a folder for images."""
        return tuple(
            files[0] if len(files) == 1 else files[0].parent
            for files in (source.files for source in self._all_sources)
        )

    def picture_files(self, *, right: bool = False) -> tuple[Path, ...]:
        """The files of the left (or only) camera, or of the right one: videos, or all images."""
        return self._cameras.sources[-1 if right else 0].files

    def fingerprints(self) -> tuple[Fingerprint, ...]:
        """A fingerprint of each source, in the order of `sources`."""
        return tuple(fingerprint(source.name, source.files) for source in self._all_sources)

    @property
    def _all_sources(self) -> tuple[PictureSource | DepthSource, ...]:
        depth = () if self._depth is None else (self._depth,)
        return (*self._cameras.sources, *depth)

    @property
    def uneven_times_s(self) -> NDArray[np.float64] | None:
        """(frame_count,) increasing seconds of the frames; None where they come evenly."""
        return self._times_s

    def time_s(self, number: int) -> float:
        """Seconds from the first frame to the given one."""
        return number / self.fps if self._times_s is None else float(self._times_s[number])

    def read(self, number: int, right_number: int | None = None) -> StereoFrame:
        """One frame; where it is given, with the right picture of another one.

        Raises:
            RecordingError: there is no such frame, or nothing of the video can be decoded.
        """
        right_number = number if right_number is None else right_number
        self._check(number)
        self._check(right_number)
        with self._lock:
            left, right = self._cameras.read(number, right_number)
        lag = right_number - number
        return StereoFrame(number, self.time_s(number), left, right, lag, self._depth_of(number))

    def frames(
        self, start: int = 0, stop: int | None = None, lag: int = 0
    ) -> Generator[StereoFrame]:
        """Frames start to stop (half-open) in order, read fast and apart from `read`.

        Args:
            lag: frames by which the right camera is late; negative: the left one. Beyond its first
                and its last picture these stand in, and `right_lag` is None.

        Raises:
            RecordingError: the range is not in the recording.
        """
        stop = self.frame_count if stop is None else stop
        if not 0 <= start <= stop <= self.frame_count:
            raise RecordingError(
                "{path}: frames {start} to {stop} are not within 0 to {frame_count}",
                path=self.path,
                start=start,
                stop=stop,
                frame_count=self.frame_count,
            )
        lag = lag if self.is_stereo else 0
        for number, (left, right) in enumerate(self._cameras.pairs(start, stop, lag), start):
            right_lag = lag if 0 <= number + lag < self.frame_count else None
            depth = self._depth_of(number)
            yield StereoFrame(number, self.time_s(number), left, right, right_lag, depth)

    def close(self) -> None:
        """Let go of all files."""
        with self._lock:
            for source in self._all_sources:
                source.close()

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _depth_of(self, number: int) -> Depth | None:
        return None if self._depth is None else self._depth.read(number)

    def _check(self, number: int) -> None:
        if not 0 <= number < self.frame_count:
            raise RecordingError(
                "{path}: there is no frame {number}, only 0 to {last}",
                path=self.path,
                number=number,
                last=self.frame_count - 1,
            )

    def _first_frame_notes(self) -> tuple[Message, ...]:
        sources = [source for source in self._cameras.sources if source.frame_count > 1]
        found = [first_frame_note(s.name, s.read(0), s.read(1)) for s in sources]
        return tuple(note for note in found if note is not None)


def _manifest_folder(located: Located) -> Path | None:
    """Where the recording.toml stands that was read."""
    if located.own:
        return located.folder
    return located.path if located.sourceless else None


def _rate(located: Located, cameras: ImagePairs) -> float:
    fps = located.manifest.fps or cameras.sources[0].fps
    if not fps:
        raise RecordingError(
            "{path}: images do not say how fast they were taken; give fps in recording.toml, "
            "or --fps",
            path=located.path,
        )
    return fps


def _uneven_times(cameras: ImagePairs, fps: float, count: int) -> NDArray[np.float64] | None:
    """The stream's own times where its frames do not come evenly.

    Where they do, the recording's rate counts, also where the stream's differs a little.
    """
    source = cameras.sources[0]
    if source.times_s is None or source.fps is None or abs(source.fps - fps) > 0.01 * fps:
        return None
    even = np.arange(count) / source.fps
    times = source.times_s[:count]
    # Stamps of cameras are kept where they tell more than the rate; those of videos are rounded.
    share = 0.5 if source.stamps_ns is None else _LEAST_UNEVEN_SHARE
    return None if np.abs(times - even).max() < share / source.fps else times


def _manifest_notes(located: Located, cameras: ImagePairs, fps: float) -> tuple[Message, ...]:
    notes = [
        msg("recording.toml: {key} means nothing here", key=key) for key in located.manifest.unknown
    ]
    streamed = cameras.sources[0].fps
    if streamed is not None and abs(streamed - fps) > 0.01 * fps:
        notes.append(
            msg(
                "{name}: the video is of {streamed:g} frames per second, recording.toml says "
                "{fps:g}, which is used",
                name=cameras.sources[0].name,
                streamed=streamed,
                fps=fps,
            )
        )
    return tuple(notes)


def first_frame_note(name: str, first: Image, second: Image) -> Message | None:
    """What is odd about a source's first picture, in words; None where it is like the next.

    Cameras often begin with a picture in another mode: letterboxed, black or grey.
    """
    bars, later = _bar_px(first), _bar_px(second)
    if bars - later > _LEAST_BAR_SHARE * min(first.shape[:2]):
        return msg(
            "{name}: frame 0 is letterboxed (bars of {bars} px), unlike those after it",
            name=name,
            bars=bars,
        )
    if _likeness(first, second) < _LEAST_LIKENESS:
        return msg("{name}: frame 0 shows something else than those after it", name=name)
    return None


def _likeness(first: Image, second: Image) -> float:
    """Correlation of the two pictures, made small; 1 where the second one has no contents."""
    one, two = (
        cv2.resize(image, (64, 48), interpolation=cv2.INTER_AREA).ravel()
        for image in (first, second)
    )
    if two.std() < _FLAT:
        return 1.0
    return float(np.corrcoef(one, two)[0, 1]) if one.std() > 0 else 0.0


def _bar_px(image: Image) -> int:
    """The width of the widest dark, flat bar along an edge of the picture."""
    green = image[..., 1]
    bars = []
    for axis in (0, 1):
        brightest = green.max(axis=axis)
        dark = (brightest < _DARK) & (brightest - green.min(axis=axis) < _FLAT)
        bars += [_leading(dark), _leading(dark[::-1])]
    return max(bars)


def _leading(flags: NDArray[np.bool_]) -> int:
    """How many are set before the first that is not."""
    return len(flags) if flags.all() else int(np.argmin(flags))
