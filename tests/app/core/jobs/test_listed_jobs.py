"""Work off the window's thread puts itself into the list of its window, whoever begins it."""

from __future__ import annotations

import threading

import pytest
from PySide6.QtCore import QObject

from app.core.jobs import job_list
from app.core.jobs.job_list import JobList, JobState
from app.core.jobs.jobs import Job
from app.core.jobs.latest_job import LatestJob
from app.core.jobs.listed_job import job_list_of
from tracking.errors import FormatError


@pytest.fixture
def place(qapp, no_threads_left):
    """Something deep in a window with a list of work."""
    window = QObject()
    JobList(window)
    yield QObject(QObject(window))
    window.deleteLater()


@pytest.fixture
def jobs(place, monkeypatch):
    """The list; it shows and tells of work of any length."""
    monkeypatch.setattr(job_list, "_SHOW_AFTER_S", 0.0)
    monkeypatch.setattr(job_list, "_BRIEF_S", 0.0)
    return job_list_of(place)


@pytest.fixture
def words(jobs):
    """What the list said."""
    said = []
    jobs.told.connect(said.append)
    return said


class Gate:
    """Work that goes on until it is let through, and stops where it is cancelled."""

    def __init__(self):
        self.open = threading.Event()
        self.begun = 0

    def __call__(self, report):
        self.begun += 1
        while not self.open.wait(0.01):
            report(1, 4)
        return "result"


def states(jobs):
    """Titles and states of all lines."""
    return [(one.title, one.state) for one in jobs.lines]


def test_a_job_stands_in_the_list_of_the_window_it_belongs_to(place, jobs, words, qtbot):
    gate = Gate()
    job = Job("Looking", gate, place)
    job.start()
    qtbot.waitUntil(lambda: bool(jobs.running and jobs.running[0].share))
    assert (jobs.running[0].title, jobs.running[0].share) == ("Looking", 0.25)
    gate.open.set()
    qtbot.waitUntil(lambda: states(jobs) == [("Looking", JobState.DONE)])
    assert words == ["Done: Looking"]


def test_a_job_is_cancelled_from_the_list(place, jobs, words, qtbot):
    job, told = Job("Looking", Gate(), place), []
    job.cancelled.connect(lambda: told.append("cancelled"))
    job.start()
    jobs.running[0].cancel()
    qtbot.waitUntil(lambda: told == ["cancelled"])
    assert states(jobs) == [("Looking", JobState.STOPPED)]
    assert words == ["Stopped: Looking"]


def test_what_cannot_be_cancelled_offers_none(place, jobs, qtbot):
    gate = Gate()
    job = Job("Looking", gate, place, cancellable=False)
    job.start()
    assert jobs.running[0].cancel is None
    gate.open.set()
    qtbot.waitSignal(job.done).wait()


def test_a_job_that_goes_with_its_place_leaves_no_line(place, jobs, qtbot):
    job = Job("Looking", Gate(), place)
    job.start()
    assert len(jobs.running) == 1
    job.leave_untold()
    assert jobs.lines == ()
    job.wait()
    qtbot.wait(20)


def test_a_job_without_a_window_works_as_well(qapp, qtbot, no_threads_left):
    owner = QObject()
    job = Job("Looking", lambda _: 1, owner)
    with qtbot.waitSignal(job.done):
        job.start()


def test_what_failed_after_a_while_stands_there_with_why(place, jobs, qtbot):
    def fail(_):
        raise FormatError("no such column")

    job = Job("Looking", fail, place)
    with qtbot.waitSignal(job.failed):
        job.start()
    assert [(one.state, one.word) for one in jobs.lines] == [(JobState.FAILED, "no such column")]


@pytest.fixture
def gates():
    """The work of each subject."""
    return {}


@pytest.fixture
def latest(place, gates):
    def prepare(subject):
        return gates.setdefault(subject, Gate())

    latest = LatestJob("Scoring", prepare, place)
    yield latest
    latest.stop()
    for job in latest.findChildren(Job):
        job.wait()


def test_one_line_stands_for_all_that_is_asked_one_after_the_other(latest, gates, jobs, qtbot):
    found, lines = [], set()
    latest.found.connect(found.append)
    jobs.changed.connect(lambda: lines.add(tuple(one.number for one in jobs.lines)))
    latest.ask("first")
    qtbot.waitUntil(lambda: "first" in gates and bool(jobs.running))
    latest.ask("second")
    gates["second"] = Gate()
    for name in ("first", "second"):
        gates[name].open.set()
    qtbot.waitUntil(lambda: len(found) == 2)
    assert len(lines - {()}) == 1
    assert states(jobs) == [("Scoring", JobState.DONE)]


def test_what_was_cancelled_begins_again_only_where_that_is_asked(latest, gates, jobs, qtbot):
    cancelled, found = [], []
    latest.cancelled.connect(lambda *told: cancelled.append(told))
    latest.found.connect(found.append)
    latest.ask("one")
    qtbot.waitUntil(lambda: bool(jobs.running))
    jobs.running[0].cancel()
    qtbot.waitUntil(lambda: len(cancelled) == 1)
    assert cancelled[0][0] == "one"
    assert "starts it again" in str(cancelled[0][1])
    latest.ask("one")
    assert not latest.busy
    (line,) = jobs.lines
    assert line.state is JobState.STOPPED
    gates["one"].open.set()
    line.again()
    qtbot.waitUntil(lambda: found == ["result"])
    assert states(jobs) == [("Scoring", JobState.DONE)]


def test_a_cancelled_search_is_begun_anew_by_another_subject(latest, gates, jobs, qtbot):
    found = []
    latest.found.connect(found.append)
    latest.ask("one")
    qtbot.waitUntil(lambda: bool(jobs.running))
    jobs.running[0].cancel()
    qtbot.waitUntil(lambda: not latest.busy)
    gates["two"] = Gate()
    gates["two"].open.set()
    latest.ask("two")
    qtbot.waitUntil(lambda: found == ["result"])
    assert states(jobs) == [("Scoring", JobState.DONE)]


def test_what_was_cancelled_cannot_begin_again_once_its_place_has_gone(latest, jobs, qtbot):
    latest.ask("one")
    qtbot.waitUntil(lambda: bool(jobs.running))
    jobs.running[0].cancel()
    qtbot.waitUntil(lambda: not latest.busy)
    latest.stop()
    assert jobs.lines == ()
