"""What the views draw of truth, errors and scores."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes.score_figures import ScoreRow
from tracking.scoring import ErrorKind


@dataclass(frozen=True, slots=True)
class ErrorChoice:
    """A kind of error as the panel lists it.

    Attributes:
        kind: see `ErrorKind`. name: e.g. "Switches". count: how many; -1: not known yet.
        shown: whether the lane shows them and one walks through them.
    """

    kind: ErrorKind
    name: str
    count: int
    shown: bool


@dataclass(frozen=True, slots=True)
class ScoreScene:
    """The panel.

    Attributes:
        truths: what can be chosen as truth; the last asks for a file. truth: which is, -1: none.
        results: whose tracks can be scored. result: whose are.
        on_floor, threshold: how rows are paired: by overlap of boxes, or by distance in metres.
        rows: figures, none before anything was scored.
        whole, visible: over which frames. moved: whose doing the last movement was.
        errors: the kinds of errors.
        doing: what is at work. message: what to do, or why there is no score. notes: of the truth.
    """

    truths: tuple[str, ...]
    truth: int
    results: tuple[str, ...]
    result: int
    on_floor: bool
    threshold: float
    rows: tuple[ScoreRow, ...] = ()
    whole: str = ""
    visible: str = ""
    moved: str = ""
    errors: tuple[ErrorChoice, ...] = ()
    doing: str = ""
    message: str = ""
    notes: tuple[str, ...] = ()
