"""The measures of a report: by group, each with its meaning in a sentence."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from tracking.scoring.conventions import Conventions
from tracking.scoring.report.meanings import MEANINGS, MOTMETRICS
from tracking.scoring.score import FIGURES, Score
from tracking.translation import msg

Better = Literal["higher", "lower"]
Form = Literal["share", "count", "metres"]


@dataclass(frozen=True, slots=True)
class Measure:
    """One number of a score.

    Attributes:
        name: as the field writes it. group: what it is about.
        says: its meaning, a sentence.
        better: which of two is better; None where it is no merit.
        form: how it is written.
        value: of a score; NaN where it is undefined.
        main: stands in the tables that show a few measures only.
    """

    name: str
    group: str
    says: str
    better: Better | None
    form: Form
    value: Callable[[Score], float]
    main: bool

    def shown(self, score: Score) -> str:
        """The number as written."""
        return written(self.value(score), self.form)

    def difference(self, score: Score, first: Score) -> str:
        """How far it is from another score's, with its sign; nothing where nobody can say."""
        apart = self.value(score) - self.value(first)
        if not math.isfinite(apart):
            return ""
        size = written(abs(apart), self.form)
        same = size == written(0.0, self.form)
        return f"{'±' if same else '−' if apart < 0 else '+'}{size}"

    def best(self, scores: Sequence[Score]) -> frozenset[int]:
        """Which of several scores are best, as far as can be read; none where all are alike."""
        known = [score for score in scores if math.isfinite(self.value(score))]
        if self.better is None or len({self.shown(score) for score in scores}) < 2 or not known:
            return frozenset()
        top = (max if self.better == "higher" else min)(known, key=self.value)
        shown = self.shown(top)
        return frozenset(n for n, score in enumerate(scores) if self.shown(score) == shown)


def written(value: float, form: Form) -> str:
    """A number as tables have it; a dash where it is undefined."""
    if not math.isfinite(value):
        return "–"
    return f"{round(value):,}" if form == "count" else f"{value:.3f}"


def finite(value: float) -> float | None:
    """The number for JSON, which has no NaN."""
    return value if math.isfinite(value) else None


_ERRORS: Mapping[str, Callable[[Score], float]] = {
    "position error, mean (m)": lambda s: s.position_error.mean,
    "position error, std (m)": lambda s: s.position_error.std,
    "position error, median (m)": lambda s: s.position_error.median,
    "position error, p95 (m)": lambda s: s.position_error.p95,
    "AP of tracks": lambda s: s.track_map.ap if s.track_map else math.nan,
    "AR of tracks": lambda s: s.track_map.ar if s.track_map else math.nan,
}
_TITLES = {
    "id_switches": "switches",
    "false_positives": "false alarms",
    "false_positives_per_frame": "false alarms a frame",
    "people_detected": "people detected",
    "people_kept": "people kept",
    "tracking_accuracy": "tracking accuracy",
    "mostly_tracked": "mostly tracked",
    "partly_tracked": "partly tracked",
    "mostly_lost": "mostly lost",
    "truth_people": "people in the ground truth",
    "truth_rows": "rows of the ground truth",
    "result_tracks": "tracks in the result",
    "result_rows": "rows of the result",
}
_MAIN = frozenset(
    (
        "HOTA", "DetA", "AssA", "LocA", "MOTA", "IDF1", "misses", "false_positives", "id_switches",
        "people_kept", "tracking_accuracy", "position error, mean (m)",
    )
)  # fmt: skip


def _measures() -> tuple[Measure, ...]:
    values = {**FIGURES, **_ERRORS}
    return tuple(
        Measure(
            name=msg(_TITLES.get(key, key)),
            group=msg(group),
            says=msg(meaning.says),
            better=meaning.better,
            form=meaning.form,
            value=values[key],
            main=key in _MAIN,
        )
        for group, members in MEANINGS.items()
        for key, meaning in members.items()
    )


ALL = _measures()
"""In the order of their groups."""


def measures_by(conventions: Conventions, scores: Sequence[Score]) -> tuple[Measure, ...]:
    """The measures that at least one of some scores has a value of, by group."""
    known = [each for each in ALL if any(math.isfinite(each.value(score)) for score in scores)]
    if conventions is not Conventions.MOTMETRICS:
        return tuple(known)
    return tuple(
        replace(each, says=msg(MOTMETRICS[each.name].says), better=MOTMETRICS[each.name].better)
        if each.name in MOTMETRICS
        else each
        for each in known
    )


def by_group(measures: Sequence[Measure]) -> dict[str, list[Measure]]:
    """Measures under the names of their groups, in order."""
    groups: dict[str, list[Measure]] = {}
    for measure in measures:
        groups.setdefault(measure.group, []).append(measure)
    return groups
