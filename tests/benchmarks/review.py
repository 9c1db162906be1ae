"""How much of the footage has to be watched: `python -m tests.benchmarks.review`.

Renders and tracks scenes that nothing was fitted on, as they are and with tracks swapped on
purpose, and walks the review items in the order that finds most for the time watched. Beside it
stands what a queue would find that knows the errors and shows each for half a second, always next
what shows most: about the best there is, not a bound. `--fresh` reports on scenes that nothing was
chosen by, `--each` has a line for each place as well, `--fit` fits hazards and likelihoods anew on
other scenes, `--match box` takes errors by boxes instead of floor distance. What is rendered and
tracked stays in the temporary folder; the first time takes an hour.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence

import cv2
import numpy as np

from tests.benchmarks.review_cases import FRESH, REPORTED, TUNING, Case, cases, is_calm
from tests.benchmarks.review_fit import fit
from tracking.review import ReviewMeasures, find_review_items, rank, review_measures
from tracking.scoring import BoxMatch, FloorMatch

FOOTAGE = 0.05
RECALL = 0.95
_AROUND_S = 0.25
_BEFORE_S, _AFTER_S = 0.15, 0.4
"""What a queue that knows the errors shows of one."""
_COLUMNS = (
    "scenes",
    "results",
    "errors",
    "found in 5 % of the footage",
    "at best",
    "a minute watched",
    "footage for 95 %",
    "person-time watched then",
    "found by all review items",
    "the errors' own moments",
)


def main() -> None:
    """Print a Markdown table."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.review", description=__doc__)
    parser.add_argument("--fit", action="store_true", help="fit the likelihoods anew")
    parser.add_argument("--tuning", action="store_true", help="report on the scenes for fitting")
    parser.add_argument(
        "--fresh", action="store_true", help="report on scenes nothing was chosen by"
    )
    parser.add_argument("--each", action="store_true", help="a line for each place as well")
    parser.add_argument("--match", choices=("floor", "box"), default="floor")
    parser.add_argument("--order", choices=("yield", "worth", "likelihood"), default="yield")
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    match = FloorMatch(0.5) if asked.match == "floor" else BoxMatch(0.5)
    scenes = TUNING if asked.fit or asked.tuning else FRESH if asked.fresh else REPORTED
    found = list(cases(scenes, match))
    if asked.fit:
        fit(found)
        return
    print("|", " | ".join(_COLUMNS), "|")
    print("|", " | ".join("---" for _ in _COLUMNS), "|")
    for name, group in _groups(found, asked.each):
        print(_row(name, group, asked.order), flush=True)


def _groups(found: Sequence[Case], each: bool) -> Iterator[tuple[str, Sequence[Case]]]:
    """Results with errors that are told in a line, with its name; each: a line for each place."""
    for calm in (True, False):
        for swapped in (False, True):
            group = [
                case
                for case in found
                if case.errors and is_calm(case.clip) == calm and bool(case.swaps) == swapped
            ]
            name = f"{'calm' if calm else 'crowded'}, {'swapped' if swapped else 'as tracked'}"
            if group:
                yield name, group
            for scene in sorted({case.clip.scene for case in group}) if each else ():
                yield f"{name}, {scene}", [case for case in group if case.clip.scene == scene]


def _row(name: str, group: Sequence[Case], order: str) -> str:
    """A line of the table; figures of all results pooled, medians over results."""
    measured = [_measured(case, order) for case in group]
    errors = sum(each.errors for each in measured)
    found = sum(each.found_within(FOOTAGE) for each in measured)
    watched = sum(min(FOOTAGE, float(each.footage[-1])) * each.minutes for each in measured)
    every = sum(int(each.found[-1]) for each in measured)
    best = sum(_found_at_best(case) for case in group)
    own = float(np.mean([_own_moments(case) for case in group]))
    cells = (
        f"{len(group)}",
        f"{errors}",
        f"{found / errors:.1%}",
        f"{best / errors:.1%}",
        f"{found / watched:.1f}",
        *_enough(measured, errors),
        f"{every / errors:.1%}",
        f"{own:.1%}",
    )
    return f"| {name} | {' | '.join(cells)} |"


def _measured(case: Case, order: str) -> ReviewMeasures:
    found = find_review_items(case.table, case.run, case.fps, view=case.view)
    review_items = rank(found, order)
    return review_measures(review_items, case.errors, case.table, case.frames, case.fps)


def _enough(measured: Sequence[ReviewMeasures], errors: int) -> tuple[str, str]:
    """The least share of every result's footage that shows enough of all errors; people's too."""
    for footage in np.arange(1, 101) / 100:
        if sum(each.found_within(footage) for each in measured) >= RECALL * errors:
            people = [each.people_within(footage) for each in measured]
            return f"{footage:.0%}", f"{np.mean(people):.1%}"
    return "never", "-"


def _found_at_best(case: Case) -> int:
    """Errors a queue finds in 5 % that knows them all: always next what shows most a frame."""
    before, after = round(_BEFORE_S * case.fps), round(_AFTER_S * case.fps) + 1
    left = Counter(error.frame for error in case.errors)
    seen = np.zeros(case.frames, bool)
    while left:
        yields = {
            frame: count
            / max(1e-3, np.count_nonzero(~seen[max(0, frame - before) : frame + after]))
            for frame, count in left.items()
        }
        frame = max(yields, key=lambda one: yields[one])
        seen[max(0, frame - before) : frame + after] = True
        if seen.mean() > FOOTAGE:
            break
        left = Counter({frame: count for frame, count in left.items() if not seen[frame]})
    return len(case.errors) - left.total()


def _own_moments(case: Case) -> float:
    """The share of the footage within a quarter of a second of errors: no queue takes less."""
    around = round(_AROUND_S * case.fps)
    seen = np.zeros(case.frames, bool)
    for error in case.errors:
        seen[max(0, error.frame - around) : error.frame + around + 1] = True
    return float(seen.mean())


if __name__ == "__main__":
    main()
