"""What a report is on: recordings with their truth, and the results measured on them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tracking.scoring.table import ScoringTable

if TYPE_CHECKING:  # scores without pictures do without what reads them
    from tracking.geometry import View
    from tracking.recording import Recording


@dataclass(frozen=True, slots=True, eq=False)
class Footage:
    """What is known of a recording; everything may be unknown.

    Attributes:
        fps: frames a second. size_px: width and height of a picture.
        view: the left camera on its floor.
        pictures: to read frames from.
    """

    fps: float | None = None
    size_px: tuple[int, int] | None = None
    view: View | None = None
    pictures: Recording | None = None


@dataclass(frozen=True, slots=True)
class Source:
    """Where tracks are from; all but the place may be unknown.

    Attributes:
        place: of the file, as people named it.
        recording: its name. frames: its length. fps: frames a second.
        tracker: who found them. detections: files of another program's that it was given.
        rough: metres come from a rough calibration.
    """

    place: str
    recording: str | None = None
    frames: int | None = None
    fps: float | None = None
    tracker: str | None = None
    detections: tuple[str, ...] = ()
    rough: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Subject:
    """One sequence.

    Attributes:
        name: as people call it.
        truth: its rows; frames are counted from `start`.
        results: the same of each result, by its name.
        start, stop: the frames that are measured.
        footage: what the pictures tell.
        true_source: where the truth is from; None where nobody says.
        result_sources: the same of results, by their names.
    """

    name: str
    truth: ScoringTable
    results: Mapping[str, ScoringTable]
    start: int
    stop: int
    footage: Footage = field(default_factory=Footage)
    true_source: Source | None = None
    result_sources: Mapping[str, Source] = field(default_factory=dict)
