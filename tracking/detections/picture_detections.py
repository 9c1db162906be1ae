"""Boxes of a plug-in's detector as perception asks for them, made as frames are tracked."""

from __future__ import annotations

import hashlib

from tracking.arrays import Mask
from tracking.detections.catalogue import DETECTORS
from tracking.detections.detector import DetectorSpec
from tracking.detections.looked_at import LookedAt
from tracking.detections.settings import DetectionSettings
from tracking.people.detection_source import FrameDetections
from tracking.recording import StereoFrame
from tracking.tracks import DetectionsInput
from tracking.translation import Message, count_msg, msg

DETECTOR = "detector"
"""The format of such detections, as sessions and reports have it."""


class PictureDetections(LookedAt):
    """Gives the boxes of a detector for the frame that was looked at last.

    Args:
        spec: the detector. settings, both, looked_at: see `LookedAt`.

    Raises PluginError where it does not work; what it holds is to be closed.
    """

    appearance = None
    """It describes nobody."""

    def __init__(
        self,
        spec: DetectorSpec,
        settings: DetectionSettings,
        *,
        both: bool,
        looked_at: Mask | None = None,
    ) -> None:
        super().__init__(settings, both=both, looked_at=looked_at)
        self._spec = spec
        self._detector = spec.open()

    def look(self, frame: StereoFrame) -> None:
        """Find the people in a frame, before it is asked about. Raises PluginError."""
        self.keep(frame, [self._found(picture) for picture in self.pictures_of(frame)])

    def _found(self, picture: object) -> FrameDetections:
        found = self._detector.find(picture)  # type: ignore[arg-type]
        sure = found.score >= self._least_score
        return FrameDetections(found.box[sure], found.score[sure])

    @property
    def _least_score(self) -> float:
        asked = self.settings.least_score
        return self._spec.min_score if asked is None else asked

    def close(self) -> None:
        """Let go of the detector."""
        self._detector.close()

    @property
    def inputs(self) -> tuple[DetectionsInput, ...]:
        """Which detector it is, as a run keeps it; the number of boxes so far."""
        offer = DETECTORS.offer(self._spec.name)
        where = "" if offer is None else f"{offer.package} {offer.version} {offer.target}"
        return (
            DetectionsInput(
                camera="",
                file=self._spec.name,
                format=DETECTOR,
                fingerprint=hashlib.sha256(where.encode()).hexdigest(),
                count=self.count,
                network=self._spec.title,
                decoder="",
                licence=self._spec.licence,
            ),
        )

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should know of it, a line each."""
        seen = count_msg(self.pictures, "{n} picture", "{n} pictures")
        if self.pictures and not self.count:
            return (
                msg(
                    "warning: detector {name} found nobody in {pictures} with a score from "
                    "{least:.3g} on; lower detections.min_score",
                    name=self._spec.name,
                    pictures=seen,
                    least=self._least_score,
                ),
            )
        return (
            msg(
                "detector {name}: {boxes} in {pictures}, with a score from {least:.3g} on",
                name=self._spec.name,
                boxes=count_msg(self.count, "{n} box", "{n} boxes"),
                pictures=seen,
                least=self._least_score,
            ),
        )
