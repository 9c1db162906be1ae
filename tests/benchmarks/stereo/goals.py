"""The goals of the stereo trackers, judged on fresh clips, and what of them is said in words."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from tests.benchmarks.intervals import interval_text, same_share
from tests.benchmarks.pages import Figures, titled
from tests.benchmarks.tables import met

ACCURACY_GOALS = {"lobby": 0.97, "plaza": 0.98, "square": 0.97, "uniforms": 0.92, "pillars": 0.90}
_CHANCE = 0.05


@dataclass(frozen=True, slots=True)
class Goal:
    """What is asked of each scene.

    Attributes:
        name: in words.
        of: the figure of a scene's row.
        bound: of a scene; None: nothing is asked there.
        at_most: the bound is the greatest that is allowed, not the least.
        counts: what of a row holds the people the figure is a share of; "": the row; None: nobody.
    """

    name: str
    of: Callable[[Figures], float]
    bound: Callable[[str], float | None]
    at_most: bool = False
    counts: str | None = None

    def verdict(self, scene: str, row: Figures) -> str:
        """Met, or by how much it is missed; nothing where nothing is asked."""
        bound = self.bound(scene)
        if bound is None:
            return ""
        return met(self.of(row), bound, at_most=self.at_most, digits=3)

    def reached(self, rows: Figures) -> str:
        """In how many scenes it is met, and where it is missed."""
        asked = {scene: row for scene, row in rows.items() if self.bound(scene) is not None}
        missed = [scene for scene, row in asked.items() if self.verdict(scene, row) != "met"]
        number = len(asked)
        if not missed:
            every = "the only scene" if number == 1 else f"all {number} scenes"
            return f"{self.name}: met in {every}."
        of = f"{number - len(missed) or 'none'} of {number} scene{'' if number == 1 else 's'}"
        where = "; ".join(
            f"{titled(scene)} ({self._figure(scene, rows[scene])})" for scene in missed
        )
        return f"{self.name}: met in {of}; missed in {where}."

    def _figure(self, scene: str, row: Figures) -> str:
        around = ""
        if self.counts is not None:
            counted = row[self.counts] if self.counts else row
            around = f", {interval_text(counted['people_kept'], counted['people_detected'])}"
        return f"{self.of(row):.3f}{around}; goal {self.bound(scene):g}"


ACCURACY = Goal(
    "Tracking accuracy", lambda row: float(row["tracking_accuracy"]), ACCURACY_GOALS.get, counts=""
)
BY_FLOOR = Goal(
    "Tracking accuracy by floor, counted since those by box were known",
    lambda row: float(row["by_floor"]["tracking_accuracy"]),
    ACCURACY_GOALS.get,
    counts="by_floor",
)
EVERYWHERE = (
    Goal("Detected", lambda r: r["visible_detected"] / max(r["visible"], 1), lambda _: 0.95),
    Goal("IDF1", lambda row: float(row["IDF1"]), lambda _: 0.95),
    Goal("Floor error", lambda row: float(row["error_m"]), lambda _: 0.10, at_most=True),
)
GOALS = (ACCURACY, BY_FLOOR, *EVERYWHERE)


def people(rows: Mapping[str, Any]) -> tuple[int, int]:
    """How many of all scenes are kept, and how many are detected."""
    kept, of = (
        sum(row[name] for row in rows.values()) for name in ("people_kept", "people_detected")
    )
    return kept, of


def rounds(fresh: Figures) -> tuple[tuple[int, int], ...]:
    """The same of the first half of each scene's clips, and of those added later."""
    halves = (lambda of_clips: of_clips[: len(of_clips) // 2]), (lambda of: of[len(of) // 2 :])
    return tuple(
        tuple(
            sum(sum(half(row[name])) for row in fresh.values())
            for name in ("kept_by_clip", "detected_by_clip")
        )
        for half in halves
    )


def flatter(fresh: Figures, often: Figures) -> str:
    """Whether the same share of people may have been kept in both."""
    if not often:
        return ""
    new, old = people(fresh), people(often)
    chance = same_share(new, old)
    if chance >= _CHANCE:
        return f"; the difference may be chance (Fisher's exact test, p = {chance:.2f})"
    said = "less than 0.001" if chance < 0.001 else f"{chance:.3f}"
    why = ", so the latter flatter" if new[0] * old[1] < old[0] * new[1] else ""
    return f": more than chance explains (Fisher's exact test, p = {said}){why}"


def seeds_of(clips: Iterable[str]) -> str:
    """From which seed to which some clips are, by their names."""
    seeds = sorted({name.rpartition("-")[2] for name in clips})
    if len(seeds) < 2:
        return "".join(seeds) or "none"
    return f"{seeds[0]} {'and' if len(seeds) == 2 else 'to'} {seeds[-1]}"


def of_truth(row: Figures, name: str) -> str:
    """Rows of a kind, in per cent of all rows of the truth that count."""
    return f"{100 * row[name] / max(row['truth_rows'], 1):.2f}"


def advice(rows: Figures) -> str:
    """Which tracker to take when, by what each is best at."""
    best = {
        when: (min if least else max)(rows, key=lambda name, of=of: of(rows[name]))
        for when, of, _, least in _USES
    }
    reasons = {when: _reason(rows, best[when], text) for when, _, text, _ in _USES}
    if len(set(best.values())) == 1:
        (name,) = set(best.values())
        return f"Take `{name}`: it is ahead in everything ({'; '.join(reasons.values())})."
    parts = []
    for one in dict.fromkeys(best.values()):
        uses = [f"{when} ({reasons[when]})" for when, name in best.items() if name == one]
        parts.append(f"`{one}` {' and '.join(uses)}")
    return f"Take {', '.join(parts[:-1])}, and {parts[-1]}."


_USES: tuple[tuple[str, Callable[[Figures], float], tuple[str, str], bool], ...] = (
    (
        "where everybody must keep one id",
        lambda row: row["people_kept"] / max(row["people_detected"], 1),
        ("{people_kept} of {people_detected} kept", "{people_kept}"),
        False,
    ),
    (
        "where every box counts and ids do not",
        lambda row: float(row["MOTA"]),
        ("MOTA {MOTA:.3f}", "{MOTA:.3f}"),
        False,
    ),
    (
        "where time is short",
        lambda row: float(row["following_ms"]),
        ("{following_ms:.2f} ms a frame", "{following_ms:.2f}"),
        True,
    ),
)
"""When; by which figure; how it is told of the best and of the others; whether least is best."""


def _reason(rows: Figures, best: str, texts: tuple[str, str]) -> str:
    others = [f"{name} {texts[1].format(**rows[name])}" for name in rows if name != best]
    return ", ".join([texts[0].format(**rows[best]), *others])
