"""How much of the footage has to be watched: `python -m tests.benchmarks.review`.

Renders and tracks scenes that nothing was fitted on, as they are and with tracks swapped on
purpose, and walks the review items in the order that finds most for the time watched. Beside it
stands what a queue would find that knows the errors and shows each for half a second, always next
what shows most: about the best there is, not a bound. `--fresh` reports on scenes that nothing was
chosen by, `--fit` fits hazards and likelihoods anew on other scenes. What is rendered and tracked
is kept; the first time takes an hour.

`--crowds` tells it of each labelled recording of the footage that trackers are judged by, with
each tracker that suits it and no swaps; "flagged" is what all of its review items together show.
`--risk` holds the errors that review items state against those there are, on the same footage, and
prints the figures of `tracking.review.risk`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.command import parser_of, real_data
from tests.benchmarks.review_cases import (
    CROWD_TRACKERS,
    FRESH,
    REPORTED,
    TUNING,
    Case,
    cases,
    crowded_cases,
)
from tests.benchmarks.review_fit import fit
from tests.benchmarks.review_risk import print_risks, risk_of
from tracking.review import ReviewMeasures, find_review_items, rank, review_measures
from tracking.scoring import FloorMatch

FOOTAGE = 0.05
RECALL = 0.95
_BEFORE_S, _AFTER_S = 0.15, 0.4
"""What a queue that knows the errors shows of one."""
_COLUMNS = "scenes", "errors", "found in 5 % of the footage", "at best", "footage for 95 %"


def main() -> None:
    """Print a Markdown table."""
    parser = parser_of("review", __doc__)
    parser.add_argument("--fit", action="store_true", help="fit the likelihoods anew")
    parser.add_argument("--fresh", action="store_true", help="scenes nothing was chosen by")
    parser.add_argument("--crowds", action="store_true", help="by recording and tracker")
    parser.add_argument("--risk", action="store_true", help="stated against found errors")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="crowds of these recordings")
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    if asked.risk:
        print_risks([risk_of(case) for case in crowded_cases(asked.data, asked.only)])
        return
    if asked.crowds:
        crowds = crowded_cases(asked.data, asked.only)
        _print_crowds([(case, _measured(case)) for case in crowds])
        return
    scenes = TUNING if asked.fit else FRESH if asked.fresh else REPORTED
    found = list(cases(scenes, FloorMatch(0.5)))
    if asked.fit:
        fit(found)
        return
    print("|", " | ".join(_COLUMNS), "|")
    print("|", " | ".join("---" for _ in _COLUMNS), "|")
    for name, group in _groups(found):
        print(_row(name, group), flush=True)


def _print_crowds(measured: Sequence[tuple[Case, ReviewMeasures]]) -> None:
    """A line a recording and tracker, one a tracker, and one of all; the trackers' own errors."""
    own = [(case, found) for case, found in measured if case.errors]
    print("| recording | tracker | errors | found in 5 % of the footage | at best | flagged |")
    print("| --- | --- | --- | --- | --- | --- |")
    for case, found in own:
        print(_crowd_row(case.recording, case.tracker, [(case, found)]))
    for tracker in CROWD_TRACKERS:
        print(_crowd_row("all", tracker, [each for each in own if each[0].tracker == tracker]))
    print(_crowd_row("all", "all", own))


def _crowd_row(recording: str, tracker: str, group: Sequence[tuple[Case, ReviewMeasures]]) -> str:
    errors = sum(found.errors for _, found in group)
    counts = (
        sum(found.found_within(FOOTAGE) for _, found in group),
        sum(_found_at_best(case) for case, _ in group),
        sum(found.found_within(1.0) for _, found in group),
    )
    shares = " | ".join(f"{count / max(1, errors):.0%}" for count in counts)
    return f"| {recording} | {tracker} | {errors} | {shares} |"


def _groups(found: Sequence[Case]) -> Iterator[tuple[str, Sequence[Case]]]:
    """Results with errors that are told in a line, with its name."""
    for calm in (True, False):
        for swapped in (False, True):
            group = [
                case
                for case in found
                if case.errors and case.calm == calm and bool(case.swaps) == swapped
            ]
            if group:
                yield (
                    f"{'calm' if calm else 'crowded'}, {'swapped' if swapped else 'as tracked'}",
                    group,
                )


def _row(name: str, group: Sequence[Case]) -> str:
    """A line of the table; figures of all results pooled."""
    measured = [_measured(case) for case in group]
    errors = sum(each.errors for each in measured)
    found = sum(each.found_within(FOOTAGE) for each in measured)
    best = sum(_found_at_best(case) for case in group)
    shares = f"{found / errors:.1%} | {best / errors:.1%} | {_enough(measured, errors)}"
    return f"| {name} | {errors} | {shares} |"


def _measured(case: Case) -> ReviewMeasures:
    found = find_review_items(case.table, case.run, case.fps, view=case.view, size=case.size)
    review_items = rank(found, "yield")
    return review_measures(review_items, case.errors, case.frames, case.fps)


def _enough(measured: Sequence[ReviewMeasures], errors: int) -> str:
    """The least share of every result's footage that shows enough of all errors."""
    for footage in np.arange(1, 101) / 100:
        if sum(each.found_within(footage) for each in measured) >= RECALL * errors:
            return f"{footage:.0%}"
    return "never"


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


if __name__ == "__main__":
    main()
