"""How far a review is, and what risk is left, in words."""

from __future__ import annotations

from app.core.i18n import count_text, tr
from app.features.review.presenter import QueueFigures
from tracking.review import ErrorsLeft, errors_left, reviewed_share
from tracking.session import Session
from tracking.tracks import Labels


class ProgressWords:
    """Counts anew only where tracks, labels or items are others."""

    def __init__(self) -> None:
        self._of: tuple[int, Labels, QueueFigures] | None = None
        self._text = ""

    def text(self, figures: QueueFigures, session: Session) -> str:
        """In a sentence or two; "" where nothing was found."""
        revision, labels = session.tracks.revision, session.labels
        if self._of is None or not (
            self._of[0] == revision and self._of[1] is labels and self._of[2] is figures
        ):
            self._of, self._text = (revision, labels, figures), _said(figures, session)
        return self._text


def _said(figures: QueueFigures, session: Session) -> str:
    if not figures.found and not figures.outcome.stated:
        return ""
    share = reviewed_share(session.tracks, session.labels, figures.decided)
    left = errors_left(figures.stated_left, figures.outcome, figures.stated * (1.0 - share))
    decided = len(figures.decided)
    reviewed = tr(
        "Reviewed: {share:.0%} of the footage; {decided} of {found} items decided or reviewed.",
        share=share,
        decided=decided,
        found=figures.found,
    )
    return f"{reviewed} {risk_text(left)}"


def risk_text(left: ErrorsLeft) -> str:
    """How many errors are expected to be left, and how sure that is."""
    return count_text(
        round(left.mean),
        "About {n} error left (likely {low} to {high}).",
        "About {n} errors left (likely {low} to {high}).",
        low=left.low,
        high=left.high,
    )
