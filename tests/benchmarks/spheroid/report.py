"""docs/results/spheroid.md, written from the figures that were measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from tests.benchmarks.pages import Figures, met, table
from tests.benchmarks.spheroid import words
from tests.benchmarks.spheroid.ghosts import LONGEST_S
from tests.benchmarks.spheroid.recordings import RADIUS_M
from tracking.synthesis.marks import MARKS_M

ALONE_PAPER = dict(zip(MARKS_M, (5, 11, 8, 13, 7, 8, 10, 10, 5, 10), strict=True))
PAIRS_PAPER = dict(zip(MARKS_M, (8, 16, 8, 31, 13, 8, 26, 5, 18, 5), strict=True))
WALK_PAPER = (10, 7, 15, 7, 7, 11, 5, 9, 4)
GOALS_CM = {"standing": 5.0, "walking": 5.0, "pairs": 8.0}
LEAST_FOLLOWED = 95.0
"""Per cent of the frames: an error of fewer says nothing of those who are lost."""

GOALS_REAL = {"MOTA": 0.85, "IDF1": 0.80}
MOST_MS, LEAST_FPS = 3.0, 60.0
EASY = 3
"""Situations rated up to this may not swap anybody (the goal)."""


def writers() -> Mapping[str, Callable[[Any], str]]:
    """A writer for each section, in the page's order."""
    return {
        "marks": _marks,
        "situations": _situations,
        "real": _real,
        "places": _places,
        "robustness": _robustness,
        "speed": _speed,
    }


def _marks(figures: Figures) -> str:
    return "\n\n".join(
        (
            words.MARKS.format(clips=figures["clips"]).strip(),
            _spots(figures),
            _goals(figures),
            words.WALKING.strip(),
            _lines(figures["walking"]),
        )
    )


def _spots(figures: Figures) -> str:
    alone, pairs = figures["standing"], figures["pairs"]
    rows = [
        [
            mark,
            str(ALONE_PAPER[mark]),
            *_error(alone.get(mark)),
            str(PAIRS_PAPER[mark]),
            *_error(pairs.get(mark)),
        ]
        for mark in MARKS_M
    ]
    rows.append(["all", "9 ± 4", *_error(alone["all"]), "15 ± 9, 12 ± 9", *_error(pairs["all"])])
    head = (
        "mark, cm", "alone: paper", "ours", "followed", "in pairs: paper", "ours", "followed",
    )  # fmt: skip
    return table(head, rows)


def _error(told: Figures | None) -> tuple[str, str]:
    if told is None or told["mean_cm"] is None:
        return "-", "0 %"
    return f"{told['mean_cm']:.1f} ± {told['std_cm']:.1f}", f"{100 * told['followed']:.0f} %"


def _goals(figures: Figures) -> str:
    rows = []
    for name, goal in GOALS_CM.items():
        told = figures[name]["all"]
        ours, share = told["mean_cm"], 100 * told["followed"]
        verdict = "missed" if ours is None else met(ours, goal, at_most=True)
        if verdict == "met" and share < LEAST_FOLLOWED:
            verdict = "missed: people are lost"
        rows.append([name, f"{goal:g}", _cm(ours), f"{share:.0f} %", verdict])
    return table(("mean error, cm", "goal", "ours", "followed", ""), rows)


def _lines(walks: Figures) -> str:
    names = [name for name in walks if name != "all"]
    rows = [
        [name, str(paper), _cm(walks[name]["across_cm"]), *_error(walks[name])]
        for name, paper in zip(names, WALK_PAPER, strict=False)
    ]
    rows.append(["all", "8 ± 7", "", *_error(walks["all"])])
    return table(("line, cm", "across: paper", "ours", "error", "followed"), rows)


def _cm(value: float | None) -> str:
    return "-" if value is None else f"{value:.1f}"


def _situations(rows: Sequence[Figures]) -> str:
    cells = [
        [
            row["title"],
            str(row["difficulty"]),
            str(row["people"]),
            *(str(row[name]) for name in ("swapped", "renamed", "missed")),
        ]
        for row in _added(rows)
    ]
    easy = sum(row["swapped"] for row in rows if row["difficulty"] <= EASY)
    said = "nobody" if not easy else f"{easy} tracks"
    head = ("situation", "difficulty", "people", "swapped", "renamed", "missed")
    goal = f"Goal, no swap in those rated up to {EASY}: {said} swapped there."
    return "\n\n".join((words.SITUATIONS.strip(), table(head, cells), goal, words.PICTURE.strip()))


def _added(rows: Sequence[Figures]) -> list[dict[str, Any]]:
    """The rows of one situation with several seeds as one."""
    added: dict[str, dict[str, Any]] = {}
    for row in rows:
        sums = added.setdefault(row["scene"], {**row, "people": 0, **dict.fromkeys(_COUNTED, 0)})
        for name in ("people", *_COUNTED):
            sums[name] += row[name]
    return list(added.values())


_COUNTED = ("swapped", "renamed", "missed")


def _places(figures: Figures) -> str:
    text = words.PLACES.format(seconds=figures["seconds"], radius=RADIUS_M)
    return text.strip() + "\n\n" + scores_table(figures["rows"])


def _real(rows: Sequence[Figures]) -> str:
    parts = [words.REAL.format(radius=RADIUS_M).strip(), scores_table(rows)]
    ours = next((row for row in rows if row["tracker"] == "spheroid" and "MOTA" in row), None)
    if ours is not None:
        goals = [
            [name, f"{goal:.2f}", f"{ours[name]:.3f}", met(ours[name], goal, digits=3)]
            for name, goal in GOALS_REAL.items()
        ]
        parts.append(table(("spheroid", "goal", "ours", ""), goals))
    return "\n\n".join(parts)


def scores_table(rows: Sequence[Figures]) -> str:
    """A line a recording and tracker."""
    head = ("recording", "tracker", "MOTA", "IDF1", "HOTA", "switches", "people kept", "error, cm")
    return table(head, [[row["recording"], row["tracker"], *_score(row)] for row in rows])


def _score(row: Figures) -> list[str]:
    if "MOTA" not in row:
        return ["says no floor positions", "", "", "", "", ""]
    return [
        *(f"{row[name]:.3f}" for name in ("MOTA", "IDF1", "HOTA")),
        str(row["id_switches"]),
        f"{row['kept']} of {row['detected']}",
        f"{row['error_cm']:.1f}",
    ]


def _robustness(figures: Figures) -> str:
    clips = [(kind, row) for kind, several in figures.items() for row in several]
    rows = [
        [
            kind,
            row["recording"],
            *(f"{row[name]:.3f}" for name in ("MOTA", "IDF1")),
            str(row["ghosts"]),
            f"{row['longest_s']:.1f}",
        ]
        for kind, row in clips
    ]
    head = ("what", "clip", "MOTA", "IDF1", f"ghosts over {LONGEST_S:g} s", "longest alone, s")
    said = [f"- {row['recording']}: {note}" for _, row in clips for note in row["notes"]]
    parts = [words.ROBUSTNESS.format(longest=LONGEST_S).strip(), table(head, rows)]
    parts.append("What users are told:\n\n" + ("\n".join(said) or "- nothing"))
    return "\n\n".join(parts)


def _speed(figures: Figures) -> str:
    rows = [[name, "-" if value is None else f"{value:.2f}"] for name, value in figures.items()]
    likely_ms, fps = figures["likelihoods_ms_10"], figures["fps"]
    goals = [
        ["likelihoods of ten people, ms", f"{MOST_MS:g}", f"{likely_ms:.2f}"],
        ["frames a second with ten people", f"{LEAST_FPS:g}", f"{fps:.0f}"],
    ]
    goals[0].append(met(likely_ms, MOST_MS, at_most=True, digits=2))
    goals[1].append(met(fps, LEAST_FPS, digits=0))
    parts = (
        words.SPEED.strip(),
        table(("figure", ""), rows),
        table(("", "goal", "ours", ""), goals),
    )
    return "\n\n".join(parts)
