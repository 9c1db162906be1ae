"""A clip: which frames of which cameras are written, how large, with what drawn over them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum

from PySide6.QtGui import QFont

from app.core.feature import FloorMarker, Marker
from app.core.look.theme import Theme
from app.core.projection.extent import Bounds
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.tracks.track_reader import TrackReader
from tracking.recording import Recording


class ClipKind(Enum):
    """What a clip is written as; the value is the ending of its file."""

    MP4 = ".mp4"
    GIF = ".gif"


@dataclass(frozen=True, slots=True)
class ClipChoice:
    """What the user wants.

    Attributes:
        kind: of the file. start, stop: the half-open range of frames.
        height_px: of the clip. fps: its pictures per second. speed: of the recording in it.
        right, floor: also the right camera, the overhead view.
        follow: the track that is cut out and followed; 0: whole pictures.
        people, trails, marks: whether boxes with names, trails, and all else that lies over the
            pictures is drawn. legends: whether it is told what the signs and colours mean, and
            which camera is which. stamp: whether frame number and time are.
    """

    kind: ClipKind
    start: int
    stop: int
    height_px: int
    fps: float
    speed: float = 1.0
    right: bool = False
    floor: bool = False
    follow: int = 0
    people: bool = True
    trails: bool = True
    marks: bool = True
    legends: bool = True
    stamp: bool = True

    def view_options(self, now: ViewOptions) -> ViewOptions:
        """What of what lies over the pictures now is drawn."""
        options = replace(now, trails=self.trails)
        if self.marks:
            return options
        nothing = ViewOptions(floor_legend=now.floor_legend, trails=self.trails)
        return replace(nothing, region=False, detections=False, labels=False, parts=False)

    def picture_count(self, recorded_fps: float) -> int:
        """How many pictures the clip has."""
        return max(1, round((self.stop - self.start) / recorded_fps / self.speed * self.fps))

    def repeats(self, recorded_fps: float) -> Iterator[tuple[int, int]]:
        """The frames that are shown, in order, and how many pictures each of them is."""
        step = self.speed * recorded_fps / self.fps  # frames from one picture to the next
        last, times = self.start, 0
        for number in range(self.picture_count(recorded_fps)):
            frame = min(self.start + int(number * step + 1e-6), self.stop - 1)
            if frame != last and times:
                yield last, times
                times = 0
            last, times = frame, times + 1
        yield last, times


@dataclass(frozen=True, slots=True, eq=False)
class ClipSource:
    """All that is drawn, as it was when the clip was asked for: what is edited later is not in it.

    Attributes:
        recording: where the pictures come from. lag: of its right camera in frames.
        tracks: a copy that nobody changes. state: of any frame; its names, colours and selection.
        view_options: what lies over the pictures. bounds: of the floor, m.
        markers, floor_markers: what features draw. theme, font: of the window.
    """

    recording: Recording
    lag: int
    tracks: TrackReader
    state: FrameState
    view_options: ViewOptions
    bounds: Bounds
    markers: tuple[Marker, ...]
    floor_markers: tuple[FloorMarker, ...]
    theme: Theme
    font: QFont

    def state_at(self, frame: int) -> FrameState:
        """The tracks in a frame."""
        return replace(self.state, frame=frame, tracks=self.tracks)

    def marks(self, side: Side, state: FrameState) -> PictureMarks:
        """What features draw over one camera's picture."""
        marks = PictureMarks()
        number = state.frame + (self.lag if side is Side.RIGHT else 0)
        for marker in self.markers:
            marks = marker(marks, side, state, number)
        return marks

    def floor_marks(self, state: FrameState) -> FloorMarks:
        """What features draw over the floor."""
        marks = FloorMarks()
        for marker in self.floor_markers:
            marks = marker(marks, state)
        return marks
