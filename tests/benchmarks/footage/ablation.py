"""What each mechanism of a tracker is worth: `python -m tests.benchmarks.footage.ablation [...]`.

Each mechanism is left out, alone, by a setting or by what stands in its place, and the tracker runs
over footage of all kinds with several seeds. What is told is by how much the scores fall, on the
mean over recordings, and an interval of 95 %: from the differences between seeds, which is how much
of it may be chance. A mechanism whose interval holds 0 is worth nothing that can be measured here.

Figures are kept in docs/results/ablation.json as they come, and docs/results/ablation.md is written
from them.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.stats import t as student

from tests.benchmarks.command import one_core, parser_of, real_data, telling
from tests.benchmarks.footage.measures import Figures, figures_of
from tests.benchmarks.footage.mechanisms import MECHANISMS, Mechanism
from tests.benchmarks.footage.recordings import Footage, all_footage
from tests.benchmarks.pages import DOCS, template
from tests.benchmarks.runner import Case, runs_over, sources

FIGURES = DOCS / "results" / "ablation.json"
PAGE = DOCS / "results" / "ablation.md"
SEEDS = (11, 12)
"""Not those of the bench."""
FRAMES = 200
"""Of each recording, from the first."""
FOOTAGE = (
    *("towncentre-real", "pets-s2l1-real", "tud-campus-real", "office-camera0-real"),
    *("rendered-corridor", "rendered-lobby", "rendered-ceiling"),
    *("own-plaza", "own-pillars", "own-corridor"),
)
WITH_ALL = "everything"
"""The row of the tracker as it is."""


def scores_of(figures: Figures) -> dict[str, float]:
    """What mechanisms are judged by: on the floor, in boxes where nothing is known of it."""
    best = figures.get("floor") or figures.get("boxes")
    if best is not None:
        return {"MOTA": best["MOTA"] or 0.0, "IDF1": best["IDF1"] or 0.0}
    walkers = figures["walkers"]
    return {"MOTA": walkers["found"] / walkers["of"], "IDF1": walkers["found"] / walkers["of"]}


@dataclass(frozen=True, slots=True)
class Worth:
    """By how much scores fall without a mechanism.

    Attributes:
        mean: over recordings and seeds.
        error: half the length of an interval of 95 % of the mean.
    """

    mean: float
    error: float

    @property
    def is_sure(self) -> bool:
        """Whether chance does not explain it."""
        return abs(self.mean) > self.error


def worth_of(with_all: Sequence[Sequence[float]], without: Sequence[Sequence[float]]) -> Worth:
    """The worth of a mechanism by scores (recordings, seeds) with it and without.

    The variance of each recording's mean difference follows from its seeds, pooled over
    recordings.
    """
    fall = np.asarray(with_all, float) - np.asarray(without, float)
    recordings, seeds = fall.shape
    if seeds < 2:
        return Worth(float(fall.mean()), float("inf"))
    freedom = recordings * (seeds - 1)
    variance = fall.var(axis=1, ddof=1).mean() / (recordings * seeds)
    return Worth(float(fall.mean()), float(student.ppf(0.975, freedom) * np.sqrt(variance)))


def measure(
    tracker: str, mechanism: Mechanism | None, footage: Sequence[Footage], asked: Any
) -> dict[str, list[dict[str, float]]]:
    """Scores by recording, one a seed."""
    found: dict[str, list[dict[str, float]]] = {}
    for recording in footage:
        cases = [_case(tracker, mechanism, seed, asked.frames) for seed in asked.seeds]
        runs = [runs_over(recording.folder, [case])[case] for case in cases]
        found[recording.name] = [scores_of(figures_of(recording, run)) for run in runs]
    return found


def _case(tracker: str, mechanism: Mechanism | None, seed: int, frames: int) -> Case:
    if mechanism is None:
        return Case(tracker, seed=seed, frames=frames)
    return Case(tracker, mechanism.settings, "", seed, frames, mechanism.replaced)


def rows_of(figures: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Of each mechanism measured with the tracker as it is: its worth by kind of footage."""
    for name, its in figures.items():
        whole = its.get(WITH_ALL)
        for mechanism in MECHANISMS.get(name, ()):
            if whole is None or mechanism.name not in its:
                continue
            row = {"tracker": name, "name": mechanism.name, "what": mechanism.what}
            for score in ("MOTA", "IDF1"):
                for kind, chosen in _KINDS.items():
                    rows = [r for r in its[mechanism.name] if r in whole and r.startswith(chosen)]
                    old, new = (
                        [[one[score] for one in which[r]] for r in rows]
                        for which in (whole, its[mechanism.name])
                    )
                    row[f"{score} {kind}"] = worth_of(old, new) if rows else None
            yield row


_KINDS: Mapping[str, tuple[str, ...]] = {
    "all": ("",),
    "real": ("town", "pets", "tud", "office", "overhead"),
    "other": ("rendered-",),
    "own": ("own-",),
}
"""Beginnings of the names of recordings of a kind."""


def figures() -> dict[str, Any]:
    """What has been measured."""
    if not FIGURES.is_file():
        return {}
    return dict(json.loads(FIGURES.read_text(encoding="utf-8")))


def _keep(tracker: str, name: str, found: Any) -> None:
    kept = figures()
    kept.setdefault(tracker, {})[name] = found
    kept["sources"] = {**kept.get("sources", {}), tracker: sources()[:16]}
    FIGURES.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


def write_page() -> None:
    """Write the page from what was measured."""
    rows = list(rows_of({k: v for k, v in figures().items() if k != "sources"}))
    asked = {"seeds": SEEDS, "frames": FRAMES, "footage": FOOTAGE}
    PAGE.write_text(template("footage/ablation.md.j2").render(rows=rows, **asked), encoding="utf-8")


def _line(row: Mapping[str, Any]) -> str:
    cells = []
    for name, worth in row.items():
        if isinstance(worth, Worth):
            mark = "" if worth.is_sure else "?"
            cells.append(f"{name} {worth.mean:+.3f} ± {worth.error:.3f}{mark}")
    return f"{row['tracker']}: {row['name']}\n    " + "  ".join(cells)


def _options() -> argparse.Namespace:
    parser = parser_of("footage.ablation", __doc__)
    parser.add_argument("--tracker", choices=MECHANISMS, required=True)
    parser.add_argument("--only", nargs="+", metavar="MECHANISM", help="these, by their names")
    parser.add_argument("--footage", nargs="+", default=FOOTAGE, metavar="NAME")
    parser.add_argument("--seeds", nargs="+", type=int, default=SEEDS)
    parser.add_argument("--frames", type=int, default=FRAMES)
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    parser.add_argument("--report", action="store_true", help="keep the figures, write the page")
    parser.add_argument("--rewrite", action="store_true", help="only write the page")
    return parser.parse_args()


def main() -> None:
    """Read the command line, measure, print or keep."""
    one_core()
    asked = _options()
    if asked.rewrite:
        write_page()
        return
    there = [o for o in all_footage(asked.data, asked.footage) if o.suits(asked.tracker)]
    known = MECHANISMS[asked.tracker]
    chosen = [m for m in known if not asked.only or m.name in asked.only]
    found = {}
    for mechanism in (None, *chosen):
        name = WITH_ALL if mechanism is None else mechanism.name
        with telling(f"{asked.tracker} without {name}" if mechanism else asked.tracker):
            found[name] = measure(asked.tracker, mechanism, there, asked)
        if asked.report:
            _keep(asked.tracker, name, found[name])
        if mechanism is not None:
            both = {WITH_ALL: found[WITH_ALL], name: found[name]}
            print(*map(_line, rows_of({asked.tracker: both})), sep="\n", flush=True)
    if asked.report:
        write_page()


if __name__ == "__main__":
    main()
