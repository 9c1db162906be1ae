"""The meter of boxes and edits an hour."""

from dataclasses import replace

import pytest

from app.features.correction.work_meter import PAUSE_S, WorkMeter
from tracking.editing import apply_change, plan_draw_box, plan_mark_occluded, plan_put_box
from tracking.tracks import Labels, TrackTable

BOX = (10.0, 20.0, 30.0, 40.0)


class Clock:
    """A clock that is put forward by hand."""

    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def meter(clock) -> WorkMeter:
    return WorkMeter(clock)


def _take(meter, clock, change, seconds: float) -> None:
    clock.now += seconds
    meter.take_change(change, None, {}, ())


def test_nothing_is_said_before_anything_was_done(meter):
    assert meter.text() == ""


def test_boxes_that_were_interpolated_count_and_those_undone_do_not(meter, clock):
    table = TrackTable()
    first = plan_draw_box(table, None, 0, BOX)
    apply_change(table, Labels(), first)
    later = plan_put_box(table, 1, 10, BOX)
    _take(meter, clock, first, 20)
    _take(meter, clock, later, 20)
    assert (meter.boxes, meter.edits) == (11, 2)
    assert meter.text() == "11 boxes  \u00b7  2 edits  \u00b7  990 boxes and 180 edits an hour"
    _take(meter, clock, later.inverse, 20)
    assert meter.boxes == 1


def test_a_break_is_no_working_time(meter, clock):
    _take(meter, clock, plan_draw_box(TrackTable(), None, 0, BOX), 3600)
    assert meter.worked_s == PAUSE_S


def test_too_short_a_time_gives_no_speed(meter, clock):
    _take(meter, clock, plan_draw_box(TrackTable(), None, 0, BOX), 2)
    assert meter.text() == "1 box  \u00b7  1 edit"


def test_who_draws_no_box_is_told_of_none(meter, clock):
    table = TrackTable()
    drawn = plan_draw_box(table, None, 0, BOX)
    apply_change(table, Labels(), drawn)
    _take(meter, clock, plan_mark_occluded(table, [1], 0, 1), 2)
    assert meter.text() == "1 edit"


def test_imported_boxes_are_nobody_s_work(meter, clock):
    drawn = plan_draw_box(TrackTable(), None, 0, BOX)
    imported = replace(drawn, kind="import")
    for change in (imported, imported.inverse, drawn):
        _take(meter, clock, change, 20)
    assert (meter.boxes, meter.edits, meter.worked_s) == (1, 1, 20)
