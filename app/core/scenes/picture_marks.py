"""All that features draw over one camera's picture in a frame."""

from __future__ import annotations

from dataclasses import dataclass, field

from app.core.scenes.detections import NO_DETECTIONS, PicturedDetections
from app.core.scenes.ground_truth import PicturedTruth
from app.core.scenes.labels import PictureLabels
from app.core.scenes.other_people import Divider, OtherMark
from app.core.scenes.pictured_parts import PicturedParts
from app.core.scenes.suggested_marks import SuggestedMark


@dataclass(frozen=True, slots=True)
class PictureMarks:
    """Labels, body parts, another session's people, the truth, a detector's boxes.

    suggested: boxes that can be accepted.
    divider: between one's own people and those others; None: all of both are drawn.
    """

    labels: PictureLabels = field(default_factory=PictureLabels)
    parts: PicturedParts = field(default_factory=PicturedParts)
    others: tuple[OtherMark, ...] = ()
    truth: PicturedTruth = field(default_factory=PicturedTruth)
    detections: PicturedDetections = NO_DETECTIONS
    divider: Divider | None = None
    suggested: tuple[SuggestedMark, ...] = ()
