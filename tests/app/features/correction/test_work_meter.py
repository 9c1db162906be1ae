"""The meter of boxes and edits an hour."""

from dataclasses import replace

import pytest

from app.features.correction.work_meter import PAUSE_S, WorkMeter
from tracking.editing import History, apply_change, plan_draw_box, plan_mark_occluded, plan_put_box
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


@pytest.fixture
def log(meter) -> History:
    """The history of the session, as it is when the meter first looks."""
    log = History()
    meter.edits(log)
    return log


def _take(meter, clock, change, seconds: float, log: History | None = None) -> None:
    clock.now += seconds
    meter.take_change(change, None, {}, ())
    if log is not None:
        log.add(log.draft(change, "2026-01-01T00:00:00.000", "ann"))


def test_nothing_is_said_before_anything_was_done(meter):
    assert meter.text(None) == meter.text(History()) == ""


def test_boxes_that_were_interpolated_count_and_those_undone_do_not(meter, clock, log):
    table = TrackTable()
    first = plan_draw_box(table, None, 0, BOX)
    apply_change(table, Labels(), first)
    later = plan_put_box(table, 1, 10, BOX)
    _take(meter, clock, first, 20, log)
    _take(meter, clock, later, 20, log)
    assert (meter.boxes, meter.edits(log)) == (11, 2)
    assert meter.text(log) == "11 boxes  \u00b7  2 edits  \u00b7  990 boxes and 180 edits an hour"
    _take(meter, clock, later.inverse, 20)
    assert meter.boxes == 1


def test_a_break_is_no_working_time(meter, clock):
    _take(meter, clock, plan_draw_box(TrackTable(), None, 0, BOX), 3600)
    assert meter.worked_s == PAUSE_S


def test_too_short_a_time_gives_no_speed(meter, clock, log):
    _take(meter, clock, plan_draw_box(TrackTable(), None, 0, BOX), 2, log)
    assert meter.text(log) == "1 box  \u00b7  1 edit"


def test_who_draws_no_box_is_told_of_none(meter, clock, log):
    table = TrackTable()
    drawn = plan_draw_box(table, None, 0, BOX)
    apply_change(table, Labels(), drawn)
    _take(meter, clock, plan_mark_occluded(table, [1], 0, 1), 2, log)
    assert meter.text(log) == "1 edit"


def test_edits_in_force_count_and_neither_undo_nor_redo_does(meter, clock, log):
    table, labels = TrackTable(), Labels()
    first = plan_draw_box(table, None, 0, BOX)
    apply_change(table, labels, first)
    later = plan_put_box(table, 1, 10, BOX)
    _take(meter, clock, first, 5, log)
    _take(meter, clock, later, 5, log)
    log.mark_undone()
    _take(meter, clock, later.inverse, 5)
    assert meter.text(log) == "1 box  \u00b7  1 edit"
    log.mark_redone()
    _take(meter, clock, later, 5)
    assert meter.edits(log) == 2
    log.add(log.draft(later.inverse, "2026-01-01T00:00:00.000", "ann", undoes=2))
    assert meter.edits(log) == 1
    assert [entry.id for entry in log.in_force] == [1]


def test_edits_of_earlier_sittings_do_not_count(meter, log):
    log.add(log.draft(plan_draw_box(TrackTable(), None, 0, BOX), "2026-01-01", "ann"))
    later = WorkMeter(lambda: 0.0)
    assert later.edits(log) == 0


def test_the_edit_that_begins_a_session_counts(meter, clock):
    assert meter.edits(None) == 0  # there is no session yet
    log = History()
    _take(meter, clock, plan_draw_box(TrackTable(), None, 0, BOX), 2, log)
    assert meter.edits(log) == 1


def test_who_takes_back_earlier_edits_is_told_of_those_made_since(clock):
    log = History()
    for frame in range(4):
        change = plan_draw_box(TrackTable(), None, frame, BOX)
        log.add(log.draft(change, "2026-01-01T00:00:00.000", "ann"))
    meter = WorkMeter(clock)
    assert meter.edits(log) == 0
    log.mark_undone()
    log.mark_undone()
    _take(meter, clock, plan_draw_box(TrackTable(), None, 9, BOX), 2, log)
    assert meter.edits(log) == 1


def test_imported_boxes_are_nobody_s_work(meter, clock, log):
    drawn = plan_draw_box(TrackTable(), None, 0, BOX)
    imported = replace(drawn, kind="import")
    for change in (imported, drawn):
        _take(meter, clock, change, 20, log)
    assert (meter.boxes, meter.edits(log), meter.worked_s) == (1, 1, 20)
