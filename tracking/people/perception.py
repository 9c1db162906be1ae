"""Subtraction stereo from end to end: a stereo frame in, an observation out."""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects

from tracking.arrays import Mask
from tracking.errors import RecordingError
from tracking.foreground import (
    BackgroundModel,
    ForegroundSettings,
    SecondaryMode,
    ShadowRemover,
    Subtraction,
    in_size,
)
from tracking.geometry import Ground, Rectification
from tracking.people.detection_source import DetectionSource
from tracking.people.detections import Detections
from tracking.people.finder import PeopleFinder
from tracking.people.observation import Observation, Overlays
from tracking.people.one_camera import OneCamera
from tracking.people.settings import PeopleSettings
from tracking.people.stereo_boxes import add_bodies
from tracking.people.stereo_watch import StereoWatch, shows_nothing
from tracking.people.working_scale import shrink_of, shrunk
from tracking.recording.frame import Image, StereoFrame
from tracking.stereo import (
    STEP,
    SightLines,
    StereoSettings,
    SubtractionStereo,
    least_side_px,
)
from tracking.translation import Message

_PROTECTED_MARGIN_PX = 8
_NEARER_PX = 0.5
"""People's disparity is at least so much larger than that of the scene behind them."""
_UPDATES_PER_SCENE = 8
"""How far away the backgrounds are is looked at with their first update and every so many on."""


class StereoPerception:
    """Turns stereo frames into people on the floor; holds both cameras' background models.

    Each frame passes the stages `rectify`, `subtract`, `shade`, `match` and `find`; `remember`
    then lets the backgrounds follow. `observe` does all of them; they are public so that each can
    be timed. While the right camera fails, or its pictures are of other instants than the left
    camera's, people are found by the left one alone. `images` says by how much a camera is late:
    frames are to come with pictures of one instant, in the left camera's time (`Instants`).

    Args:
        rectification: of the recording.
        ground: where the floor is.
        fps: frames a second of the recording.
        foreground, stereo, people: settings; None for the usual ones.
        boxes: of another program's detector; None: people are seen by the foreground alone.
        looked_at: (height, width) non-zero where people are looked for in the left picture as
            recorded; None: everywhere.

    Attributes:
        images: whether the right camera fails, and whether either is late.

    Raises:
        RecordingError: its pictures are too small to be matched.
    """

    def __init__(
        self,
        rectification: Rectification,
        ground: Ground,
        fps: float,
        foreground: ForegroundSettings | None = None,
        stereo: StereoSettings | None = None,
        people: PeopleSettings | None = None,
        boxes: DetectionSource | None = None,
        looked_at: Mask | None = None,
    ) -> None:
        self._rectification = rectification
        self._boxes = boxes
        self._shrink = shrink_of(rectification.size[0])
        _require_size(rectification.size, self._shrink, stereo or StereoSettings())
        lines = SightLines(rectification, self._shrink)
        if looked_at is not None:
            looked_at, _ = rectification.rectify(looked_at, looked_at)
        self._backgrounds = (
            BackgroundModel(fps, foreground, looked_at),
            BackgroundModel(fps, foreground),
        )
        self._shadows = ShadowRemover(foreground)
        self._stereo = SubtractionStereo(lines, stereo)
        self._updates = 0
        self._finder = PeopleFinder(rectification, ground, lines, people or PeopleSettings())
        self._one_camera = OneCamera(
            rectification, ground, self._shrink, people or PeopleSettings()
        )
        self.stereo_watch = StereoWatch(fps)

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should be told of the cameras, a line each."""
        return self.stereo_watch.notes()

    def learn(self, frames: Iterable[StereoFrame], later: Iterable[StereoFrame] = ()) -> None:
        """Learn both backgrounds from frames spread over some time, before the first `observe`.

        Not needed, but it spares the ghosts of people who stand in the very first frames.
        Some twenty frames, each a second or more from the next, do well.

        Args:
            later: of each the frame a moment later, which tells what moves.
        """
        frames = list(frames)
        pairs, after = ([self.rectify(frame) for frame in some] for some in (frames, later))
        told = [k for k, pair in enumerate(pairs) if not shows_nothing(*pair)] or range(len(pairs))
        others = [
            background.learn_both_modes(
                [pairs[k][camera] for k in told],
                [after[k][camera] for k in told if after],
                [frames[k].time_s for k in told],
            )
            for camera, background in enumerate(self._backgrounds)
        ]
        self._learn_scene()
        self._restore_secondary(others[0], others[1])

    def _restore_secondary(self, left: SecondaryMode, right: SecondaryMode) -> None:
        """Give the scene back where somebody stood so long as to be learnt as background.

        Of two lasting modes of a place the farther one is the scene: people stand before it. So
        the primary modes are taken for a picture of people before the secondary ones.
        """
        if not cv2.hasNonZero(left.where):
            return
        learnt = [image.background for image in self._backgrounds]
        grey = [_grey(image) for image in learnt]
        self._stereo.suppose_scene(_grey(left.picture), _grey(right.picture))
        disparity = self._stereo.match(grey[0], grey[1], left.where, right.where)
        nearer = disparity > self._stereo.scene + _NEARER_PX
        points = self._finder.points(np.where(nearer, disparity, np.float32(np.nan)))
        body = np.ascontiguousarray(left.where[::STEP, ::STEP])
        masks = self._protected(self._finder.find(points, body, learnt[0]), left.where.shape)
        for background, other, mask in zip(self._backgrounds, (left, right), masks, strict=True):
            background.restore_secondary(other, mask)
        self._stereo.suppose_scene(*(_grey(image.background) for image in self._backgrounds))
        self._finder.scene = self._stereo.scene

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order.

        Raises:
            RecordingError: the frame has no right camera.
        """
        images = self.rectify(frame)
        if not self._are_of_use(frame, images):
            return self._by_left_camera(frame, images[0])
        plain = self.subtract(*images, frame.time_s)
        left, right = self._with_bodies(frame, *plain)
        shadow = self.shade(left)
        disparity = self.match(left, right)
        people = self.find(left, shadow, disparity)
        self.remember(*plain, people)
        overlays = self._overlays(left.mask, shadow, disparity)
        return Observation(frame.number, frame.time_s, people, overlays)

    def _are_of_use(self, frame: StereoFrame, images: tuple[Image, Image]) -> bool:
        """Whether both cameras see, and the same instant."""
        if frame.right_lag is None:
            return False
        self.stereo_watch.look(frame.number, *images, frame.right_lag)
        return not self.stereo_watch.failing and self.stereo_watch.lag == frame.right_lag

    def _by_left_camera(self, frame: StereoFrame, image: Image) -> Observation:
        """What is seen by the left camera; the right one's background is left as it was."""
        plain = self._backgrounds[0].subtract(image, frame.time_s)
        left, _ = self._with_bodies(frame, plain, plain)
        shadow = self.shade(left)
        size = (left.mask.shape[1], left.mask.shape[0])
        people = self._one_camera.find(left, in_size(shadow, size) & left.mask)
        self.remember(plain, None, people)
        overlays = self._overlays(left.mask, shadow, None)
        return Observation(frame.number, frame.time_s, people, overlays)

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; nothing is remembered, frames come in any order.

        Raises:
            RecordingError: the frame has no right camera.
        """
        left, right = self._with_bodies(frame, *self.subtract(*self.rectify(frame)))
        shadow = self.shade(left)
        disparity = None if frame.right_lag is None else self.match(left, right)
        return self._overlays(left.mask, shadow, disparity)

    def rectify(self, frame: StereoFrame) -> tuple[Image, Image]:
        """Both cameras rectified, at the working scale."""
        if frame.right is None:
            raise RecordingError(
                "frame {number}: there is no right camera; choose a tracker for one camera",
                number=frame.number,
            )
        pair = (frame.left, frame.right)
        if not self._rectification.identity and all(_is_grey(image) for image in pair):
            pair = (_one_channel(frame.left), _one_channel(frame.right))
        left, right = self._rectification.rectify(*pair)
        return self._working(left), self._working(right)

    def _working(self, image: Image) -> Image:
        """A camera at the working scale, with three channels."""
        image = shrunk(image, self._shrink)
        if image.ndim == 2:
            image = np.asarray(cv2.cvtColor(image, cv2.COLOR_GRAY2BGR), np.uint8)
        return image

    def subtract(
        self, left: Image, right: Image, time_s: float = 0.0
    ) -> tuple[Subtraction, Subtraction]:
        """Both cameras against their backgrounds."""
        one, other = self._backgrounds
        return one.subtract(left, time_s), other.subtract(right, time_s)

    def _with_bodies(
        self, frame: StereoFrame, left: Subtraction, right: Subtraction
    ) -> tuple[Subtraction, Subtraction]:
        """Both cameras with the bodies that boxes show in the foreground."""
        if self._boxes is None:
            return left, right
        return add_bodies(left, right, self._boxes, frame, self._rectification, self._shrink)

    def shade(self, left: Subtraction) -> Mask:
        """(rows, columns) uint8 on the grid: where the left foreground is shadow, if anywhere."""
        return self._shadows.dark(left)

    def match(self, left: Subtraction, right: Subtraction) -> NDArray[np.float32]:
        """(rows, columns) disparity of the left camera's foreground, of `SubtractionStereo`."""
        return self._stereo.match(_grey(left.picture), _grey(right.picture), left.mask, right.mask)

    def find(self, left: Subtraction, shadow: Mask, disparity: NDArray[np.float32]) -> Detections:
        """The people in the foreground."""
        here = np.ascontiguousarray(left.mask[::STEP, ::STEP])
        body = np.asarray(cv2.subtract(here, shadow), np.uint8)
        return self._finder.find(self._finder.points(disparity), body, left.picture)

    def remember(self, left: Subtraction, right: Subtraction | None, people: Detections) -> None:
        """Let the backgrounds of cameras that see follow what was seen, except where people are."""
        protected: tuple[Mask | None, Mask | None] = (None, None)
        due = self._backgrounds[0].update_is_due
        if due:
            protected = self._protected(people, left.mask.shape)
        for image, seen, mask in zip(self._backgrounds, (left, right), protected, strict=True):
            if seen is None:
                image.skip()
            else:
                image.update(seen, mask)
        if due:
            if self._updates % _UPDATES_PER_SCENE == 0:
                self._learn_scene()
            self._updates += 1

    def _learn_scene(self) -> None:
        self._stereo.learn_scene(*(_grey(image.background) for image in self._backgrounds))
        self._finder.scene = self._stereo.scene

    def _protected(self, people: Detections, shape: tuple[int, ...]) -> tuple[Mask, Mask]:
        """Masks of both cameras that cover the people generously."""
        masks = (np.zeros(shape, np.uint8), np.zeros(shape, np.uint8))
        shift = self._rectification.disparity_from_world(people.position) / self._shrink
        each = STEP * self._shrink
        places = find_objects(people.regions[::each, ::each], len(people))
        for place, moved in zip(places, np.rint(shift).astype(int).tolist(), strict=True):
            if not place:
                continue
            rows, columns = (_wider(side) for side in place)
            masks[0][rows, columns] = 255
            masks[1][rows, _moved_left(columns, moved)] = 255
        return masks

    def _overlays(
        self, mask: Mask, shadow: Mask, disparity: NDArray[np.float32] | None
    ) -> Overlays:
        return Overlays(mask, disparity, shadow, self._rectification.size, self._shrink)


def _require_size(size: tuple[int, int], shrink: int, stereo: StereoSettings) -> None:
    """Refuse pictures that are smaller than what both cameras are compared in."""
    least = shrink * least_side_px(stereo.window_px)
    if min(size) < least:
        raise RecordingError(
            "images of {width} x {height} px are too small to match two cameras, which needs "
            "{least} x {least}: choose a tracker for one camera",
            width=size[0],
            height=size[1],
            least=least,
        )


def _wider(side: slice) -> slice:
    """A side on the grid in working pixels, with the margin that is protected."""
    low, high = side.start * STEP - _PROTECTED_MARGIN_PX, side.stop * STEP + _PROTECTED_MARGIN_PX
    return slice(max(low, 0), high)


def _moved_left(side: slice, pixels: int) -> slice:
    return slice(max(side.start - pixels, 0), max(side.stop - pixels, 0))


def _grey(picture: Image) -> NDArray[np.uint8]:
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), np.uint8)


def _is_grey(image: Image) -> bool:
    """Whether the channels agree, by a sample; one channel is rectified faster than three."""
    sample = image[::16, ::16]
    return bool((sample == sample[..., :1]).all())


def _one_channel(image: Image) -> Image:
    return np.asarray(cv2.extractChannel(image, 1), np.uint8)
