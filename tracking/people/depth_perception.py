"""One camera with depth from end to end: a frame in, an observation out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

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
from tracking.people.stereo_boxes import add_bodies_of_left
from tracking.people.working_scale import shrink_of, shrunk
from tracking.recording.frame import Image, StereoFrame
from tracking.stereo import STEP, MeasuredDepth, SightLines, StereoSettings
from tracking.translation import Message, count_msg, msg

_NEARER_PX = 0.5
"""People's disparity is at least so much larger than that of the scene behind them."""
_PROTECTED = cv2.getStructuringElement(cv2.MORPH_RECT, (9, 9))
"""By half of it, on the grid, what is protected reaches beyond people."""
_LEAST_KNOWN = 0.02
"""Share of the picture that has a depth in a frame that is of use."""


class DepthPerception:
    """Turns frames with depth into people on the floor; holds the left camera's background.

    It works as `StereoPerception` does, with the measured depth where that one matches blocks.
    A frame without depth is looked at with the camera alone.

    Args:
        rectification: of the left camera and its imagined partner, see `depth_pair`.
        ground: where the floor is.
        fps: frames a second of the recording.
        foreground, stereo, people: settings; None for the usual ones.
        boxes: of another program's detector; None: people are seen by the foreground alone.
        looked_at: (height, width) non-zero where people are looked for in the left picture as
            recorded; None: everywhere.
    """

    stereo_watch: None = None

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
        lines = SightLines(rectification, self._shrink)
        if looked_at is not None:
            looked_at, _ = rectification.rectify(looked_at, looked_at)
        self._background = BackgroundModel(fps, foreground, looked_at)
        self._shadows = ShadowRemover(foreground)
        self._depth = MeasuredDepth(rectification, lines, stereo)
        self._finder = PeopleFinder(rectification, ground, lines, people or PeopleSettings())
        self._one_camera = OneCamera(
            rectification, ground, self._shrink, people or PeopleSettings()
        )
        self._without_depth = 0

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should be told of the depth."""
        if not self._without_depth:
            return ()
        frames = count_msg(self._without_depth, "{n} frame has", "{n} frames have")
        return (
            msg("{frames} no depth: people are tracked with the camera alone there", frames=frames),
        )

    def learn(self, frames: Iterable[StereoFrame], later: Iterable[StereoFrame] = ()) -> None:
        """Learn background and scene from frames spread over some time, before `observe`.

        Args:
            later: of each the frame a moment later, which tells what moves.
        """
        frames = list(frames)
        pairs = [self.rectify(frame) for frame in frames]
        images, disparities = [image for image, _ in pairs], [ranged for _, ranged in pairs]
        after = [self.rectify(frame)[0] for frame in later]
        times_s = [frame.time_s for frame in frames]
        other = self._background.learn_both_modes(images, after, times_s)
        self._depth.learn_scene(disparities)
        if cv2.hasNonZero(other.where):
            people = self._people_learnt(images, disparities, other)
            self._background.restore_secondary(other, people)
        self._finder.scene = self._depth.scene

    def _people_learnt(
        self,
        images: Sequence[Image],
        disparities: Sequence[NDArray[np.float32]],
        other: SecondaryMode,
    ) -> Mask:
        """Where the primary mode of the background is nearer than the secondary one: people."""
        shown = [image[::STEP, ::STEP].astype(np.int16) for image in images]
        modes = [
            mode[::STEP, ::STEP].astype(np.int16)
            for mode in (self._background.background, other.picture)
        ]
        distances = [[np.abs(image - mode).sum(axis=2) for mode in modes] for image in shown]
        primary = np.stack([first <= second for first, second in distances])
        ranged = np.stack(disparities)
        nearer = _mean_where(ranged, primary) > _mean_where(ranged, ~primary) + _NEARER_PX
        size = (other.where.shape[1], other.where.shape[0])
        people = cv2.dilate(nearer.astype(np.uint8) * 255, _PROTECTED)
        return in_size(np.asarray(people, np.uint8), size)

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order.

        Raises:
            RecordingError: the frame has no depth.
        """
        image, ranged = self.rectify(frame)
        plain = self._background.subtract(image, frame.time_s)
        left = self._with_bodies(frame, plain)
        shadow = self._shadows.dark(left)
        if np.isfinite(ranged).mean() < _LEAST_KNOWN:
            return self._by_camera_alone(frame, plain, left, shadow)
        disparity = self._depth.match(ranged, left.mask)
        here = np.ascontiguousarray(left.mask[::STEP, ::STEP])
        body = np.asarray(cv2.subtract(here, shadow), np.uint8)
        people = self._finder.find(self._finder.points(disparity), body, left.picture)
        self._remember(plain, people, ranged)
        overlays = self._overlays(left.mask, shadow, disparity)
        return Observation(frame.number, frame.time_s, people, overlays)

    def _by_camera_alone(
        self, frame: StereoFrame, plain: Subtraction, left: Subtraction, shadow: Mask
    ) -> Observation:
        self._without_depth += 1
        size = (left.mask.shape[1], left.mask.shape[0])
        people = self._one_camera.find(left, in_size(shadow, size) & left.mask)
        self._remember(plain, people, None)
        overlays = self._overlays(left.mask, shadow, None)
        return Observation(frame.number, frame.time_s, people, overlays)

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; nothing is remembered, frames come in any order."""
        image, ranged = self.rectify(frame)
        left = self._with_bodies(frame, self._background.subtract(image))
        disparity = self._depth.match(ranged, left.mask)
        return self._overlays(left.mask, self._shadows.dark(left), disparity)

    def rectify(self, frame: StereoFrame) -> tuple[Image, NDArray[np.float32]]:
        """The left camera rectified, at the working scale, and the disparities on the grid."""
        if frame.depth is None:
            raise RecordingError(
                "frame {number}: there is no depth; choose a tracker for one camera",
                number=frame.number,
            )
        image = self._rectification.rectify_left(frame.left)
        return shrunk(image, self._shrink), self._depth.disparity(frame.depth)

    def _with_bodies(self, frame: StereoFrame, left: Subtraction) -> Subtraction:
        """The camera with the bodies that boxes show in the foreground."""
        if self._boxes is None:
            return left
        return add_bodies_of_left(left, self._boxes, frame, self._rectification, self._shrink)

    def _remember(
        self, left: Subtraction, people: Detections, ranged: NDArray[np.float32] | None
    ) -> None:
        """Let background and scene follow what was seen, except where people are."""
        if not self._background.update_is_due:
            self._background.update(left, None)
            return
        protected = self._protected(people, left.mask.shape)
        self._background.update(left, protected)
        if ranged is not None:
            self._depth.follow_scene(ranged, (left.mask | protected)[::STEP, ::STEP])
            self._finder.scene = self._depth.scene

    def _protected(self, people: Detections, shape: tuple[int, ...]) -> Mask:
        """A mask that covers the people generously."""
        mask = np.zeros(shape, np.uint8)
        each, beyond = STEP * self._shrink, _PROTECTED.shape[0] // 2
        for place in find_objects(people.regions[::each, ::each], len(people)):
            if place:
                rows, columns = (
                    slice(max(side.start - beyond, 0) * STEP, (side.stop + beyond) * STEP)
                    for side in place
                )
                mask[rows, columns] = 255
        return mask

    def _overlays(
        self, mask: Mask, shadow: Mask, disparity: NDArray[np.float32] | None
    ) -> Overlays:
        return Overlays(mask, disparity, shadow, self._rectification.size, self._shrink)


def _mean_where(values: NDArray[np.float32], where: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Mean over the first axis of what is known and chosen; NaN where nothing is."""
    chosen = where & np.isfinite(values)
    count = chosen.sum(axis=0)
    total = np.where(chosen, values, 0).sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan).astype(np.float32)
