"""Undo after do is the identity, and a change comes back from text bit for bit."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
from tables_of_people import bytes_of, table_at

from tracking.editing import (
    Change,
    apply_change,
    plan_delete,
    plan_draw_box,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_move_box,
    plan_occluders,
    plan_reassign,
    plan_rename,
    plan_set_attribute,
    plan_split,
    plan_swap,
    state_as_text,
    state_from_text,
)
from tracking.errors import EditError
from tracking.tracks import Labels, Occluder, TrackLabel, TrackTable

TRACKS = st.integers(1, 5)
FRAMES = st.integers(0, 12)
PLACES = st.sets(st.tuples(FRAMES, TRACKS), max_size=40).map(sorted)
BOXES = st.tuples(*[st.floats(0.5, 1e3)] * 4)
NAMES = st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=6)


@st.composite
def changes(draw: st.DrawFn, table: TrackTable, labels: Labels) -> Change | None:
    """Any edit; None where what was drawn is nonsense on this table."""
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
        lambda: plan_rename(table, labels, a, draw(NAMES)),
        lambda: plan_set_attribute(table, labels, a, draw(NAMES), draw(st.none() | NAMES)),
        lambda: plan_mark_reviewed(labels, draw(st.integers(0, 5)), start, end or 0),
        lambda: plan_occluders(labels, [Occluder(draw(NAMES), ((0, 0), (1.5, 0), (0, 9)))]),
    ]
    try:
        return draw(st.sampled_from(plans))()
    except EditError:
        return None


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_undo_after_do_is_the_identity(data: st.DataObject) -> None:
    table, labels = table_at(data.draw(PLACES)), Labels({1: TrackLabel("red", {}, "tall")})
    done: list[tuple[Change, dict[str, bytes], Labels]] = []
    for _ in range(data.draw(st.integers(1, 6))):
        change = data.draw(changes(table, labels))
        if change is not None:
            done.append((change, bytes_of(table), labels))
            labels = apply_change(table, labels, change)
            TrackTable(table.columns())  # still a table
    last, last_labels = bytes_of(table), labels
    for change, before, labels_before in reversed(done):
        labels = apply_change(table, labels, through_text(change).inverse)
        assert bytes_of(table) == before
        assert labels == labels_before
    for change, _, _ in done:
        labels = apply_change(table, labels, through_text(change))
    assert bytes_of(table) == last
    assert labels == last_labels


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_every_frame_and_track_shows_the_edited_rows(data: st.DataObject) -> None:
    table, labels = table_at(data.draw(PLACES)), Labels()
    for _ in range(4):
        change = data.draw(changes(table, labels))
        if change is not None:
            labels = apply_change(table, labels, change)
    rows = table.columns()
    for frame in range(14):
        for name, column in table.of_frame(frame).items():
            assert column.tobytes() == rows[name][rows["frame"] == frame].tobytes()
    for track in range(1, 12):
        for name, column in table.of_track(track).items():
            assert column.tobytes() == rows[name][rows["track"] == track].tobytes()


def through_text(change: Change) -> Change:
    return replace(
        change,
        before=state_from_text(state_as_text(change.before)),
        after=state_from_text(state_as_text(change.after)),
    )
