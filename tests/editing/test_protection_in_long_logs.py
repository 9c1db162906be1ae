"""What is protected, told of a log as it grows, against the plain way of telling it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from runs_of_people import FPS, done, table_of

from tests.pace import spent
from tracking.editing import (
    Entry,
    History,
    apply_change,
    find_protected,
    plan_delete,
    plan_draw_box,
    plan_merge_tracks,
    plan_move_box,
    plan_reassign,
    plan_rename,
    plan_split,
    plan_swap,
    plan_undo_alone,
)
from tracking.editing.tracking_again.coverage import Coverage
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable

BOX = (1.0, 2.0, 30.0, 60.0)
FRAMES = 60
MARGIN = 10
WALKS = [(1, 0, FRAMES, 0.0), (2, 0, FRAMES, 1.0), (3, 0, 40, 2.0), (4, 45, FRAMES, 2.0)]
Cells = set[tuple[int, int]]

KINDS = ["swap", "range", "split", "merge", "give", "move", "draw", "delete", "name"]
KINDS += ["undo", "redo", "alone"]
EDITS = st.lists(
    st.tuples(
        st.sampled_from(KINDS),
        st.integers(1, 5),
        st.integers(1, 5),
        st.integers(1, FRAMES - 2),
        st.integers(1, 12),
    ),
    max_size=12,
)


def worked(drawn: list[tuple[str, int, int, int, int]]) -> tuple[TrackTable, Labels, History]:
    """The table after edits, made as a session makes them; those that cannot be are left out."""
    table, labels, history = table_of(WALKS), Labels(), History()
    for step in drawn:
        try:
            labels = _made(step, table, labels, history)
        except EditError:
            continue
        find_protected(table, labels, history, fps=FPS)
    return table, labels, history


def _made(
    step: tuple[str, int, int, int, int], table: TrackTable, labels: Labels, history: History
) -> Labels:
    what, one, other, frame, count = step
    if what == "undo":
        return apply_change(table, labels, history.mark_undone().change.inverse)
    if what == "redo":
        return apply_change(table, labels, history.mark_redone().change)
    if what == "alone":
        back = plan_undo_alone(history, labels, count)
        labels = apply_change(table, labels, back)
        history.add(history.draft(back, "2031-01-01T00:00:01.000Z", "somebody", undoes=count))
        return labels
    plans = {
        "swap": lambda: plan_swap(table, one, other, frame),
        "range": lambda: plan_swap(table, one, other, frame, frame + count),
        "split": lambda: plan_split(table, one, frame),
        "merge": lambda: plan_merge_tracks(table, one, [other]),
        "give": lambda: plan_reassign(table, one, other, frame, frame + count),
        "move": lambda: plan_move_box(table, one, frame, BOX),
        "draw": lambda: plan_draw_box(table, one, frame, BOX),
        "delete": lambda: plan_delete(table, one, frame, frame + count),
        "name": lambda: plan_rename(table, labels, one, f"from {frame}"),
    }
    return done(table, labels, history, plans[what]())


def plainly(table: TrackTable, history: History) -> tuple[Cells, Cells]:
    """Track and frame of all that is protected, and of what was deleted, cell by cell."""
    cells: Cells = set()
    deleted: list[tuple[int, int]] = []
    for entry in history:
        if entry.undone or history.taken_back_by(entry.id) or entry.undoes:
            continue
        cells = _handed_on(cells, entry) | _of_edit(entry)
        old, new = _cells(entry.change.before.rows), _cells(entry.change.after.rows)
        cells |= new
        deleted += sorted(old - new)
    rows = table.columns()
    cells |= _cells({name: rows[name][rows["source"] != Source.TRACKER] for name in rows})
    absent = set(deleted) - _cells(rows)
    return cells | absent, absent


def _cells(rows) -> Cells:
    return set(zip(rows["track"].tolist(), rows["frame"].tolist(), strict=True))


def _handed_on(cells: Cells, entry: Entry) -> Cells:
    change = entry.change
    to: dict[tuple[int, int], int] = {}
    sides = change.before.stretches.tolist(), change.after.stretches.tolist()
    for (track, start, end), (target, _, _) in zip(*sides, strict=True):
        to |= {(track, frame): target for frame in range(start, min(end, 2 * FRAMES))}
    return {(to.get((track, frame), track), frame) for track, frame in cells}


def _of_edit(entry: Entry) -> Cells:
    change = entry.change
    from_here_on = entry.kind == "split" or (entry.kind == "swap" and " on" in entry.text)
    sides = [*change.before.stretches.tolist(), *change.after.stretches.tolist()]
    if from_here_on:
        about = range(max(0, entry.frame - MARGIN), entry.frame + MARGIN)
        return {(track, frame) for track, _, _ in sides for frame in about}
    after = change.after.stretches.tolist()
    return {(track, frame) for track, start, end in after for frame in range(start, end)}


@settings(max_examples=150, deadline=None)
@given(EDITS)
def test_it_is_what_the_edits_say_one_after_the_other(drawn):
    table, labels, history = worked(drawn)
    cells, deleted = plainly(table, history)
    for log in (history, history.snapshot(), History(history.entries)):
        found = find_protected(table, labels, log, fps=FPS)
        assert _cells(found.deleted) == deleted
        stop = {track: table.frame_range(track)[1] for track in range(1, 30)}
        for track in range(1, 30):
            frames = np.arange(FRAMES + MARGIN)
            covered = found.covers(np.full(len(frames), track), frames)
            endless = {frame for t, frame in deleted if t == track and frame >= stop[track]}
            told = {(track, int(frame)) for frame in frames[covered]}
            expected = {cell for cell in cells if cell[0] == track and cell[1] < len(frames)}
            if endless:
                expected |= {(track, f) for f in range(min(endless), len(frames))}
                told |= {(track, f) for f in range(min(endless), len(frames))}
            assert told == expected


STEPS = st.lists(
    st.tuples(st.booleans(), st.integers(1, 3), st.integers(1, 3), *[st.integers(0, 30)] * 2),
    max_size=25,
)


@given(STEPS)
def test_coverage_is_a_set_of_cells(steps):
    coverage, cells = Coverage(), set()
    for adds, one, other, start, count in steps:
        end = start + count % 8 + 1
        if adds:
            coverage.add(one, start, end)
            cells |= {(one, frame) for frame in range(start, end)}
            continue
        coverage.hand([(one, other, start, end), (other, one, start, end)])
        swapped = {one: other, other: one}
        cells = {(swapped.get(t, t) if start <= f < end else t, f) for t, f in cells}
    told = coverage.stretches
    assert {(t, f) for t, s, e in told.tolist() for f in range(s, e)} == cells
    same = told[1:, 0] == told[:-1, 0]
    assert (told[1:, 1][same] > told[:-1, 2][same]).all()


def test_a_damaged_line_of_the_log_is_told():
    table, labels, history = worked([("move", 1, 1, 5, 1), ("swap", 1, 2, 9, 1)])
    first, second = history.entries
    for broken in (
        [replace(first, after='{"rows":{"count":1,"columns":"AAAA"}}'), second],
        [first, replace(second, after='{"stretches":[[1,2]]}')],
        [first, replace(second, before='["stretches"]')],
    ):
        with pytest.raises(EditError, match="in the log"):
            find_protected(table, labels, History(broken))


def test_a_long_log_is_read_once():
    table, labels, history = table_of(WALKS), Labels(), History()
    swap, move = plan_swap(table, 1, 2, 10, 20), plan_move_box(table, 3, 5, BOX)
    for change in [swap, swap, swap.inverse, move] * 1000:
        history.add(history.draft(change, "2031-01-01T00:00:00.000Z", "somebody"), change)
    first = find_protected(table, labels, history).stretches.tolist()
    with spent() as time:
        assert find_protected(table, labels, history.snapshot()).stretches.tolist() == first
    assert time.paces < 80
