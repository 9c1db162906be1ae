"""What the flow tracker looks at: the picture itself, and where something is in it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import (
    BackgroundModel,
    BodyMasks,
    ForegroundSettings,
    ShadowWeights,
    Subtraction,
    learn_frame,
)
from tracking.people import Detections, Observation, Overlays
from tracking.people.box_bodies import paint_bodies, working_boxes
from tracking.people.detection_source import DetectionSource
from tracking.recording.frame import Image, StereoFrame
from tracking.trackers.flow.half_resolution import double, halve, halve_mask
from tracking.trackers.flow.silhouettes import BODY, SHADE
from tracking.translation import Message

Mask = NDArray[np.uint8]

_SOLID = np.ones((3, 3), np.uint8)
_SHADOW = 100
"""Weight below which foreground is taken for shadow."""
_LAID = np.zeros(256, np.uint8)
_LAID[[SHADE, BODY]] = 127, 255
"""Values of `Overlays.foreground` for those of the mask."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FlowObservation(Observation):
    """What the flow tracker steps on.

    Attributes:
        mask: (rows, columns) uint8 `SHADE` where the foreground may be shadow, `BODY` where not,
            at half resolution (see `halving`).
    """

    mask: Mask


class FlowPerception:
    """Hands the picture on with the foreground, found at half resolution; finds no people itself.

    Pictures stay as recorded: kernels and floor places are worked out through the lens.

    Args:
        fps: frames a second of the recording.
        foreground: settings; None for the usual ones.
        boxes: of another program's detector; None: people are seen by the foreground alone.
        looked_at: (height, width) non-zero where people are looked for in the left picture as
            recorded; None: everywhere.

    Attributes:
        looked_at_half: the same at half resolution.
    """

    stereo_watch: None = None
    """It looks with one camera."""

    def __init__(
        self,
        fps: float,
        foreground: ForegroundSettings | None = None,
        boxes: DetectionSource | None = None,
        looked_at: Mask | None = None,
    ) -> None:
        self._background = BackgroundModel(fps, foreground, looked_at)
        self.looked_at_half = None if looked_at is None else halve_mask(looked_at)
        self._shadows = ShadowWeights()
        self._boxes = boxes
        self._last: Subtraction | None = None
        self._people: BodyMasks | None = None

    @property
    def notes(self) -> tuple[Message, ...]:
        """There are no notes."""
        return ()

    def learn(self, frames: Iterable[StereoFrame], later: Iterable[StereoFrame] = ()) -> None:
        """Learn the background from frames spread over some time, before the first `observe`.

        Args:
            later: of each the frame a moment later, which tells what moves.
        """
        frames = list(frames)
        pictures, after = ([halve(frame.left) for frame in some] for some in (frames, later))
        self._background.learn(pictures, after, [frame.time_s for frame in frames])

    def observe(self, frame: StereoFrame) -> FlowObservation:
        """The frame's picture and foreground. Frames come in order."""
        if self._last is not None:
            learn_frame(self._background, self._shadows, self._last, self._people)
        seen = self._background.subtract(halve(frame.left), frame.time_s)
        mask = self._mask(seen, frame.number)
        self._last, self._people = seen, None
        people = Detections.none(frame.left.shape[:2])
        overlays = _overlays(mask, frame.left)
        return FlowObservation(frame.number, frame.time_s, people, overlays, frame.left, mask=mask)

    @property
    def learns(self) -> bool:
        """Whether something is learnt of the frame observed last, so that `tell` is of use."""
        return self._background.update_is_due

    def tell(self, people: BodyMasks) -> None:
        """Say where people are in the frame observed last, before the next is observed.

        The background stays as it is there, and shadows are learnt from what lies beside them.

        Args:
            people: at half resolution.
        """
        self._people = people

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; nothing is remembered, frames come in any order."""
        return _overlays(
            self._mask(self._background.subtract(halve(frame.left)), frame.number), frame.left
        )

    def _mask(self, seen: Subtraction, frame: int) -> Mask:
        solid = cv2.morphologyEx(seen.mask, cv2.MORPH_CLOSE, _SOLID)
        mask = np.where(solid > 0, np.uint8(BODY), np.uint8(0))
        mask[(self._shadows.weigh(seen) < _SHADOW) & (mask > 0)] = SHADE
        if self._boxes is None:
            return mask
        boxes = working_boxes(self._boxes.of(frame).box, 2)
        solid = (mask == BODY).astype(np.uint8) * np.uint8(255)
        painted = paint_bodies(solid, boxes, 255, only=self._boxes.detections_only)
        if self._boxes.detections_only:
            mask = np.zeros_like(mask)
        mask[painted > 0] = BODY
        return mask


def _overlays(mask: Mask, image: Image) -> Overlays:
    return Overlays(double(_LAID[mask], (image.shape[1], image.shape[0])), None)
