"""The goals, judged on fresh clips, beside the same figures on clips that are measured often."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from scipy.stats import fisher_exact

from tests.benchmarks.pages import Figures, met, table
from tests.benchmarks.stereo import words
from tests.benchmarks.stereo.clip_scores import FLOOR_M
from tests.benchmarks.stereo.clips import FRESH_ROUNDS
from tests.benchmarks.stereo.shares import said_interval
from tracking.synthesis import SCENES

ACCURACY_GOALS = {"lobby": 0.97, "plaza": 0.98, "square": 0.97, "uniforms": 0.92, "pillars": 0.90}
LEAST_DETECTED, LEAST_IDF1, MOST_ERROR_M = 0.95, 0.95, 0.10
_CHANCE = 0.05


@dataclass(frozen=True, slots=True)
class Goal:
    """What is asked of each scene.

    Attributes:
        name: in words.
        of: the figure of a scene's row.
        bound: of a scene; None: nothing is asked there.
        at_most: the bound is the greatest that is allowed, not the least.
    """

    name: str
    of: Callable[[Figures], float]
    bound: Callable[[str], float | None]
    at_most: bool = False

    def verdict(self, scene: str, row: Figures) -> str:
        """Met, or by how much it is missed; nothing where nothing is asked."""
        bound = self.bound(scene)
        if bound is None:
            return ""
        return met(self.of(row), bound, at_most=self.at_most, digits=3)


ACCURACY = Goal(
    "Tracking accuracy", lambda row: float(row["tracking_accuracy"]), ACCURACY_GOALS.get
)
BY_FLOOR = Goal(
    "Tracking accuracy by floor, counted since those by box were known",
    lambda row: float(row["by_floor"]["tracking_accuracy"]),
    ACCURACY_GOALS.get,
)
_SAME_EVERYWHERE = (
    Goal("Detected", lambda row: _detected(row), lambda _: LEAST_DETECTED),
    Goal("IDF1", lambda row: float(row["IDF1"]), lambda _: LEAST_IDF1),
    Goal("Floor error", lambda row: float(row["error_m"]), lambda _: MOST_ERROR_M, at_most=True),
)


def written(figures: Figures) -> str:
    """The section: what is met in words, both sets beside each other, verdicts, further figures."""
    fresh, often = figures["fresh"], figures["often"]
    parts = [words.GOALS.format(floor_m=FLOOR_M).strip(), *_rounds(fresh)]
    parts.append(summary(fresh, often) if fresh else words.NOT_FRESH.strip())
    parts.append(_beside(fresh, often))
    if fresh:
        parts += [_verdicts(fresh), words.FURTHER.strip(), _further(fresh)]
    return "\n\n".join(parts)


def summary(fresh: Figures, often: Figures) -> str:
    """What was reached on the fresh clips, and whether the others flatter."""
    said = (
        f"Goals are judged on the fresh clips (seeds {_seeds(fresh)}): {_kept_in_all(fresh)}. "
        f"On those measured often (seeds {_seeds(often)}) it was {_kept_in_all(often, brief=True)}"
        f"{_flatter(fresh, often)}."
    )
    reached = [_reached(goal, fresh) for goal in (ACCURACY, BY_FLOOR, *_SAME_EVERYWHERE)]
    return "\n".join([said, "", *(f"- {line}" for line in reached)])


def _rounds(rows: Figures) -> Iterator[str]:
    """Who was kept in clips that were added once others were known; nothing where none were."""
    if FRESH_ROUNDS < 2 or not rows:
        return
    names = ("kept_by_clip", "detected_by_clip")
    (before, of_before), (added, of_added) = (
        [sum(sum(half(row[name])) for row in rows.values()) for name in names]
        for half in (_first_half, _second_half)
    )
    yield (
        "Fresh clips were measured in two rounds: the second half of each scene's was added once "
        "the figures of the first were known, which were too few to tell, with nothing of the "
        f"trackers changed. {before} of {of_before} people were kept in the first round, {added} "
        f"of {of_added} in the other."
    )


def _first_half(of_clips: list[int]) -> list[int]:
    return of_clips[: len(of_clips) // 2]


def _second_half(of_clips: list[int]) -> list[int]:
    return of_clips[len(of_clips) // 2 :]


def _kept_in_all(rows: Figures, *, brief: bool = False) -> str:
    kept, people = _people(rows)
    counted = f"{kept} of {people}" + ("" if brief else " people were kept")
    return f"{counted}, {kept / max(people, 1):.3f} ({said_interval(kept, people)})"


def _people(rows: Figures) -> tuple[int, int]:
    kept, people = (
        sum(row[name] for row in rows.values()) for name in ("people_kept", "people_detected")
    )
    return kept, people


def _flatter(fresh: Figures, often: Figures) -> str:
    """Whether the same share of people may have been kept in both."""
    if not often:
        return ""
    pairs = [_people(rows) for rows in (fresh, often)]
    chance = float(fisher_exact([[kept, people - kept] for kept, people in pairs]).pvalue)
    if chance >= _CHANCE:
        return f"; the difference may be chance (Fisher's exact test, p = {chance:.2f})"
    said = "less than 0.001" if chance < 0.001 else f"{chance:.3f}"
    flatters = pairs[0][0] * pairs[1][1] < pairs[1][0] * pairs[0][1]
    why = ", so the latter flatter" if flatters else ""
    return f": more than chance explains (Fisher's exact test, p = {said}){why}"


def _seeds(rows: Figures) -> str:
    seeds = sorted({name.rpartition("-")[2] for row in rows.values() for name in row["clips"]})
    if len(seeds) < 2:
        return "".join(seeds) or "none"
    return f"{seeds[0]} {'and' if len(seeds) == 2 else 'to'} {seeds[-1]}"


def _reached(goal: Goal, rows: Figures) -> str:
    """In how many scenes a goal is met, and where it is missed."""
    asked = {scene: row for scene, row in rows.items() if goal.bound(scene) is not None}
    missed = [scene for scene, row in asked.items() if goal.verdict(scene, row) != "met"]
    number = len(asked)
    if not missed:
        return f"{goal.name}: met in {'the only scene' if number == 1 else f'all {number} scenes'}."
    count = number - len(missed)
    scenes = f"{count or 'none'} of {number} scene{'' if number == 1 else 's'}"
    where = "; ".join(
        f"{_titled(scene)} ({_figure(goal, scene, asked[scene])})" for scene in missed
    )
    return f"{goal.name}: met in {scenes}; missed in {where}."


def _figure(goal: Goal, scene: str, row: Figures) -> str:
    bound = goal.bound(scene)
    around = ""
    if goal in (ACCURACY, BY_FLOOR):
        counts = row if goal is ACCURACY else row["by_floor"]
        around = f", {said_interval(counts['people_kept'], counts['people_detected'])}"
    return f"{goal.of(row):.3f}{around}; goal {bound:g}"


def _beside(fresh: Figures, often: Figures) -> str:
    """The figures goals are about, of both sets."""
    head = (
        "scene", "kept, fresh", "kept, often", "detected, fresh", "detected, often",
        "IDF1, fresh", "IDF1, often", "error in m, fresh", "error in m, often",
    )  # fmt: skip
    rows = []
    for scene in dict.fromkeys((*fresh, *often)):
        pair = [rows_of.get(scene) for rows_of in (fresh, often)]
        cells = [_or_nothing(row, told) for told in _TOLD for row in pair]
        rows.append([_titled(scene), *cells])
    return table(head, rows)


_TOLD: Sequence[Callable[[Figures], str]] = (
    lambda row: f"{row['people_kept']} of {row['people_detected']}",
    lambda row: f"{row['visible_detected']} of {row['visible']}",
    lambda row: f"{row['IDF1']:.3f}",
    lambda row: f"{row['error_m']:.3f}",
)


def _or_nothing(row: Figures | None, told: Callable[[Figures], str]) -> str:
    return "" if row is None else told(row)


def _verdicts(fresh: Figures) -> str:
    rows = []
    for scene, row in fresh.items():
        bound = ACCURACY_GOALS.get(scene)
        goal = "" if bound is None else f"{bound:g}: {ACCURACY.verdict(scene, row)}"
        rows.append(
            [
                _titled(scene),
                f"{row['tracking_accuracy']:.3f}",
                said_interval(row["people_kept"], row["people_detected"]),
                goal,
                f"{row['by_floor']['people_kept']} of {row['by_floor']['people_detected']}",
                *(goal.verdict(scene, row) for goal in _SAME_EVERYWHERE),
            ]
        )
    head = (
        "fresh clips of", "tracking accuracy", "95 % interval", "its goal", "kept by floor",
        f"detected, {LEAST_DETECTED:g}", f"IDF1, {LEAST_IDF1:g}", f"error, {MOST_ERROR_M:.2f} m",
    )  # fmt: skip
    return table(head, rows)


def _further(fresh: Figures) -> str:
    rows = [
        [
            _titled(scene),
            *(f"{row[name]:.3f}" for name in ("MOTA", "HOTA")),
            str(row["id_switches"]),
            *(per_cent_of_truth(row, name) for name in ("misses", "false_positives")),
        ]
        for scene, row in fresh.items()
    ]
    return table(
        ("fresh clips of", "MOTA", "HOTA", "switches", "misses, %", "false alarms, %"), rows
    )


def per_cent_of_truth(row: Figures, name: str) -> str:
    """Rows of a kind, in per cent of all rows of the truth that count."""
    return f"{100 * row[name] / max(row['truth_rows'], 1):.2f}"


def _detected(row: Figures) -> float:
    return float(row["visible_detected"] / max(row["visible"], 1))


def _titled(scene: str) -> str:
    return SCENES[scene].title.lower()
