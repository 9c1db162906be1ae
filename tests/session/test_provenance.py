"""Whose a run's findings are after edits, wherever it is asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tracking.editing import (
    Change,
    apply_change,
    plan_delete,
    plan_move_box,
    plan_reassign,
    plan_swap,
)
from tracking.session import ids_by_now, parts_by_now
from tracking.tracks import (
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Labels,
    Particles,
    Run,
    TrackTable,
    empty,
)

FRAMES = 12
AT = 6
LEFT = {1: 100.0, 2: 180.0, 3: 400.0}
"""Three people of 30 by 80 px who stand still."""


def made_run() -> Run:
    tracks = {name: np.zeros(3 * FRAMES, dtype) for name, dtype in TRACK_COLUMNS.items()}
    tracks["frame"][:] = np.repeat(np.arange(FRAMES), 3)
    tracks["track"][:] = np.tile([1, 2, 3], FRAMES)
    tracks["left"][:] = np.tile(list(LEFT.values()), FRAMES)
    tracks["top"][:], tracks["width"][:], tracks["height"][:] = 50, 30, 80
    tracks["x"][:] = tracks["left"] / 40
    parts = {
        name: np.zeros(3 * len(tracks["frame"]), dtype) for name, dtype in PART_COLUMNS.items()
    }
    for name in ("frame", "track"):
        parts[name][:] = np.repeat(tracks[name], 3)
    parts["part"][:] = np.tile([0, 1, 2], len(tracks["frame"]))
    parts["cx"][:] = np.repeat(tracks["left"], 3)
    none = Particles.none(PARTICLE_COLUMNS)
    made = Run("three-part", {}, 0, (0, FRAMES), tracks, empty(DETECTION_COLUMNS), none)
    return replace(made, parts=parts)


@pytest.fixture
def run() -> Run:
    return made_run()


def after(run: Run, *plans: Callable[[TrackTable], Change]) -> TrackTable:
    table = TrackTable(run.tracks)
    for plan in plans:
        apply_change(table, Labels(), plan(table))
    return table


def moved(track: int, left: float, frame: int = AT) -> Callable[[TrackTable], Change]:
    return lambda table: plan_move_box(table, track, frame, (left, 50.0, 30.0, 80.0))


def whose(run: Run, table: TrackTable) -> dict[int, int]:
    """By track of the run its id in the frame; asked in all three ways, which must agree."""
    ids = ids_by_now(table, run, AT)
    person = {left: track for track, left in LEFT.items()}
    for frames in (None, (AT, AT + 1)):
        told: dict[int, int] = {}
        for track in table.track_ids:
            parts = parts_by_now(table, run, [track], frames)
            here = parts["frame"] == AT
            assert set(parts["track"].tolist()) <= {track}
            assert parts["part"][here].tolist() in ([], [0, 1, 2])
            told |= {person[left]: track for left in parts["cx"][here].tolist()}
        assert told == ids
    return ids


def test_unedited_everybody_has_their_own(run: Run) -> None:
    assert whose(run, after(run)) == {1: 1, 2: 2, 3: 3}


def test_what_was_renamed_goes_with_the_person(run: Run) -> None:
    table = after(run, lambda table: plan_reassign(table, 1, 9, 0, FRAMES))
    assert whose(run, table) == {1: 9, 2: 2, 3: 3}


def test_what_was_swapped_goes_with_the_person(run: Run) -> None:
    assert whose(run, after(run, lambda table: plan_swap(table, 1, 2, 3))) == {1: 2, 2: 1, 3: 3}


def test_a_box_that_was_moved_a_little_keeps_them(run: Run) -> None:
    assert whose(run, after(run, moved(1, 112.0))) == {1: 1, 2: 2, 3: 3}


def test_a_box_that_was_moved_far_keeps_them(run: Run) -> None:
    assert whose(run, after(run, moved(1, 300.0))) == {1: 1, 2: 2, 3: 3}


def test_boxes_that_were_moved_after_a_swap_are_found_by_where_they_are(run: Run) -> None:
    swapped = lambda table: plan_swap(table, 1, 2, 3)  # noqa: E731
    table = after(run, swapped, moved(1, 172.0), moved(2, 90.0))
    assert whose(run, table) == {1: 2, 2: 1, 3: 3}


def test_a_box_moved_onto_another_person_does_not_take_what_that_one_has(run: Run) -> None:
    assert whose(run, after(run, moved(1, 181.0))) == {1: 1, 2: 2, 3: 3}


def test_what_was_deleted_is_nobodys(run: Run) -> None:
    table = after(run, lambda table: plan_delete(table, 1, AT, AT + 1))
    assert whose(run, table) == {2: 2, 3: 3}
    table = after(run, lambda table: plan_delete(table, 1, AT, AT + 1), moved(2, 168.0))
    assert whose(run, table) == {2: 2, 3: 3}
