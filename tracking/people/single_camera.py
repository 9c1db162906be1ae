"""People from one camera: a frame in, an observation out."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tracking.foreground import PERHAPS, BackgroundModel, ForegroundSettings, ShadowRemover
from tracking.geometry import View
from tracking.people import upright
from tracking.people.describing import Describer
from tracking.people.detections import Detections
from tracking.people.observation import Observation, Overlays
from tracking.people.regions_of_people import people_regions
from tracking.people.settings import PeopleSettings
from tracking.people.standing import Standing
from tracking.recording.frame import Image, StereoFrame

Mask = NDArray[np.uint8]


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
        self._background = BackgroundModel(fps, foreground)
        self._shadows = ShadowRemover(foreground)
        settings = people or PeopleSettings()
        self._standing = Standing(view, 1, settings)
        self._describer = Describer(self._standing, settings)

    def learn(self, frames: Iterable[StereoFrame]) -> None:
        """Learn the background from frames spread over some time, before the first `observe`."""
        self._background.learn([frame.left for frame in frames])

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order."""
        seen = self._background.subtract(frame.left)
        shadow = self._shadows.shadows(seen)
        people = self._find(_kinds(seen.mask, shadow), seen.picture)
        self._background.update(seen, (people.regions > 0).view(np.uint8))
        overlays = Overlays(np.where(shadow == 255, np.uint8(127), seen.mask), None)
        return Observation(frame.number, frame.time_s, people, overlays, frame.left)

    def _find(self, kind: Mask, picture: Image) -> Detections:
        regions = people_regions(kind, self._standing)
        return self._describer.describe(regions, picture)


def _kinds(mask: Mask, shadow: Mask) -> Mask:
    """(height, width) the kinds of foreground of `tracking.people.upright`, 0 in the background."""
    kind = mask.copy()
    kind[shadow == PERHAPS] = upright.PERHAPS
    kind[shadow == 255] = upright.SHADOW
    return kind
