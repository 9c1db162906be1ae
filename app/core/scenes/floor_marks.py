"""All that features draw over the floor in a frame."""

from __future__ import annotations

from dataclasses import dataclass, field

from app.core.scenes.flow_map import FlowScene
from app.core.scenes.ground_truth import FlooredTruth
from app.core.scenes.labels import FloorLabels
from app.core.scenes.other_people import OtherPlace


@dataclass(frozen=True, slots=True)
class FloorMarks:
    """Attributes: see the views of each; flow: None where none is shown."""

    labels: FloorLabels = field(default_factory=FloorLabels)
    others: tuple[OtherPlace, ...] = ()
    truth: FlooredTruth = field(default_factory=FlooredTruth)
    flow: FlowScene | None = None
