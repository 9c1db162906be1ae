"""What the spheroid tracker looks at: the background difference as a ramp, undistorted."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask
from tracking.foreground import (
    BackgroundModel,
    BodyMasks,
    CameraWatch,
    ForegroundSettings,
    RampSettings,
    ShadowWeights,
    Subtraction,
    learn_frame,
    ramp,
)
from tracking.geometry import FlatView, View
from tracking.people import Detections, Observation, Overlays
from tracking.people.box_bodies import paint_bodies, working_boxes
from tracking.people.detection_source import DetectionSource
from tracking.people.working_scale import shrink_of, shrunk
from tracking.recording.frame import Image, StereoFrame
from tracking.translation import Message

Picture = NDArray[np.uint8]

_SMOOTHED = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))
_SHADOW = 100
"""Weight below which foreground is shown as a shadow."""
_BODY = 230
"""B times 255 of a body in a box: detectors err more than foreground that differs much."""


@dataclass(frozen=True, slots=True, eq=False)
class FlatObservation(Observation):
    """The products of one frame.

    Attributes:
        ramp: (height, width) uint8, B times 255 in flat pixels: see `FlatView`.
        working: the picture beside its background, shrunk but not undistorted.
        boxes: (n, 4) of another program's detector, px as recorded; its bodies are in the ramp.
    """

    ramp: Picture = field(kw_only=True)
    working: Subtraction = field(kw_only=True)
    boxes: NDArray[np.float64] = field(kw_only=True)


class SpheroidPerception:
    """Turns pictures of one fixed camera, or of the left camera of two, into flat ramp pictures.

    People are not looked for here: hypotheses of where they are explain the whole picture.

    Args:
        fps: frames a second. view: the camera over its floor.
        foreground, ramp: settings; None for the usual ones.
        boxes: of another program's detector; None: people are seen by the foreground alone.
        looked_at: (height, width) non-zero where people are looked for in the left picture as
            recorded; None: everywhere.
    """

    stereo_watch: None = None
    """It looks with one camera."""

    def __init__(
        self,
        fps: float,
        view: View,
        foreground: ForegroundSettings | None = None,
        ramp_settings: RampSettings | None = None,
        boxes: DetectionSource | None = None,
        looked_at: Mask | None = None,
    ) -> None:
        self.flat = FlatView(view, shrink_of(view.camera.width))
        self.camera = CameraWatch(fps)
        self._boxes = boxes
        self._background = BackgroundModel(fps, foreground, looked_at)
        self._shadows = ShadowWeights()
        self._ramp = ramp_settings or RampSettings()
        self._last: Subtraction | None = None
        self._masks: BodyMasks | None = None

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
        pictures, after = ([self._working(each.left) for each in some] for some in (frames, later))
        self._background.learn(pictures, after, [frame.time_s for frame in frames])

    def observe(self, frame: StereoFrame) -> FlatObservation:
        """What is seen in the frame. Frames come in order."""
        self._remember()
        seen = self._background.subtract(self._working(frame.left), frame.time_s)
        self.camera.look(frame.number, seen.picture)
        weight = self._shadows.weigh(seen)
        boxes = self._boxes_of(frame)
        flat = self.flat.flatten(self._with_bodies(self._weigh(seen, weight), boxes))
        self._last, self._masks = seen, None
        return FlatObservation(
            frame.number,
            frame.time_s,
            Detections.none(frame.left.shape[:2]),
            self._overlays(seen.mask, weight, frame.left),
            frame.left,
            ramp=flat,
            working=seen,
            boxes=boxes,
        )

    def tell(self, people: BodyMasks) -> None:
        """Say where people are in the frame observed last, before the next is observed.

        The background stays as it is there, and shadows are learnt from what lies beside them.
        """
        self._masks = people

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; no state is kept, frames come in any order."""
        seen = self._background.subtract(self._working(frame.left))
        return self._overlays(seen.mask, self._shadows.weigh(seen), frame.left)

    def ramp_picture(self, frame: StereoFrame) -> Picture:
        """(height, width) uint8, B times 255 in pixels of the left picture as recorded.

        No state is kept, frames come in any order.
        """
        seen = self._background.subtract(self._working(frame.left))
        weighed = self._weigh(seen, self._shadows.weigh(seen))
        return _in_full(self._with_bodies(weighed, self._boxes_of(frame)), frame)

    def _boxes_of(self, frame: StereoFrame) -> NDArray[np.float64]:
        """(n, 4) px as recorded."""
        return np.zeros((0, 4)) if self._boxes is None else self._boxes.of(frame.number).box

    def _with_bodies(self, weighed: Picture, boxes: NDArray[np.float64]) -> Picture:
        """B times 255 with bodies in the boxes (n, 4) px as recorded."""
        if self._boxes is None:
            return weighed
        working = working_boxes(boxes, self.flat.shrink)
        return paint_bodies(weighed, working, _BODY, only=self._boxes.detections_only)

    def _weigh(self, seen: Subtraction, weight: Picture) -> Picture:
        """B times 255 with shadows weighed down, not undistorted."""
        rising = ramp(seen, self._background, self._ramp)
        weighed = cv2.multiply(rising, weight, scale=1 / 255)
        # Smoothing before subtraction makes everybody half a pixel larger all round: a pixel at
        # the edge counts half.
        smaller = cv2.erode(weighed, _SMOOTHED)
        return np.asarray(cv2.addWeighted(weighed, 0.5, smaller, 0.5, 0.0), np.uint8)

    def _remember(self) -> None:
        """Learn from the frame before, once it is known where people were in it."""
        if self._last is not None:
            learn_frame(self._background, self._shadows, self._last, self._recorded_masks())

    def _recorded_masks(self) -> BodyMasks | None:
        """Where people were in the frame before, in pixels that are not undistorted."""
        if self._masks is None or not self._background.update_is_due:
            return None
        masks = (self._masks.on, self._masks.beside, self._masks.kept)
        return BodyMasks(*map(self.flat.unflatten, masks))

    def _working(self, image: Image) -> Image:
        """The camera at the working scale."""
        return shrunk(image, self.flat.shrink)

    def _overlays(self, mask: Picture, weight: Picture, image: Image) -> Overlays:
        shown = mask.copy()
        shown[(weight < _SHADOW) & (mask > 0)] = 127
        if shown.shape != image.shape[:2]:
            size = (image.shape[1], image.shape[0])
            shown = np.asarray(cv2.resize(shown, size, interpolation=cv2.INTER_NEAREST), np.uint8)
        return Overlays(shown, None)


def _in_full(picture: Picture, frame: StereoFrame) -> Picture:
    size = (frame.left.shape[1], frame.left.shape[0])
    if picture.shape[::-1] == size:
        return picture
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_LINEAR), np.uint8)
