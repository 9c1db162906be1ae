"""The figures of a score that the panel lists, and how they are written."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from app.core.i18n import tr
from tracking.scoring import Score


@dataclass(frozen=True, slots=True)
class Figure:
    """One of them.

    Attributes:
        name, hint: in English. value: NaN where it is not defined.
        form: how it is written. sign: 1 where more is better, -1 where less is.
        short: its name where there is little room; "": the same.
    """

    name: str
    hint: str
    value: Callable[[Score], float]
    form: str = "{:.3f}"
    sign: int = 1
    short: str = ""

    def text(self, score: Score) -> str:
        """The value as it is written."""
        value = self.value(score)
        return "\u2013" if math.isnan(value) else self.form.format(value)

    def moved(self, before: Score, after: Score) -> tuple[str, int]:
        """By how much it moved, with sign and arrow, and whether that is better (1) or worse."""
        by = self.value(after) - self.value(before)
        amount = "" if math.isnan(by) else self.form.format(abs(by))
        if amount in ("", self.form.format(0.0)):
            return "", 0
        way = 1 if by > 0 else -1
        arrow = "\u25b2 +" if by > 0 else "\u25bc \u2212"
        return arrow + amount, self.sign * way


FIGURES: Final = (
    Figure(
        "HOTA",
        "Detection and association with equal weight, over thresholds from 0.05 to 0.95",
        lambda score: score.hota.hota,
    ),
    Figure(
        "IDF1",
        "Share of rows with the right id, where each id stands for one person in all frames",
        lambda score: score.identity.idf1,
    ),
    Figure(
        "MOTA",
        "1 minus misses, false alarms and switches as a share of the ground truth's rows; may be "
        "negative",
        lambda score: score.clear.mota,
    ),
    Figure(
        "People kept",
        "People who keep one id, of those who were detected",
        lambda score: score.tracking_accuracy,
        "{:.1%}",
        short="Kept",
    ),
    Figure(
        "Position error (median)",
        "Distance on the floor between matched rows",
        lambda score: score.position_error.median,
        "{:.2f} m",
        -1,
        "Position error",
    ),
    Figure(
        "Switches",
        "A person is matched to another track than before",
        lambda score: score.clear.id_switches,
        "{:.0f}",
        -1,
    ),
    Figure(
        "Fragmentations",
        "A person is matched again after frames without a match",
        lambda score: score.clear.fragmentations,
        "{:.0f}",
        -1,
        "Frag.",
    ),
    Figure(
        "Misses",
        "Rows of the ground truth without a match",
        lambda score: score.clear.misses,
        "{:.0f}",
        -1,
    ),
    Figure(
        "False alarms",
        "Rows of the result without a match",
        lambda score: score.clear.false_positives,
        "{:.0f}",
        -1,
    ),
    Figure("DetA", "How well people are found, part of HOTA", lambda score: score.hota.deta),
    Figure("AssA", "How well ids are kept, part of HOTA", lambda score: score.hota.assa),
)


def figure_named(name: str) -> Figure:
    """One of them.

    Raises:
        StopIteration: there is none of that name.
    """
    return next(one for one in FIGURES if one.name == name)


def rows_of(whole: Score, visible: Score, before: Score | None) -> tuple[ScoreRow, ...]:
    """All figures; before: the score before the last edits, None where nothing moved it."""
    rows = []
    for one in FIGURES:
        moved, better = one.moved(before, whole) if before is not None else ("", 0)
        texts = one.text(whole), one.text(visible)
        rows.append(ScoreRow(tr(one.name), tr(one.hint), *texts, moved, better, tr(one.short)))
    return tuple(rows)


def awaited_rows() -> tuple[ScoreRow, ...]:
    """All figures before the first score is there: names alone, so that they keep their places."""
    return tuple(
        ScoreRow(tr(one.name), tr(one.hint), "", "", short=tr(one.short)) for one in FIGURES
    )


def hota_moved(before: Score, after: Score) -> str:
    """How HOTA moved in a few letters, e.g. "HOTA ▲ +0.012"; "" where it did not."""
    moved, _ = FIGURES[0].moved(before, after)
    return f"HOTA {moved}" if moved else ""


@dataclass(frozen=True, slots=True)
class ScoreRow:
    """A figure.

    Attributes:
        name: e.g. "HOTA". hint: what it is.
        whole, visible: its value over all frames and over those shown. moved: by how much the
            last edits moved it, with its sign; "": not at all.
        better: 1 where that is better, -1 where worse, 0 where neither.
        short: the name where there is little room; "": the same.
    """

    name: str
    hint: str
    whole: str
    visible: str
    moved: str = ""
    better: int = 0
    short: str = ""
