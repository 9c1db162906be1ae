"""The list of all long work."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.core.jobs import job_list
from app.core.jobs.job_list import JobList, JobState


@pytest.fixture
def now_s(monkeypatch):
    """The time, to be changed."""
    now = [100.0]
    monkeypatch.setattr(job_list.time, "monotonic", lambda: now[0])
    return now


@pytest.fixture
def jobs(qapp):
    return JobList()


def test_it_tells_how_long_a_job_still_takes_once_that_can_be_known(jobs, now_s):
    number = jobs.begin("Exporting")
    now_s[0] += 1.0
    jobs.progress(number, 1, 10)
    assert jobs.lines[0].seconds_left is None
    now_s[0] += 4.0
    jobs.progress(number, 2, 10)
    line = jobs.lines[0]
    assert (line.share, line.seconds_left) == (pytest.approx(0.2), pytest.approx(20.0))


def test_what_runs_stands_first_and_what_ended_last_before_what_ended_earlier(jobs, now_s):
    first, second, third = (jobs.begin(name) for name in ("one", "two", "three"))
    now_s[0] += 10.0
    jobs.end(first, JobState.DONE)
    jobs.end(second, JobState.FAILED, word="the disk is full")
    assert [one.number for one in jobs.lines] == [third, second, first]
    assert jobs.lines[1].word == "the disk is full"
    assert [one.number for one in jobs.running] == [third]


def test_a_job_that_ended_cannot_be_cancelled_and_keeps_what_came_of_it(jobs, now_s):
    number = jobs.begin("Exporting", cancel=lambda: None)
    now_s[0] += 1.0
    assert jobs.lines[0].cancel is not None
    jobs.end(number, JobState.DONE, Path("clip.mp4"))
    assert (jobs.lines[0].cancel, jobs.lines[0].place) == (None, Path("clip.mp4"))


def test_what_was_done_in_a_moment_leaves_no_line_but_what_failed_does(jobs, now_s):
    jobs.end(jobs.begin("Saving"), JobState.DONE)
    assert jobs.lines == ()
    jobs.end(jobs.begin("Saving"), JobState.FAILED, word="why")
    assert len(jobs.lines) == 1


def test_it_does_not_grow_for_ever_and_can_be_cleared(jobs, now_s):
    for _ in range(50):
        jobs.end(jobs.begin("one"), JobState.DONE, Path("x"))
    running = jobs.begin("two")
    now_s[0] += 1.0
    assert len(jobs.lines) == 21
    jobs.forget()
    assert [one.number for one in jobs.lines] == [running]


def test_it_says_that_something_changed(jobs, qtbot):
    with qtbot.waitSignal(jobs.changed):
        number = jobs.begin("one")
    with qtbot.waitSignal(jobs.changed):
        jobs.progress(number, 1, 2)
    with qtbot.waitSignal(jobs.changed):
        jobs.end(number, JobState.STOPPED)


def test_what_is_done_within_a_second_is_never_shown(jobs, now_s):
    number = jobs.begin("Scoring")
    now_s[0] += 0.9
    assert jobs.running == ()
    jobs.end(number, JobState.DONE)
    assert jobs.lines == ()


def test_what_was_shown_stays_when_it_has_ended(jobs, now_s):
    number = jobs.begin("Scoring")
    now_s[0] += 1.1
    assert [one.title for one in jobs.running] == ["Scoring"]
    jobs.end(number, JobState.DONE)
    assert [(one.title, one.state) for one in jobs.lines] == [("Scoring", JobState.DONE)]


def test_it_says_when_a_second_is_over(jobs, qtbot):
    seen = []
    jobs.begin("Scoring")
    jobs.changed.connect(lambda: seen.append([one.title for one in jobs.running]))
    qtbot.waitUntil(lambda: seen == [["Scoring"]])


def test_of_what_is_done_again_and_again_the_last_time_is_kept(jobs, now_s):
    for state in (JobState.DONE, JobState.STOPPED, JobState.DONE):
        number = jobs.begin("Scoring")
        now_s[0] += 10.0
        jobs.end(number, state)
    assert [one.number for one in jobs.lines] == [number]


def test_time_left_is_counted_anew_where_it_begins_anew(jobs, now_s):
    number = jobs.begin("Scoring")
    now_s[0] += 100.0
    jobs.progress(number, 9, 10)
    jobs.restart(number)
    now_s[0] += 2.0
    jobs.progress(number, 1, 10)
    assert jobs.lines[0].seconds_left == pytest.approx(18.0)


def test_what_nobody_wants_any_more_goes_without_a_word(jobs, now_s):
    number = jobs.begin("Scoring")
    now_s[0] += 10.0
    jobs.drop(number)
    assert jobs.lines == ()


def test_another_list_goes_on_with_what_ended_and_begins_none_of_it_again(jobs, now_s, tmp_path):
    jobs.end(jobs.begin("one"), JobState.DONE, place=tmp_path)
    jobs.end(jobs.begin("two"), JobState.STOPPED, again=lambda: None)
    jobs.begin("three")
    now_s[0] += 10.0
    other = JobList()
    other.take_over(jobs.lines)
    assert [line.title for line in other.lines] == ["two", "one"]
    assert [line.place for line in other.lines] == [None, tmp_path]
    assert all(line.again is None for line in other.lines)
    assert other.begin("four") not in {line.number for line in jobs.lines[1:]}
