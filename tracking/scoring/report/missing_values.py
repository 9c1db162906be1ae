"""Why measures of a result have no value, where rows are wanting."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tracking.arrays import Integers
from tracking.scoring.report.findings import Finding
from tracking.translation import Message, msg

_NO_VALUE = msg("what only rows that match can tell is 0 or a dash")


def lacking_said(finding: Finding) -> Iterator[Message]:
    """A sentence where nothing can match; none where a row of the result does."""
    subject = finding.subject
    true, found = subject.truth.frame[subject.truth.counted], subject.results[finding.result].frame
    if not len(true) and not len(found):
        yield msg(
            "Neither the ground truth nor the result has anybody in these frames: {no_value}.",
            no_value=_NO_VALUE,
        )
    elif not len(true):
        yield msg(
            "The ground truth has nobody in these frames: all that is tracked is wrong, "
            "{no_value}.",
            no_value=_NO_VALUE,
        )
    elif not len(found):
        yield msg(
            "The result has nobody in these frames: everybody is missed, {no_value}.",
            no_value=_NO_VALUE,
        )
    if not len(true) or not len(found) or finding.score.clear.matches:
        return
    if np.isin(found, true).any():
        yield msg(
            "No row of the result matches one of the ground truth, {no_value}: "
            "are they of the same recording?",
            no_value=_NO_VALUE,
        )
    else:
        yield msg(
            "No frame has rows of both, {no_value}: those of the ground truth stand in frames "
            "{true}, the result's in {found}; are they of the same recording, and counted from the "
            "same frame?",
            no_value=_NO_VALUE,
            true=_reach(true, subject.start),
            found=_reach(found, subject.start),
        )


def _reach(frames: Integers, start: int) -> Message:
    first, last = int(frames.min()) + start, int(frames.max()) + start
    return msg("{first} to {last}", first=first, last=last)
