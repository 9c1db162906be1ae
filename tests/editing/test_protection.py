"""What tracking again never overwrites."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from runs_of_people import FPS, done, run_of, table_of

from tracking.editing import (
    History,
    Protection,
    apply_change,
    find_protected,
    plan_delete,
    plan_draw_box,
    plan_label_part,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_move_box,
    plan_reassign,
    plan_rename,
    plan_split,
    plan_swap,
    plan_take,
    plan_undo_alone,
)
from tracking.editing.tracking_again.protection import join_stretches
from tracking.tracks import LARGEST_NUMBER, Labels, PartLabel, TrackTable

BOX = (1.0, 2.0, 30.0, 60.0)
STRETCHES = st.lists(
    st.tuples(st.integers(0, 3), st.integers(0, 30), st.integers(1, 8)), max_size=12
)


@pytest.fixture
def table() -> TrackTable:
    return table_of([(1, 0, 100, 0.0), (2, 0, 100, 1.0), (3, 0, 60, 2.0)])


def after(table: TrackTable, *plans: object) -> dict[int, list[list[int]]]:
    """What is protected of each track after edits, planned one after the other."""
    labels, history = Labels(), History()
    for plan in plans:
        labels = done(table, labels, history, plan(labels))
    found = find_protected(table, labels, history, fps=FPS)
    return {track: found.of_track(track).tolist() for track in range(1, 6)}


def only(**tracks: list[list[int]]) -> dict[int, list[list[int]]]:
    return {track: tracks.get(f"of{track}", []) for track in range(1, 6)}


def test_nothing_is_protected_where_nobody_did_anything(table: TrackTable):
    assert after(table) == only()


def test_rows_that_a_person_moved_or_drew_are_protected(table: TrackTable):
    assert after(
        table,
        lambda _: plan_move_box(table, 1, 7, BOX),
        lambda _: plan_move_box(table, 1, 8, BOX),
        lambda _: plan_draw_box(table, 3, 80, BOX),
    ) == only(of1=[[7, 9]], of3=[[80, 81]])


def test_a_reviewed_range_is_protected_of_its_track(table: TrackTable):
    assert after(table, lambda labels: plan_mark_reviewed(labels, 2, 10, 20)) == only(
        of2=[[10, 20]]
    )


def test_a_range_reviewed_for_all_is_protected_of_everybody(table: TrackTable):
    found = after(table, lambda labels: plan_mark_reviewed(labels, 0, 10, 20))
    assert all(stretches == [[10, 20]] for stretches in found.values())


def test_a_swap_in_a_range_is_protected_there(table: TrackTable):
    assert after(table, lambda _: plan_swap(table, 1, 2, 30, 40)) == only(
        of1=[[30, 40]], of2=[[30, 40]]
    )


def test_a_swap_from_here_on_is_protected_about_its_cut_only(table: TrackTable):
    assert after(table, lambda _: plan_swap(table, 1, 2, 30)) == only(
        of1=[[20, 40]], of2=[[20, 40]]
    )


def test_a_split_is_protected_about_its_cut_on_both_sides(table: TrackTable):
    assert after(table, lambda _: plan_split(table, 2, 50)) == only(of2=[[40, 60]], of4=[[40, 60]])


def test_tracks_given_to_another_stay_with_it(table: TrackTable):
    assert after(table, lambda _: plan_reassign(table, 1, 3, 70, 90)) == only(of3=[[70, 90]])


def test_tracks_that_were_merged_stay_merged(table: TrackTable):
    apart = table_of([(1, 0, 40, 0.0), (2, 50, 90, 0.0)])
    assert after(apart, lambda _: plan_merge_tracks(apart, 1, [2])) == only(of1=[[50, 90]])


def test_what_was_deleted_stays_away(table: TrackTable):
    assert after(table, lambda _: plan_delete(table, 1, 30, 40)) == only(of1=[[30, 40]])


def test_a_track_that_was_ended_does_not_go_on_later(table: TrackTable):
    assert after(table, lambda _: plan_delete(table, 3, 50)) == only(of3=[[50, LARGEST_NUMBER]])


def test_what_was_deleted_and_drawn_again_counts_as_drawn(table: TrackTable):
    labels, history = Labels(), History()
    labels = done(table, labels, history, plan_delete(table, 1, 30, 31))
    done(table, labels, history, plan_draw_box(table, 1, 30, BOX))
    found = find_protected(table, labels, history, fps=FPS)
    assert found.of_track(1).tolist() == [[30, 31]]
    assert len(found.deleted["frame"]) == 0


def test_bodies_whose_parts_were_drawn_are_protected(table: TrackTable):
    part = PartLabel(12, 1, 0, (1.0, 2.0, 3.0, 4.0))
    suggested = replace(part, frame=20, source="tracker")
    assert after(table, lambda labels: plan_label_part(labels, [part, suggested])) == only(
        of1=[[12, 13]]
    )


def test_names_protect_no_rows(table: TrackTable):
    assert after(table, lambda labels: plan_rename(table, labels, 1, "red coat")) == only()


def test_what_was_taken_from_a_run_is_not_protected(table: TrackTable):
    run = run_of([(1, 0, 100, 0.1), (2, 0, 100, 1.1), (3, 0, 60, 2.1)], (0, 100), known=3)
    assert after(table, lambda labels: plan_take(table, labels, History(), run, None)) == only()


def test_protection_goes_with_rows_that_are_given_to_another_track(table: TrackTable):
    found = after(
        table,
        lambda _: plan_swap(table, 1, 2, 60, 70),
        lambda _: plan_swap(table, 1, 3, 40),
    )
    assert found == only(of1=[[30, 50]], of2=[[60, 70]], of3=[[30, 50], [60, 70]])


def test_edits_that_were_undone_protect_nothing(table: TrackTable):
    labels, history = Labels(), History()
    change = plan_swap(table, 1, 2, 30, 40)
    done(table, labels, history, change)
    apply_change(table, labels, change.inverse)
    history.mark_undone()
    assert len(find_protected(table, labels, history).stretches) == 0


def test_an_edit_undone_alone_protects_nothing(table: TrackTable):
    labels, history = Labels(), History()
    done(table, labels, history, plan_swap(table, 1, 2, 30, 40))
    done(table, labels, history, plan_move_box(table, 3, 5, BOX))
    back = plan_undo_alone(history, labels, 1)
    apply_change(table, labels, back)
    history.add(history.draft(back, "2031-01-01T00:00:01.000Z", "somebody", undoes=1))
    assert find_protected(table, labels, history).stretches.tolist() == [[3, 5, 6]]


@given(STRETCHES, st.integers(1, 3), st.integers(0, 40))
def test_joined_stretches_cover_the_same_frames(
    drawn: list[tuple[int, int, int]], track: int, frame: int
):
    stretches = np.array([(t, s, s + n) for t, s, n in drawn], np.int64).reshape(-1, 3)
    joined = join_stretches(stretches)
    expected = any(t in (0, track) and s <= frame < e for t, s, e in stretches.tolist())
    found = Protection(joined).covers(np.array([track]), np.array([frame]))
    assert found.tolist() == [expected]
    same = joined[1:, 0] == joined[:-1, 0]
    assert (joined[1:, 1][same] > joined[:-1, 2][same]).all()
