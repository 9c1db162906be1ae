"""What a caller may hand a planner: long texts are refused, numbers of arrays are numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tables_of_people import table_of

from tracking.editing import (
    Change,
    apply_change,
    plan_draw_box,
    plan_label_part,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_reassign,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
    plan_split,
    plan_swap,
    plan_unmark_reviewed,
    plan_verdict,
    state_as_text,
    state_from_text,
)
from tracking.errors import EditError
from tracking.tracks import Labels, PartLabel, ReviewedRange, TrackTable, Verdict

BOX = (10.0, 20.0, 30.0, 40.0)
NUMBERS: list[Any] = [np.int64(number) for number in (4, 7, 5, 9, 0)]
FOUR, SEVEN, FIVE, NINE, NOUGHT = NUMBERS
Plan = Callable[[TrackTable, Labels], Change]


@pytest.fixture
def table() -> TrackTable:
    return table_of({4: [(0, 20)], 7: [(3, 30)]})


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table, said: plan_rename(table, said, 4, "x" * 201), "201 .* at most 200"),
        (lambda table, said: plan_set_notes(table, said, 4, "x" * 20_001), "at most 20000"),
        (lambda table, said: plan_set_attribute(table, said, 4, "x" * 101, ""), "at most 100"),
        (lambda table, said: plan_set_attribute(table, said, 4, "a", "x" * 2001), "at most 2000"),
    ],
)
def test_a_text_too_long_for_anybody_is_refused_in_one_line(
    table: TrackTable, plan: Plan, why: str
) -> None:
    with pytest.raises(EditError, match=why) as told:
        plan(table, Labels())
    assert "\n" not in str(told.value)
    assert len(str(told.value)) < 200


@pytest.mark.parametrize(
    "plan",
    [
        lambda table, said: plan_rename(table, said, 4, "x" * 200),
        lambda table, said: plan_set_notes(table, said, 4, "x" * 20_000),
        lambda table, said: plan_set_attribute(table, said, 4, "x" * 100, "y" * 2_000),
    ],
)
def test_a_text_of_the_longest_length_is_taken(table: TrackTable, plan: Plan) -> None:
    change = plan(table, Labels())
    assert FOUR in apply_change(table, Labels(), change).tracks


@pytest.mark.parametrize(
    "plan",
    [
        lambda table, said: plan_rename(table, said, FOUR, "Ada", FIVE),
        lambda table, said: plan_set_notes(table, said, FOUR, "seen"),
        lambda _, said: plan_mark_reviewed(said, FOUR, FIVE, NINE),
        lambda _, said: plan_mark_reviewed(said, np.array([4, 7]), FIVE, NINE),
        lambda _, said: plan_verdict(said, Verdict("swap", (FOUR, SEVEN), FIVE, "right")),
        lambda _, said: plan_label_part(
            said, PartLabel(FIVE, FOUR, NOUGHT, tuple(np.array(BOX, np.float32)))
        ),
        lambda table, _: plan_draw_box(table, SEVEN, NOUGHT, BOX),
        lambda table, _: plan_swap(table, FOUR, SEVEN, FIVE, NINE),
        lambda table, _: plan_split(table, FOUR, FIVE),
        lambda table, _: plan_merge_tracks(table, FOUR, [SEVEN]),
        lambda table, _: plan_reassign(table, FOUR, NINE, FIVE),
    ],
)
def test_numbers_of_arrays_are_numbers_to_planners_and_to_the_log(
    table: TrackTable, plan: Plan
) -> None:
    change = plan(table, Labels())
    for side in (change.before, change.after):
        again = state_from_text(state_as_text(side))
        assert again.labels == side.labels
        assert (again.stretches == side.stretches).all()
    apply_change(table, Labels(), change)


def test_numbers_of_arrays_unmark_what_was_reviewed() -> None:
    labels = Labels(reviewed=(ReviewedRange(4, 0, 20),))
    change = plan_unmark_reviewed(labels, FOUR, FIVE, NINE)
    assert apply_change(TrackTable(), labels, change).reviewed == (
        ReviewedRange(4, 0, 5),
        ReviewedRange(4, 9, 20),
    )


@pytest.mark.parametrize(
    "plan",
    [
        lambda table: plan_swap(table, 4, 7, 10),
        lambda table: plan_split(table, 4, 10),
        lambda table: plan_merge_tracks(table, 7, [4]),
        lambda table: plan_reassign(table, 4, 9, 10),
    ],
)
def test_a_reviewed_range_stays_with_its_name_where_rows_change_theirs(
    table: TrackTable, plan: Callable[[TrackTable], Change]
) -> None:
    labels = Labels(reviewed=(ReviewedRange(4, 5, 15),))
    after = apply_change(table, labels, plan(table))
    assert after.reviewed == labels.reviewed
    assert not after.is_reviewed(7, 12)
    assert not after.is_reviewed(9, 12)
