"""Thousands of reviewed ranges do not make each further edit of them slower in proportion."""

from __future__ import annotations

import pytest

from tracking.editing import Change, LabelState, State, apply_change
from tracking.errors import EditError
from tracking.tracks import Labels, ReviewedRange, TrackTable

MANY = 4096


def marked(*coming: ReviewedRange, leaving: tuple[ReviewedRange, ...] = ()) -> Change:
    before, after = LabelState(reviewed=leaving), LabelState(reviewed=coming)
    return Change("reviewed", "Mark", 0, State(labels=before), State(labels=after))


def many() -> Labels:
    return Labels(reviewed=tuple(ReviewedRange(1, 2 * at, 2 * at + 1) for at in range(MANY)))


def test_a_range_among_thousands_is_found_by_halves(monkeypatch: pytest.MonkeyPatch) -> None:
    labels, before, compared = many(), ReviewedRange.__lt__, 0

    def counting(one: ReviewedRange, other: ReviewedRange) -> bool:
        nonlocal compared
        compared += 1
        return before(one, other)

    monkeypatch.setattr(ReviewedRange, "__lt__", counting)
    new = ReviewedRange(1, 2 * MANY + 10, 2 * MANY + 20)
    changed = apply_change(TrackTable(), labels, marked(new, leaving=(labels.reviewed[77],)))
    assert compared < 100
    assert changed.reviewed == (*labels.reviewed[:77], *labels.reviewed[78:], new)


@pytest.mark.parametrize(
    "change",
    [
        marked(ReviewedRange(1, 0, 1)),
        marked(leaving=(ReviewedRange(1, 1, 2),)),
        marked(leaving=(ReviewedRange(2, 0, 1),)),
    ],
)
def test_a_range_that_is_not_as_planned_is_refused(change: Change) -> None:
    with pytest.raises(EditError, match="not what the edit was planned on"):
        apply_change(TrackTable(), many(), change)
