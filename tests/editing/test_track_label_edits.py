"""Names, attributes, notes, occluders and reviewed ranges."""

from __future__ import annotations

import pytest
from tables_of_people import table_of

from tracking.editing import (
    apply_change,
    plan_mark_reviewed,
    plan_occluders,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
)
from tracking.errors import EditError
from tracking.tracks import Labels, Occluder, ReviewedRange, TrackLabel, TrackTable

PILLAR = Occluder("pillar", ((0.0, 0.0), (5.0, 0.0), (5.0, 90.0)))


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(3, 10)]})


def test_a_name_is_given_and_taken_away(table: TrackTable) -> None:
    change = plan_rename(table, Labels(), 1, "  red \n coat ")
    named = apply_change(table, Labels(), change)
    assert named.of_track(1).name == "red coat"
    assert (change.text, change.frame) == ('Name 1 "red coat"', 3)
    assert apply_change(table, named, plan_rename(table, named, 1, "")) == Labels()


def test_attributes_are_set_and_taken_away(table: TrackTable) -> None:
    labels = Labels()
    for key, value in (("bag", "yes"), ("age", "40"), ("bag", None)):
        labels = apply_change(table, labels, plan_set_attribute(table, labels, 1, key, value))
    assert labels.of_track(1).attributes == {"age": "40"}


def test_an_attribute_of_several_lines_is_told_in_one(table: TrackTable) -> None:
    change = plan_set_attribute(table, Labels(), 1, "seen", "at the\ndoor")
    assert change.text == "Set seen of 1 to at the door"
    assert change.after.labels.tracks[1].attributes == {"seen": "at the\ndoor"}


def test_notes_keep_their_lines(table: TrackTable) -> None:
    labels = apply_change(table, Labels(), plan_set_notes(table, Labels(), 1, "limps\ntall"))
    assert labels.of_track(1) == TrackLabel(notes="limps\ntall")


def test_occluders_are_set_whole(table: TrackTable) -> None:
    change = plan_occluders(Labels(), [PILLAR], 8)
    labels = apply_change(table, Labels(), change)
    assert labels.occluders == (PILLAR,)
    assert apply_change(table, labels, change.inverse) == Labels()


def test_reviewed_ranges_that_touch_become_one(table: TrackTable) -> None:
    labels = Labels()
    for track, start, end in ((0, 10, 20), (1, 0, 5), (0, 0, 10), (0, 30, 40)):
        labels = apply_change(table, labels, plan_mark_reviewed(labels, track, start, end))
    assert labels.reviewed == (
        ReviewedRange(0, 0, 20),
        ReviewedRange(0, 30, 40),
        ReviewedRange(1, 0, 5),
    )


def test_a_label_changed_meanwhile_is_not_overwritten(table: TrackTable) -> None:
    change = plan_rename(table, Labels(), 1, "red coat")
    other = Labels({1: TrackLabel("blue coat")})
    with pytest.raises(EditError, match="not what the edit was planned on"):
        apply_change(table, other, change)


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_rename(table, Labels(), 9, "red"), "track 9"),
        (lambda table: plan_rename(table, Labels(), 1, ""), "nothing to change"),
        (lambda table: plan_rename(table, Labels(), 1, "a\0b"), "zero character"),
        (lambda table: plan_rename(table, Labels(), 1, "\ud800"), "half a character"),
        (lambda table: plan_set_attribute(table, Labels(), 1, " ", "x"), "needs a name"),
        (lambda _: plan_occluders(Labels(), [Occluder("", ((0, 0), (1, 1)))]), "three"),
        (lambda _: plan_occluders(Labels(), []), "nothing to change"),
        (lambda _: plan_mark_reviewed(Labels(), 0, 5, 5), "empty"),
    ],
)
def test_nonsense_is_refused_in_words(table: TrackTable, plan: object, why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]
