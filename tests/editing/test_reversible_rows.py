"""Every planner of rows: undo is the identity, nothing beyond the scope is touched."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from people_on_a_floor_plan import VIEW
from tables_of_people import bytes_of, table_at

from tracking.editing import (
    Change,
    apply_change,
    plan_add_keyframe,
    plan_delete_keyframe,
    plan_delete_tracks,
    plan_drag,
    plan_draw_box,
    plan_fill_gap,
    plan_fill_gaps,
    plan_interpolate,
    plan_mark_occluded,
    plan_merge_tracks,
    plan_move_box,
    plan_new_track,
    plan_propagate,
    plan_put_box,
    plan_put_boxes,
    plan_reassign,
    plan_split,
    plan_swap,
    plan_thin,
    state_as_text,
    state_from_text,
)
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable

LAST = 16
TRACKS = st.integers(1, 4)
FRAMES = st.integers(0, LAST)
SETS = st.lists(TRACKS, min_size=1, max_size=3, unique=True)
RANGES = st.tuples(FRAMES, st.none() | st.integers(1, LAST)).map(
    lambda drawn: (drawn[0], None if drawn[1] is None else drawn[0] + drawn[1])
)
BOXES = st.tuples(st.floats(0, 600), st.floats(0, 400), st.floats(0.5, 300), st.floats(0.5, 400))
SPOTS = st.tuples(st.floats(-3, 3), st.floats(-1, 8))
WAYS = st.fixed_dictionaries(
    {
        "how": st.sampled_from((None, "linear", "floor")),
        "view": st.sampled_from((None, VIEW)),
        "fps": st.sampled_from((None, 20.0)),
    }
)
KEEPS = st.sampled_from(("first", "second", "surer"))
Planner = Callable[[TrackTable, st.DataObject], tuple[Change, set[int], range]]


@st.composite
def tables(draw: st.DrawFn) -> TrackTable:
    """Few tracks with gaps, in places the camera sees and some it does not, from all sources."""
    seed, density = draw(st.integers(0, 10**6)), draw(st.sampled_from((0.1, 0.6, 0.85, 1.0)))
    random = np.random.default_rng(seed)
    there = np.argwhere(random.random((LAST + 1, 4)) < density)
    places = [(frame, track + 1) for frame, track in there.tolist()]
    rows = dict(table_at(places, seed).columns())
    rows["source"] = random.choice([0, 1, 1, 2, 2, 2], len(places)).astype(np.uint8)
    rows["x"], rows["y"] = rows["x"] / 20 - 2.5, rows["y"] / 12
    rows["confidence"] = rows["confidence"] / 100
    rows["visibility"] = random.choice([0, 0.5, 1, np.nan], len(places)).astype(np.float32)
    return TrackTable(rows)


def whole() -> range:
    return range(10**6)


def scope(start: int, end: int | None) -> range:
    return range(start, 10**6 if end is None else end)


def swap(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    a, b, (start, end) = data.draw(TRACKS), data.draw(TRACKS), data.draw(RANGES)
    return plan_swap(table, a, b, start, end), {a, b}, scope(start, end)


def split(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    return plan_split(table, track, frame), {track, table.highest_track + 1}, scope(frame, None)


def merge(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    a, b, fill = data.draw(TRACKS), data.draw(TRACKS), data.draw(st.booleans())
    ways = data.draw(WAYS)
    return plan_merge_tracks(table, a, [b], data.draw(KEEPS), fill=fill, **ways), {a, b}, whole()


def merge_tracks(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    into, others, fill = data.draw(TRACKS), data.draw(SETS), data.draw(st.booleans())
    change = plan_merge_tracks(table, into, others, data.draw(KEEPS), fill=fill, **data.draw(WAYS))
    return change, {into, *others}, whole()


def reassign(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    a, b, (start, end) = data.draw(TRACKS), data.draw(st.integers(1, 7)), data.draw(RANGES)
    return plan_reassign(table, a, b, start, end), {a, b}, scope(start, end)


def delete(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    tracks, (start, end) = data.draw(SETS), data.draw(RANGES)
    return plan_delete_tracks(table, tracks, start, end), set(tracks), scope(start, end)


def occluded(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    tracks, (start, end) = data.draw(SETS), data.draw(RANGES)
    change = plan_mark_occluded(table, tracks, start, end, data.draw(st.booleans()))
    return change, set(tracks), scope(start, end)


def move(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame, place = data.draw(TRACKS), data.draw(FRAMES), data.draw(st.none() | SPOTS)
    change = plan_move_box(table, track, frame, data.draw(BOXES), place, **data.draw(WAYS))
    return change, {track}, near(table, track, frame)


def drag(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame, ways = data.draw(TRACKS), data.draw(FRAMES), data.draw(WAYS)
    ways["view"] = VIEW
    return (
        plan_drag(table, track, frame, data.draw(SPOTS), **ways),
        {track},
        near(table, track, frame),
    )


def draw(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    change = plan_draw_box(table, track, frame, data.draw(BOXES), **data.draw(WAYS))
    return change, {track}, near(table, track, frame)


def join(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame, ways = data.draw(TRACKS), data.draw(FRAMES), data.draw(WAYS)
    change = plan_draw_box(table, track, frame, data.draw(BOXES), join=True, **ways)
    return change, {track}, near(table, track, frame)


def new_track(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    frame, box, place = data.draw(FRAMES), data.draw(st.none() | BOXES), data.draw(SPOTS)
    change = plan_new_track(table, frame, box, place, view=VIEW)
    return change, {table.highest_track + 1}, range(frame, frame + 1)


def keyframe(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    return plan_add_keyframe(table, track, frame), {track}, range(frame, frame + 1)


def no_keyframe(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    change = plan_delete_keyframe(table, track, frame, **data.draw(WAYS))
    return change, {track}, near(table, track, frame)


def interpolate(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, start = data.draw(TRACKS), data.draw(FRAMES)
    end = start + data.draw(st.integers(0, LAST))
    return plan_interpolate(table, track, start, end, **data.draw(WAYS)), {track}, range(start, end)


def fill_gap(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    return plan_fill_gap(table, track, frame, **data.draw(WAYS)), {track}, near(table, track, frame)


def fill_gaps(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    tracks, longest = data.draw(SETS), data.draw(st.integers(1, 5))
    return plan_fill_gaps(table, tracks, longest, **data.draw(WAYS)), set(tracks), whole()


def thin(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, start, end = (
        data.draw(TRACKS),
        data.draw(st.integers(0, 4)),
        data.draw(st.none() | FRAMES),
    )
    tolerance = data.draw(st.sampled_from((1.0, 900.0)))
    change = plan_thin(table, track, start, end, tolerance, 9.0, **data.draw(WAYS))
    return change, {track}, scope(start, end)


def put(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame = data.draw(TRACKS), data.draw(FRAMES)
    change = plan_put_box(table, track, frame, data.draw(BOXES), **data.draw(WAYS))
    return change, {track}, near(table, track, frame)


def put_all(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    tracks, frame = data.draw(SETS), data.draw(FRAMES)
    boxes = {track: data.draw(BOXES) for track in tracks}
    return plan_put_boxes(table, frame, boxes, **data.draw(WAYS)), set(tracks), whole()


def propagate(table: TrackTable, data: st.DataObject) -> tuple[Change, set[int], range]:
    track, frame, ways = data.draw(TRACKS), data.draw(FRAMES), data.draw(WAYS)
    del ways["how"]
    change = plan_propagate(table, track, frame, frame + data.draw(st.integers(1, 9)), **ways)
    return change, {track}, whole()


def near(table: TrackTable, track: int, frame: int) -> range:
    """From the nearest row before a frame that is not interpolated to the one after it."""
    rows = table.of_track(track)
    fast = rows["frame"][rows["source"] != Source.INTERPOLATED]
    before, after = fast[fast < frame], fast[fast > frame]
    return range(int(before.max(initial=-1)) + 1, int(after.min(initial=10**6)))


PLANNERS = (
    swap, split, merge, merge_tracks, reassign, delete, occluded, move, drag, draw, join, new_track,
    keyframe, no_keyframe, interpolate, fill_gap, fill_gaps, thin, put,
    put_all, propagate,
)  # fmt: skip


@pytest.mark.parametrize("planner", PLANNERS, ids=lambda planner: planner.__name__)
def test_undo_is_the_identity_and_nothing_else_is_touched(planner: Planner) -> None:
    planned = 0

    @settings(max_examples=80, deadline=None, derandomize=True)
    @given(tables(), st.data())
    def holds(table: TrackTable, data: st.DataObject) -> None:
        nonlocal planned
        before, rows_before = bytes_of(table), table.columns()
        try:
            change, tracks, frames = planner(table, data)
        except EditError:
            assert bytes_of(table) == before
            return
        planned += 1
        assert bytes_of(table) == before
        assert set(change.tracks) <= tracks
        apply_change(table, Labels(), through_text(change))
        TrackTable(table.columns())  # still a table
        beyond_is_same(rows_before, table.columns(), tracks, frames)
        apply_change(table, Labels(), through_text(change).inverse)
        assert bytes_of(table) == before

    holds()
    assert planned >= 5


def beyond_is_same(
    before: dict[str, np.ndarray], after: dict[str, np.ndarray], tracks: set[int], frames: range
) -> None:
    def others(rows: dict[str, np.ndarray]) -> list[bytes]:
        named = np.isin(rows["track"], list(tracks))
        inside = (rows["frame"] >= frames.start) & (rows["frame"] < frames.stop)
        return [column[~(named & inside)].tobytes() for column in rows.values()]

    assert others(before) == others(after)


def through_text(change: Change) -> Change:
    sides = [state_from_text(state_as_text(side)) for side in (change.before, change.after)]
    return Change(change.kind, change.text, change.frame, *sides)
