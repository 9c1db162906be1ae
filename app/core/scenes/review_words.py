"""How far a review is and how many errors are left, in the same words wherever it is told."""

from __future__ import annotations

from app.core.i18n import N_, count_text, tr
from tracking.review import ErrorsLeft

COUNTED = N_(
    "Identity errors are counted: a person who goes on under another id, or an id that goes over "
    "to another person. Missed people, tracks of nobody and inexact boxes are not counted."
)
"""What is expected to be left is of this alone."""


def decided_text(decided: int, items: int, boxes: float) -> str:
    """How far a review is. boxes: share of them that is reviewed, 0 to 1."""
    return tr(
        "Decided: {decided} of {items} items ({share:.0%}). Reviewed: {boxes:.0%} of the boxes.",
        decided=decided,
        items=items,
        share=decided / items if items else 1.0,
        boxes=boxes,
    )


def risk_text(left: ErrorsLeft) -> str:
    """How many errors are expected to be left, and how sure that is."""
    return count_text(
        round(left.mean),
        "About {n} identity error left (likely {low} to {high}).",
        "About {n} identity errors left (likely {low} to {high}).",
        low=left.low,
        high=left.high,
    )


def risk_figures(left: ErrorsLeft) -> str:
    """The same in a cell of a table: "10 (1 to 24)"."""
    return tr("{n} ({low} to {high})", n=round(left.mean), low=left.low, high=left.high)
