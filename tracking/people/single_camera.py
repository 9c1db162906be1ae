"""People from one camera: a frame in, an observation out."""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel, ForegroundSettings, ShadowRemover
from tracking.geometry import View
from tracking.people.colours import clothes_colours, colour_histograms
from tracking.people.detections import Detections
from tracking.people.observation import Observation, Overlays
from tracking.people.settings import PeopleSettings
from tracking.recording.frame import Image, StereoFrame

Mask = NDArray[np.uint8]
_LEAST_AREA_PX = 150


class SingleCameraPerception:
    """Turns pictures of one fixed camera, or of the left eye of two, into people.

    Args:
        fps: frames a second of the recording.
        view: the camera over its floor; None: nothing is known in metres.
        foreground, people: settings; None for the usual ones.
    """

    def __init__(
        self,
        fps: float,
        view: View | None = None,
        foreground: ForegroundSettings | None = None,
        people: PeopleSettings | None = None,
    ) -> None:
        self._view = view
        self._background = BackgroundModel(fps, foreground)
        self._shadows = ShadowRemover(foreground)
        self._settings = people or PeopleSettings()

    def learn(self, frames: Iterable[StereoFrame]) -> None:
        """Learn the background from frames spread over some time, before the first `observe`."""
        self._background.learn([frame.left for frame in frames])

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order."""
        seen = self._background.subtract(frame.left)
        shadow = self._shadows.shadows(seen)
        body = np.where(shadow == 255, np.uint8(0), seen.mask)
        people = self._find(body, seen.picture)
        self._background.update(seen, (people.regions > 0).view(np.uint8))
        overlays = Overlays(np.where(shadow == 255, np.uint8(127), seen.mask), None)
        return Observation(frame.number, frame.time_s, people, overlays, frame.left)

    def _find(self, body: Mask, picture: Image) -> Detections:
        closed = cv2.morphologyEx(body, cv2.MORPH_CLOSE, np.ones((5, 3), np.uint8))
        count, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
        kept = [k for k in range(1, count) if stats[k, cv2.CC_STAT_AREA] >= _LEAST_AREA_PX]
        number = np.zeros(count, np.uint8)
        number[kept] = np.arange(1, len(kept) + 1)
        regions = number[labels]
        boxes = [(int(a), int(b), int(c), int(d)) for a, b, c, d in stats[kept, :4]]
        return _described(regions, boxes, picture, self._settings)


def _described(
    regions: Mask,
    boxes: list[tuple[int, int, int, int]],
    picture: Image,
    settings: PeopleSettings,
) -> Detections:
    hsv = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2HSV), np.uint8)
    upper, lower, middle = colour_histograms(hsv[..., :2], regions, boxes, settings)
    count = len(boxes)
    return Detections(
        box=np.array(boxes, np.float64).reshape(count, 4) - (0.5, 0.5, 0, 0),
        position=np.full((count, 3), np.nan),
        size=np.full((count, 2), np.nan),
        merged=np.zeros(count, np.bool_),
        truncated=np.zeros(count, np.bool_),
        upper=upper,
        lower=lower,
        middle=middle,
        regions=regions.astype(np.int32),
        clothes=clothes_colours(picture, regions, boxes),
    )
