"""The frames that edits are made for, as the log tells them; what is protected hangs on none."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from runs_of_people import FPS, done, run_of, table_of

from tracking.editing import (
    Change,
    History,
    Scope,
    apply_change,
    find_protected,
    plan_add_keyframe,
    plan_delete_keyframe,
    plan_draw_box,
    plan_fill_gaps,
    plan_mark_reviewed,
    plan_move_box,
    plan_take,
    plan_unmark_reviewed,
)
from tracking.tracks import Labels, ReviewedRange, TrackTable

BOX = (1.0, 2.0, 30.0, 60.0)
Plan = Callable[[TrackTable, Labels, History], Change]
EDITS: dict[str, tuple[Plan, Scope]] = {
    "reviewed": (
        lambda _, labels, __: plan_mark_reviewed(labels, [1, 2], 20, 40),
        Scope(20, 40),
    ),
    "unreviewed": (
        lambda _, labels, __: plan_unmark_reviewed(labels, 3, 25, 30),
        Scope(25, 30),
    ),
    "taken": (
        lambda table, labels, history: plan_take(
            table, labels, history, run_of([(1, 0, 100, 5.0)], (0, 100)), (30, 60)
        ),
        Scope(30, 60),
    ),
    "gaps filled": (lambda table, *_: plan_fill_gaps(table, [2], 10), Scope(20, 55)),
    "drawn": (lambda table, *_: plan_draw_box(table, 3, 70, BOX), Scope(70, 71)),
    "drawn and joined": (
        lambda table, *_: plan_draw_box(table, 3, 65, BOX, join=True),
        Scope(60, 66),
    ),
    "moved": (lambda table, *_: plan_move_box(table, 1, 7, BOX), Scope(7, 8)),
    "made a keyframe": (lambda table, *_: plan_add_keyframe(table, 1, 8), Scope(8, 9)),
    "keyframe let go": (lambda table, *_: plan_delete_keyframe(table, 1, 9), Scope(9, 10)),
}


def state() -> tuple[TrackTable, Labels, History]:
    """Track 2 has gaps at 20 to 25 and 50 to 55; frame 9 of track 1 is a keyframe."""
    table = table_of(
        [(1, 0, 100, 0.0), (2, 0, 20, 1.0), (2, 25, 50, 1.0), (2, 55, 99, 1.0), (3, 0, 60, 2.0)]
    )
    labels = Labels(reviewed=(ReviewedRange(3, 20, 40),))
    apply_change(table, labels, plan_add_keyframe(table, 1, 9))
    return table, labels, History()


@pytest.mark.parametrize("name", EDITS)
def test_an_edit_keeps_the_frames_it_was_made_for(name: str) -> None:
    plan, scope = EDITS[name]
    assert plan(*state()).scope == scope


@pytest.mark.parametrize("name", EDITS)
def test_what_is_protected_is_the_same_without_the_scope(name: str) -> None:
    found = []
    for scope in (EDITS[name][1], None):
        table, labels, history = state()
        change = replace(EDITS[name][0](table, labels, history), scope=scope)
        labels = done(table, labels, history, change)
        found.append(find_protected(table, labels, history, fps=FPS).stretches.tolist())
    assert found[0] == found[1]
