"""All trackers over all footage: `python -m tests.benchmarks.footage [--only NAME ...] ...`.

One table: real recordings first, then those that another program rendered, then our own scenes.
Beside each figure stands what changed since the run that was kept last (`--keep` keeps this one,
in docs/results/real.json, and writes docs/results/real.md from it).
"""

from __future__ import annotations

import argparse
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from tests.benchmarks.command import one_core, parser_of, real_data
from tests.benchmarks.footage.failures import save_worst_frame
from tests.benchmarks.footage.measures import Figures, figures_of
from tests.benchmarks.footage.others import (
    follow_public_detections,
    has_detections,
    with_detections,
)
from tests.benchmarks.footage.recordings import Footage, all_footage, footage_names
from tests.benchmarks.footage.table import COLUMNS, cells, changes, table
from tests.benchmarks.pages import DOCS, template
from tests.benchmarks.runner import Case, runs_over, sources
from tracking.trackers import TRACKERS

KEPT = DOCS / "results" / "real.json"
PAGE = DOCS / "results" / "real.md"
_SEEDS = 5
"""Of a short recording, on which chance makes or loses one person for good: one run of
`whole-body` scores anything from 0.01 to 0.28 on `tud-campus-real`."""


def measure(
    footage: Footage, cases: Sequence[Case], pictures: Path | None = None
) -> dict[str, Figures]:
    """Figures by the names of the cases whose trackers fit the recording.

    Args:
        pictures: where a picture is put of the frame in which each tracker errs most.
    """
    fitting = [case for case in cases if footage.suits(case.tracker)]
    seeds = _SEEDS if footage.is_short else 1
    repeated = {
        case: [replace(case, seed=case.seed + more) for more in range(seeds)] for case in fitting
    }
    runs = runs_over(footage.folder, [one for several in repeated.values() for one in several])
    if pictures is not None:
        for case in fitting:
            save_worst_frame(footage, str(case), runs[case].tracks, pictures)
    return {
        str(case): middle_of([figures_of(footage, runs[one]) for one in several])
        for case, several in repeated.items()
    }


def middle_of(several: Sequence[Figures]) -> Figures:
    """The figures in the middle, by MOTA of boxes; of an even number the lower ones."""
    worth = [each["boxes"]["MOTA"] if "boxes" in each else 0.0 for each in several]
    order = sorted(range(len(several)), key=lambda number: worth[number])
    return several[order[(len(several) - 1) // 2]]


def kept_figures() -> dict[str, Any]:
    """Those of the run that was kept last."""
    return dict(json.loads(KEPT.read_text(encoding="utf-8"))) if KEPT.is_file() else {}


def keep(found: Mapping[str, Mapping[str, Figures]], kinds: Mapping[str, str]) -> None:
    """Put these figures in the place of older ones, and write the page of all."""
    kept = kept_figures()
    rows = {name: dict(kept.get("footage", {}).get(name, {})) for name in footage_names()}
    for name, of_trackers in found.items():
        rows[name] |= of_trackers
    kinds = {**kept.get("kinds", {}), **kinds}
    figures = {"sources": sources()[:16], "kinds": kinds, "footage": rows}
    KEPT.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    write_page(figures)


def write_page(figures: Mapping[str, Any]) -> None:
    """The page of the figures kept."""
    text = template("footage/page.md.j2").render(**figures, columns=tuple(COLUMNS), cells=cells)
    PAGE.write_text(re.sub(r"\n{3,}", "\n\n", text).strip() + "\n", encoding="utf-8")


def _options() -> argparse.Namespace:
    parser = parser_of("footage", __doc__)
    parser.add_argument("--only", nargs="+", choices=footage_names(), metavar="NAME")
    parser.add_argument("--trackers", nargs="+", choices=TRACKERS, default=tuple(TRACKERS))
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--frames", type=int, default=0, help="the first ones only")
    parser.add_argument("--seed", type=int, default=0, help="of the trackers' randomness")
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    parser.add_argument("--pictures", type=Path, help="where frames with most errors are put")
    parser.add_argument(
        "--others", action="store_true", help="also on public detections, others and ours"
    )
    parser.add_argument("--rewrite", action="store_true", help="only write the page anew")
    parser.add_argument("--json", action="store_true", help="figures as JSON, not as a table")
    parser.add_argument("--keep", action="store_true", help=f"in {PAGE.parent.name}/{PAGE.name}")
    return parser.parse_args()


def main() -> None:
    """Read the command line, measure, print, and keep what is asked to be kept."""
    one_core()
    asked = _options()
    if asked.rewrite:
        write_page(kept_figures())
        return
    settings = tuple(tuple(text.split("=", 1)) for text in asked.set)
    cases = [Case(name, settings, "", asked.seed, asked.frames) for name in asked.trackers]
    chosen = all_footage(asked.data, asked.only, asked.clips)
    before = kept_figures().get("footage", {})
    found: dict[str, dict[str, Figures]] = follow_public_detections(chosen) if asked.others else {}
    for footage in chosen:
        given = with_detections(cases) if asked.others and has_detections(footage) else []
        ours = measure(footage, [*cases, *given], asked.pictures)
        found[footage.name] = ours | found.get(footage.name, {})
        if not asked.json:
            old = before.get(footage.name, {})
            print(table(footage.name, found[footage.name], old), flush=True)
    print(json.dumps(found, indent=1) if asked.json else changes(found, before))
    if asked.keep:
        keep(found, {footage.name: footage.kind for footage in chosen})


if __name__ == "__main__":
    main()
