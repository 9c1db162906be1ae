"""How a review gets on, in words: what was watched, decided and put right."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from app.core.i18n import count_text, tr
from tracking.editing import History
from tracking.formats import read_mot
from tracking.recording import Recording
from tracking.review import ReviewItem, ReviewMeasures, ReviewMeter, review_measures
from tracking.scoring import ScoringTable, identity_errors
from tracking.tracks import Labels, TrackTable

_EARLY: Final = 0.05
"""Share of the footage that a review should take."""
_NOT_CORRECTED: Final = frozenset(
    {
        *("verdict", "reviewed", "unreviewed", "rename", "notes", "attribute", "schema"),
        *("label", "unlabel", "occluders", "lines", "regions"),
    }
)
"""Kinds of edits that say something of the tracks and leave them as they are."""


class MeterWords:
    """Counts from where a session was opened: what was done in earlier sittings is left out."""

    def __init__(self, labels: Labels, history: History) -> None:
        self._before = ReviewMeter.of(labels, 0.0)
        self._corrected_before = _corrections(history)
        self._position: tuple[int, int, int] | None = None
        self._corrected = 0

    def text(self, labels: Labels, history: History, minutes: float) -> str:
        """In a line; "" before anything was done."""
        now = ReviewMeter.of(labels, minutes)
        decided = max(0, now.decided - self._before.decided)
        corrected = self._corrections_now(history)
        sitting = ReviewMeter(minutes, decided, corrected)
        if not (decided or corrected):
            return ""
        words = [
            tr("Since it was opened: {watched}", watched=_watched_text(minutes)),
            count_text(decided, "{n} decided", "{n} decided"),
            count_text(corrected, "{n} corrected", "{n} corrected"),
        ]
        if minutes >= 0.1:
            words.append(tr("{n:.1f} corrected a minute", n=sitting.fixed_per_minute))
        return "  \u00b7  ".join(words)

    def _corrections_now(self, history: History) -> int:
        if history.position != self._position:
            now = _corrections(history)
            self._position, self._corrected = history.position, len(now - self._corrected_before)
        return self._corrected


def _watched_text(minutes: float) -> str:
    """Seconds as long as minutes with a decimal would say next to nothing."""
    if minutes < 1.0:
        return tr("{n} s watched", n=math.ceil(60.0 * minutes))
    return tr("{n:.1f} min watched", n=minutes)


def _corrections(history: History) -> frozenset[int]:
    return frozenset(entry.id for entry in history.in_force if is_correction(entry.kind))


def is_correction(kind: str) -> bool:
    """Whether edits of a kind change tracks, rather than say something of them."""
    return kind not in _NOT_CORRECTED


def measure_queue(
    items: Sequence[ReviewItem], table: TrackTable, recording: Recording
) -> ReviewMeasures:
    """How good the queue is against the truth beside the recording; may take long.

    Raises:
        FormatError: the truth cannot be read.
    """
    assert recording.truth_path is not None
    truth = ScoringTable.from_columns(read_mot(recording.truth_path), dont_cares=True)
    errors = identity_errors(truth, ScoringTable.from_columns(table.columns()))
    return review_measures(items, errors, recording.frame_count, recording.fps)


def measures_text(measures: ReviewMeasures) -> str:
    """What the queue would show of the mistakes there are, in a line."""
    if not measures.errors:
        return tr("The ground truth shows no identity errors in these tracks.")
    if not len(measures.found):
        return tr("The ground truth shows {n} identity errors.", n=measures.errors)
    return tr(
        "By the ground truth, the queue shows {found} of {n} identity errors, {early} of them in "
        "the first {share:.0%} of the footage watched.",
        found=int(measures.found[-1]),
        n=measures.errors,
        early=measures.found_within(_EARLY),
        share=_EARLY,
    )
