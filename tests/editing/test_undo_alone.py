"""An old edit alone: the others stay as they are, or it is said which one stands on it."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from label_edits import label_plans
from tables_of_people import bytes_of, table_at, table_of

from tracking.editing import (
    Change,
    Entry,
    History,
    TouchIndex,
    apply_change,
    plan_delete,
    plan_draw_box,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_move_box,
    plan_reassign,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
    plan_split,
    plan_swap,
    plan_undo_alone,
    with_parts_carried,
)
from tracking.errors import EditError
from tracking.tracks import Labels, TrackTable

TRACKS = st.integers(1, 5)
FRAMES = st.integers(0, 12)
PLACES = st.sets(st.tuples(FRAMES, TRACKS), min_size=8, max_size=40).map(sorted)
BOXES = st.tuples(*[st.floats(0.5, 1e3)] * 4)


@dataclass
class Editor:
    """A table, its labels and their history, edited together."""

    table: TrackTable
    labels: Labels = field(default_factory=Labels)
    history: History = field(default_factory=History)

    def do(self, change: Change) -> Entry:
        return self.make(with_parts_carried(change, self.labels))

    def make(self, change: Change, undoes: int = 0) -> Entry:
        self.labels = apply_change(self.table, self.labels, change)
        entry = self.history.draft(change, "2026-01-01T00:00:00.000+00:00", "ada", undoes)
        self.history.add(entry)
        return entry

    def undo_alone(self, number: int) -> Entry:
        return self.make(plan_undo_alone(self.history, self.labels, number), undoes=number)

    def undo(self) -> None:
        entry = self.history.next_undo
        assert entry is not None
        self.labels = apply_change(self.table, self.labels, entry.change.inverse)
        self.history.mark_undone()

    def redo(self) -> None:
        entry = self.history.next_redo
        assert entry is not None
        self.labels = apply_change(self.table, self.labels, entry.change)
        self.history.mark_redone()


@st.composite
def changes(draw: st.DrawFn, table: TrackTable, labels: Labels) -> Change | None:
    """Any edit; None where what was drawn is nonsense."""
    a, b, start = draw(TRACKS), draw(TRACKS), draw(FRAMES)
    end = draw(st.none() | FRAMES)
    plans = [
        lambda: plan_swap(table, a, b, start, end),
        lambda: plan_split(table, a, start),
        lambda: plan_merge_tracks(
            table, a, [b], draw(st.sampled_from(("first", "second"))), labels
        ),
        lambda: plan_reassign(table, a, b, start, end),
        lambda: plan_delete(table, a, start, end),
        lambda: plan_move_box(table, a, start, draw(BOXES)),
        lambda: plan_draw_box(table, draw(st.none() | TRACKS), start, draw(BOXES)),
    ]
    if draw(st.booleans()):
        plans = label_plans(draw, table, labels)
    try:
        return draw(st.sampled_from(plans))()
    except EditError:
        return None


def replayed(table: TrackTable, history: History, without: set[int]) -> tuple[object, Labels]:
    """The table and labels after all edits of the log but some, each field of a label by itself."""
    labels, said = Labels(), {}
    for entry in history:
        if entry.undoes or entry.id in without:
            continue
        change = entry.change
        old, new = change.before.labels, change.after.labels
        for track in new.tracks:
            before, after = fields_of(old.tracks[track]), fields_of(new.tracks[track])
            for name in {*before, *after}:
                if before.get(name) != after.get(name):
                    said[track, name] = after.get(name)
        sides = (
            replace(change.before, labels=replace(old, tracks={})),
            replace(change.after, labels=replace(new, tracks={})),
        )
        labels = apply_change(table, labels, replace(change, before=sides[0], after=sides[1]))
    return bytes_of(table), (labels, {key: value for key, value in said.items() if value})


def fields_of(label: object) -> dict[str, str]:
    return {
        "name": label.name,
        "notes": label.notes,
        **{f"bag {key}": value for key, value in label.attributes.items()},
    }


def said_of(labels: Labels) -> tuple[Labels, dict[tuple[int, str], str]]:
    said = {
        (track, name): value
        for track, label in labels.tracks.items()
        for name, value in fields_of(label).items()
        if value
    }
    return replace(labels, tracks={}), said


def own_edits(history: History) -> set[int]:
    """The edits that are taken back alone."""
    return {entry.id for entry in history if history.taken_back_by(entry.id)}


@settings(max_examples=120, deadline=None)
@given(st.data())
def test_without_one_edit_the_rest_is_what_it_would_have_been(data: st.DataObject) -> None:
    places = data.draw(PLACES)
    editor = Editor(table_at(places))
    for _ in range(data.draw(st.integers(2, 8))):
        change = data.draw(changes(editor.table, editor.labels))
        if change is not None:
            editor.do(change)
    for _ in range(data.draw(st.integers(1, 6))):
        if not len(editor.history):
            return
        number = data.draw(st.integers(1, len(editor.history)))
        if why := editor.history.why_not_alone(number):
            with pytest.raises(EditError, match=re.escape(why)):
                editor.undo_alone(number)
            continue
        editor.undo_alone(number)
        table, labels = replayed(table_at(places), editor.history, own_edits(editor.history))
        assert bytes_of(editor.table) == table
        assert said_of(editor.labels) == labels
        change = data.draw(changes(editor.table, editor.labels))
        if change is not None:
            editor.do(change)
    after, labels = bytes_of(editor.table), editor.labels
    while editor.history.next_undo:
        editor.undo()
    assert (bytes_of(editor.table), editor.labels) == (bytes_of(table_at(places)), Labels())
    while editor.history.next_redo:
        editor.redo()
    assert (bytes_of(editor.table), editor.labels) == (after, labels)
    again = History(editor.history.entries)
    assert [again.why_not_alone(entry.id) for entry in again] == [
        editor.history.why_not_alone(entry.id) for entry in again
    ]


@pytest.fixture
def editor() -> Editor:
    return Editor(table_of({1: [(0, 30)], 2: [(0, 30)], 3: [(0, 30)]}))


def test_an_edit_of_other_tracks_stays_when_an_older_one_is_undone(editor: Editor) -> None:
    start = bytes_of(editor.table)
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_delete(editor.table, 3, 0, 5))
    entry = editor.undo_alone(1)
    assert (entry.kind, entry.text) == ("undo", "Undo edit 1 alone: Swap 1 and 2 from frame 10 on")
    assert (entry.undoes, editor.history.taken_back_by(1)) == (1, 3)
    editor.undo_alone(2)
    assert bytes_of(editor.table) == start


def test_an_edit_inside_a_swapped_stretch_stands_on_the_swap(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_move_box(editor.table, 2, 20, (1.0, 2.0, 3.0, 4.0)))
    editor.do(plan_delete(editor.table, 1, 25))
    with pytest.raises(EditError) as told:
        editor.undo_alone(1)
    assert str(told.value) == (
        '"Delete 1 from frame 25 on" (edit 3) was made on top of it: undo that first, then 1 more'
    )


def test_an_edit_before_a_swapped_stretch_does_not_stand_on_the_swap(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_move_box(editor.table, 2, 9, (1.0, 2.0, 3.0, 4.0)))
    assert editor.history.why_not_alone(1) == ""


def test_what_is_undone_does_not_stand_on_anything(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_delete(editor.table, 1, 25))
    editor.undo()
    assert editor.history.why_not_alone(1) == ""
    assert editor.history.why_not_alone(2) == "edit 2 is undone already"


def test_what_is_taken_back_alone_does_not_stand_on_anything(editor: Editor) -> None:
    start = bytes_of(editor.table)
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_delete(editor.table, 1, 25))
    editor.undo_alone(2)
    assert editor.history.why_not_alone(2) == "edit 2 is undone already, by edit 3"
    editor.undo_alone(1)
    assert bytes_of(editor.table) == start


def test_an_edit_taken_back_alone_can_be_made_again(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.do(plan_delete(editor.table, 3, 5))
    after = bytes_of(editor.table)
    editor.undo_alone(1)
    editor.undo_alone(3)
    assert bytes_of(editor.table) == after
    assert editor.history.taken_back_by(1) == 0
    editor.undo_alone(1)
    assert editor.history.taken_back_by(1) == 5


def test_what_was_made_where_an_edit_was_taken_back_bars_making_it_again(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10))
    editor.undo_alone(1)
    editor.do(plan_delete(editor.table, 1, 25))
    assert "edit 3" in editor.history.why_not_alone(2)


def test_fields_of_one_label_are_undone_each_alone(editor: Editor) -> None:
    for plan in (
        lambda: plan_rename(editor.table, editor.labels, 1, "red coat"),
        lambda: plan_set_attribute(editor.table, editor.labels, 1, "bag", "yes"),
        lambda: plan_set_notes(editor.table, editor.labels, 1, "limps"),
    ):
        editor.do(plan())
    editor.undo_alone(1)
    label = editor.labels.of_track(1)
    assert (label.name, label.attributes, label.notes) == ("", {"bag": "yes"}, "limps")
    editor.do(plan_rename(editor.table, editor.labels, 1, "blue coat"))
    assert "edit 5" in editor.history.why_not_alone(4)


def test_reviewed_ranges_apart_are_undone_each_alone(editor: Editor) -> None:
    editor.do(plan_mark_reviewed(editor.labels, 0, 0, 10))
    editor.do(plan_mark_reviewed(editor.labels, 0, 20, 30))
    assert editor.history.why_not_alone(1) == ""
    editor.do(plan_mark_reviewed(editor.labels, 0, 10, 20))
    assert "edit 3" in editor.history.why_not_alone(1)


def test_a_range_beyond_all_frames_is_no_trouble(editor: Editor) -> None:
    editor.do(plan_swap(editor.table, 1, 2, 10, 10**12))
    columns = editor.history.touches
    again = History(editor.history.entries, TouchIndex.from_columns(columns, 1))
    assert again.why_not_alone(1) == ""
    assert columns["end"].max() <= 2**31


def test_an_edit_that_is_not_there_is_said(editor: Editor) -> None:
    with pytest.raises(EditError, match="there is no edit 7; the log has 0"):
        editor.undo_alone(7)


def test_a_long_text_is_not_made_longer_each_time(editor: Editor) -> None:
    editor.do(plan_set_attribute(editor.table, editor.labels, 1, "coat", "red" * 100))
    for number in range(1, 8):
        editor.undo_alone(number)
    assert all(len(entry.text) <= 320 for entry in editor.history)
    assert editor.history.entries[-1].text.endswith("…")


def test_a_keyframe_that_others_are_interpolated_from_is_not_taken_back_alone():
    editor = Editor(table_at([(0, 1)]))
    editor.do(plan_draw_box(editor.table, 2, 3, (1.0, 2.0, 3.0, 4.0)))
    editor.do(plan_draw_box(editor.table, 2, 9, (9.0, 2.0, 3.0, 4.0), join=True))
    assert len(editor.table.frames_of_track(2)) == 7
    assert "edit 2" in editor.history.why_not_alone(1)
    with pytest.raises(EditError, match="edit 2"):
        editor.undo_alone(1)
