"""What shows nothing but boxes that a person made is not flagged unless that is asked for."""

from __future__ import annotations

import numpy as np
import pytest
from walks_on_a_floor import FPS, SIZE, Walk, crossing, made_run, straight

from tracking.editing import apply_change, plan_swap
from tracking.review import ReviewItem, find_review_items
from tracking.tracks import Labels, Run, Source, TrackTable


def table_of(run: Run, start: int, end: int, tracks: tuple[int, ...] = (1, 2)) -> TrackTable:
    """The run's tracks, some frames of some tracks made by a person."""
    table = TrackTable(run.tracks)
    columns = dict(table.columns())
    frame = columns["frame"]
    made = (frame >= start) & (frame < end) & np.isin(columns["track"], tracks)
    columns["source"] = np.where(made, Source.PERSON, columns["source"]).astype(np.uint8)
    return TrackTable(columns)


def found(run: Run, table: TrackTable, *, hand_made: bool = False) -> tuple[ReviewItem, ...]:
    return find_review_items(table, run, FPS, size=SIZE, hand_made=hand_made)


def test_tracks_drawn_by_a_person_are_quiet_and_all_is_flagged_where_that_is_asked() -> None:
    run = made_run(crossing())
    assert found(run, TrackTable(run.tracks))
    drawn = table_of(run, 0, 1000)
    assert found(run, drawn) == ()
    assert found(run, drawn, hand_made=True)


def test_a_corrected_stretch_of_a_trackers_tracks_is_quiet_and_the_rest_is_not() -> None:
    path = straight((-3, 5), (1, 0), 300)
    path[80:] += (0.0, 0.8)
    path[220:] += (0.0, 0.8)
    run = made_run([Walk(path)])
    assert {one.frame for one in found(run, TrackTable(run.tracks))} >= {80, 220}
    left = {one.frame for one in found(run, table_of(run, 40, 120))}
    assert 80 not in left
    assert 220 in left


def test_where_only_one_of_two_was_drawn_the_other_may_be_wrong() -> None:
    run = made_run(crossing())
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan_swap(table, 1, 2, 80))
    of_both = {one.key for one in found(run, table) if one.tracks == (1, 2)}
    one_drawn = table_of(run, 0, 1000, (1,))
    assert of_both
    assert any(set(one.tracks) == {1, 2} for one in found(run, one_drawn))


@pytest.mark.parametrize("drawn", [(0, 100), (0, 1000)])
def test_an_end_midway_that_a_person_drew_is_quiet(drawn: tuple[int, int]) -> None:
    path = straight((-2, 5), (0.5, 0), 100)
    run = made_run([Walk(path), Walk(straight((-3, 8), (0.5, 0), 300))])
    ends = [one for one in found(run, TrackTable(run.tracks)) if 1 in one.tracks]
    assert ends
    quiet = [one for one in found(run, table_of(run, *drawn, (1,))) if one.tracks == (1,)]
    assert quiet == []
