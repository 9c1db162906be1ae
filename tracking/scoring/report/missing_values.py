"""Why measures of a result have no value, where rows are wanting."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tracking.arrays import Integers
from tracking.scoring.report.findings import Finding

_NO_VALUE = "what only rows that match can tell is 0 or a dash"


def lacking_said(finding: Finding) -> Iterator[str]:
    """A sentence where nothing can match; none where a row of the result does."""
    subject = finding.subject
    true, found = subject.truth.frame[subject.truth.counted], subject.results[finding.result].frame
    if not len(true) and not len(found):
        yield f"Neither the ground truth nor the result has anybody in these frames: {_NO_VALUE}."
    elif not len(true):
        yield (
            "The ground truth has nobody in these frames: all that is tracked is wrong, "
            f"{_NO_VALUE}."
        )
    elif not len(found):
        yield f"The result has nobody in these frames: everybody is missed, {_NO_VALUE}."
    if not len(true) or not len(found) or finding.score.clear.matches:
        return
    if np.isin(found, true).any():
        yield (
            f"No row of the result matches one of the ground truth, {_NO_VALUE}: "
            "are they of the same recording?"
        )
    else:
        yield (
            f"No frame has rows of both, {_NO_VALUE}: those of the ground truth stand in frames "
            f"{_reach(true, subject.start)}, the result's in {_reach(found, subject.start)}; "
            "are they of the same recording, and counted from the same frame?"
        )


def _reach(frames: Integers, start: int) -> str:
    return f"{int(frames.min()) + start} to {int(frames.max()) + start}"
