"""How far a review is, and what risk is left, in words."""

from __future__ import annotations

from app.core.i18n import tr
from app.core.scenes.review_words import decided_text, risk_text
from tracking.review import DecidedItems, ReviewState, learned_rate

_MANY, _FEW = 1.25, 0.8
"""As many times the usual number of errors is told."""


def progress_text(state: ReviewState) -> str:
    """In a few sentences; "" where nothing was found."""
    if not state.items:
        return ""
    so_far = decided_text(state.decided, state.items, state.reviewed)
    words = (so_far, risk_text(state.errors), learned_text(state.outcome))
    return " ".join(word for word in words if word)


def learned_text(outcome: DecidedItems) -> str:
    """Why more, or fewer, errors are expected than before; "" where decisions changed little."""
    rate = learned_rate(outcome)
    if rate >= _MANY:
        return tr("More decided items were errors than stated, so more are expected in the others.")
    if rate <= _FEW:
        return tr(
            "Fewer decided items were errors than stated, so fewer are expected in the others."
        )
    return ""
