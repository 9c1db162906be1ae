"""How edits move the score."""

from __future__ import annotations

from app.core.i18n import count_text, joined_text, tr
from app.core.scenes.score_figures import hota_moved
from app.features.scoring.subject import ScoreResult
from tracking.editing import History
from tracking.scoring import Score


class Moves:
    """Remembers the score before the last edits, and that of the first time it was asked for.

    Scores are set side by side where all but the edits is alike.

    Attributes:
        by_edit: what the edits moved that were scored one by one, by their ids.
    """

    def __init__(self) -> None:
        self._first: ScoreResult | None = None
        self._before: ScoreResult | None = None
        self._now: ScoreResult | None = None
        self.by_edit: dict[int, str] = {}

    def take(self, scored: ScoreResult) -> None:
        """A further score."""
        now = self._now
        if now is None or now.subject.asked != scored.subject.asked:
            self._first = self._now = scored
            self._before, self.by_edit = None, {}
        elif now.edits == scored.edits:
            self._now = scored  # the same tracks, other frames shown
        else:
            self._before, self._now = now, scored
            if len(scored.edits) == len(now.edits) + 1:
                self.by_edit[scored.edits[-1]] = hota_moved(now.whole, scored.whole)

    @property
    def before(self) -> Score | None:
        """The score before the last edits; None where there were none since it was asked for."""
        return self._before.whole if self._before is not None else None

    def words(self, history: History | None) -> str:
        """Whose doing the last movement was, and how far it went since the first score."""
        if self._before is None or self._now is None or self._first is None:
            return ""
        made = len(self._now.edits) - len(self._before.edits)
        if made == 1:
            last = tr("Last edit: {edit}", edit=_text_of(history, self._now.edits[-1]))
        elif made == -1:
            last = tr("Undone: {edit}", edit=_text_of(history, self._before.edits[-1]))
        else:
            last = count_text(abs(made), "Last: {n} edit", "Last: {n} edits")
        since = hota_moved(self._first.whole, self._now.whole)
        whole = tr("since it was first scored: {moved}", moved=since) if since else ""
        return joined_text("; ", filter(None, (last, whole)))


def edits_not_undone(history: History | None) -> tuple[int, ...]:
    """The ids of the edits whose doing the tracks are, oldest first."""
    entries = history if history is not None else ()
    return tuple(entry.id for entry in entries if not entry.undone)


def _text_of(history: History | None, edit: int) -> str:
    entries = history if history is not None else ()
    return next((entry.text for entry in entries if entry.id == edit), "")
