"""Changing which attributes people have, and their values with them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tables_of_people import table_of

from tracking.editing import (
    SchemaChange,
    apply_change,
    plan_schema,
    plan_set_attribute,
    state_as_text,
    state_from_text,
)
from tracking.errors import EditError
from tracking.tracks import (
    Attribute,
    AttributeType,
    Labels,
    TrackLabel,
    TrackTable,
    as_stored,
    missing_values,
    unfit_values,
    used_values,
    why_unfit,
)

ROLE = Attribute("role", AttributeType.CHOICE, ("guest", "staff"), "guest", required=True)
BAG = Attribute("bag", AttributeType.YES_NO)
AGE = Attribute("age", AttributeType.NUMBER, least=0, most=10, step=0.1)
SAID = Labels(
    {1: TrackLabel("Ada", {"role": "guest", "bag": "true"}), 2: TrackLabel("", {"a": "b"})}
)


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(3, 10)], 2: [(0, 4)], 3: [(0, 4)]})


def changed(table: TrackTable, labels: Labels, *schema: Attribute, **said: object) -> Labels:
    change = plan_schema(table, labels, SchemaChange(schema, **said))  # type: ignore[arg-type]
    after = apply_change(table, labels, change)
    assert apply_change(table, after, change.inverse) == labels
    for side in (change.before, change.after):  # as the journal keeps it
        assert state_from_text(state_as_text(side)).labels == side.labels
    return after


def test_a_schema_is_one_edit_that_brings_values_into_its_form(table: TrackTable) -> None:
    after = changed(table, SAID, ROLE, BAG)
    assert after.schema == (ROLE, BAG)
    assert after.of_track(1).attributes == {"role": "guest", "bag": "yes"}


def test_values_go_along_with_a_new_name_and_a_renamed_choice(table: TrackTable) -> None:
    first = changed(table, SAID, ROLE, BAG)
    duty = Attribute("duty", AttributeType.CHOICE, ("visitor", "staff"))
    after = changed(
        table, first, duty, BAG, renamed={"role": "duty"}, choices={"duty": {"guest": "visitor"}}
    )
    assert after.of_track(1).attributes == {"bag": "yes", "duty": "visitor"}


def test_values_of_a_removed_attribute_stay_unless_they_are_deleted(table: TrackTable) -> None:
    first = changed(table, SAID, ROLE, BAG)
    assert changed(table, first, BAG).of_track(1).attributes["role"] == "guest"
    assert "role" not in changed(table, first, BAG, dropped=("role",)).of_track(1).attributes


def test_names_can_be_exchanged(table: TrackTable) -> None:
    labels = Labels({1: TrackLabel("", {"a": "1", "b": "2"})}, schema=(Attribute("a"),))
    after = changed(table, labels, Attribute("b"), renamed={"a": "b", "b": "a"})
    assert after.of_track(1).attributes == {"a": "2", "b": "1"}


def test_a_name_that_somebody_has_already_is_refused(table: TrackTable) -> None:
    wanted = SchemaChange((Attribute("bag"),), {"role": "bag"})
    with pytest.raises(EditError, match="track 1 has an attribute bag already"):
        plan_schema(table, SAID, wanted)


def test_the_same_schema_is_no_edit(table: TrackTable) -> None:
    labels = changed(table, SAID, ROLE, BAG)
    with pytest.raises(EditError, match="nothing to change"):
        plan_schema(table, labels, SchemaChange((ROLE, BAG)))


def test_a_schema_changed_meanwhile_is_not_overwritten(table: TrackTable) -> None:
    change = plan_schema(table, SAID, SchemaChange((ROLE,)))
    with pytest.raises(EditError, match="not what the edit was planned on"):
        apply_change(table, changed(table, SAID, BAG), change)


def test_values_that_do_not_suit_are_told_by_name(table: TrackTable) -> None:
    labels = changed(table, SAID, ROLE)
    labels = apply_change(table, labels, plan_set_attribute(table, labels, 1, "role", "cook"))
    (line,) = unfit_values(labels.schema, labels.tracks)
    assert line == (
        "attribute role of track 1 does not suit the schema ('cook'): it is one of: guest, staff"
    )
    (line,) = missing_values(labels.schema, labels.tracks, table.track_ids)
    assert line == "attribute role is required and has no value: track 2, 3"


@pytest.mark.parametrize(
    ("value", "stored", "why"),
    [
        ("4", "4", None),
        ("4.50", "4.5", None),
        ("0.3", "0.3", None),
        ("1e1", "10", None),
        ("-1", "-1", "at least 0"),
        ("10.5", "10.5", "at most 10"),
        ("0.25", "0.25", "steps of 0.1"),
        ("nan", "nan", "a number"),
        ("1_0", "1_0", "a number"),
        ("", "", "a number"),
    ],
)
def test_numbers_are_checked_and_written_in_one_way(
    value: str, stored: str, why: str | None
) -> None:
    assert as_stored(AGE, value) == stored
    found = why_unfit(AGE, stored)
    assert (found is None) if why is None else (found is not None and why in found)


@given(st.text(max_size=20))
def test_what_is_stored_is_stored_as_it_is_again(value: str) -> None:
    for attribute in (ROLE, BAG, AGE, Attribute("coat")):
        once = as_stored(attribute, value)
        assert as_stored(attribute, once) == once


def test_values_in_use_come_with_the_most_frequent_first() -> None:
    labels = Labels(
        {n: TrackLabel("", {"coat": text}) for n, text in enumerate(("red", "blue", "blue"), 1)}
    )
    assert used_values(labels, "coat") == ("blue", "red")
