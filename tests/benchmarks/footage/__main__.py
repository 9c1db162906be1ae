"""All trackers over all footage: `python -m tests.benchmarks.footage [--only NAME ...] ...`.

One table: real recordings first, then those that another program rendered, then our own scenes.
Beside each figure stands what changed since the run that was kept last (`--keep` keeps this one,
in docs/results/real.json, and writes docs/results/real.md from it).
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.command import one_core, parser_of, real_data
from tests.benchmarks.footage.measures import Figures, figures_of
from tests.benchmarks.footage.recordings import Footage, all_footage, footage_names
from tests.benchmarks.footage.table import changes, table
from tests.benchmarks.pages import DOCS, template
from tests.benchmarks.runner import Case, runs_over, sources
from tracking.trackers import TRACKERS

KEPT = DOCS / "results" / "real.json"
PAGE = DOCS / "results" / "real.md"


def measure(footage: Footage, cases: Sequence[Case]) -> dict[str, Figures]:
    """Figures by the names of the cases whose trackers fit the recording."""
    fitting = [case for case in cases if footage.suits(case.tracker)]
    runs = runs_over(footage.folder, fitting)
    return {str(case): figures_of(footage, runs[case]) for case in fitting}


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
    PAGE.write_text(template("footage/page.md.j2").render(**figures), encoding="utf-8")


def _options() -> argparse.Namespace:
    parser = parser_of("footage", __doc__)
    parser.add_argument("--only", nargs="+", choices=footage_names(), metavar="NAME")
    parser.add_argument("--trackers", nargs="+", choices=TRACKERS, default=tuple(TRACKERS))
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--frames", type=int, default=0, help="the first ones only")
    parser.add_argument("--seed", type=int, default=0, help="of the trackers' randomness")
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    parser.add_argument("--json", action="store_true", help="figures as JSON, not as a table")
    parser.add_argument("--keep", action="store_true", help=f"in {PAGE.parent.name}/{PAGE.name}")
    return parser.parse_args()


def main() -> None:
    """Read the command line, measure, print, and keep what is asked to be kept."""
    one_core()
    asked = _options()
    settings = tuple(tuple(text.split("=", 1)) for text in asked.set)
    cases = [Case(name, settings, "", asked.seed, asked.frames) for name in asked.trackers]
    found: dict[str, dict[str, Figures]] = {}
    kinds: dict[str, str] = {}
    before = kept_figures().get("footage", {})
    for footage in all_footage(asked.data, asked.clips):
        if asked.only and footage.name not in asked.only:
            continue
        kinds[footage.name] = footage.kind
        found[footage.name] = measure(footage, cases)
        if not asked.json:
            print(
                table(footage.name, found[footage.name], before.get(footage.name, {})), flush=True
            )
    if asked.json:
        print(json.dumps(found, indent=1))
    else:
        print(changes(found, before))
    if asked.keep:
        keep(found, kinds)


if __name__ == "__main__":
    main()
