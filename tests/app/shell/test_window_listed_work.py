"""All long work of the window stands in one list, whoever runs it."""

from __future__ import annotations

import threading
from types import SimpleNamespace

import pytest
from patient import PATIENCE_S

from app.core.jobs.job_list import JobList, JobState
from app.core.widgets.jobs_dialog import JobsDialog
from app.shell.listed_work import ListedWork


@pytest.fixture
def titles(window):
    """What runs, by title."""
    return lambda: [one.title for one in window.work.jobs.running]


def test_the_tracker_at_work_is_listed_and_cancelled_from_the_list(
    window, qtbot, tiny_recording, titles
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
    window.controller.tracking.track("stereo-direction")
    qtbot.waitUntil(lambda: titles() == ["Tracking with stereo-direction"])
    (line,) = window.work.jobs.running
    line.cancel()
    qtbot.waitUntil(lambda: titles() == [])
    assert not window.controller.live.running
    assert "not kept" in window.statusBar().currentMessage()


def test_what_may_end_with_a_result_is_stopped_so_from_the_list(window, controller, qtbot):
    jobs, kept = window.work.jobs, []
    number = jobs.begin("Tracking", lambda: None)
    jobs.show(number, 0.2, None)
    qtbot.waitUntil(lambda: bool(jobs.running))
    window.show_jobs()
    dialog = window.findChild(JobsDialog)
    row = dialog._rows[number]
    assert not row._keep.isVisible()
    jobs.show(number, 0.5, None, lambda: kept.append(number))
    qtbot.waitUntil(row._keep.isVisible)
    row._keep.click()
    assert kept == [number]
    dialog.close()


def test_the_tracker_at_work_may_keep_its_result_once_there_is_one(qapp):
    jobs, listed = JobList(), []
    work, live = ListedWork(jobs), SimpleNamespace(running=True, tracker="flow")
    live.share = live.seconds_left = None
    for keep in (None, listed.append):
        work.take_tracking(live, lambda: None, keep)
        assert jobs._lines[1].keep is keep


def test_work_that_all_else_waits_for_is_listed_with_its_progress(window, controller, qtbot):
    go_on = threading.Event()

    def work(report):
        report(1, 2)
        go_on.wait(PATIENCE_S)

    window.work.run("Scoring everything", work, lambda _: None)
    qtbot.waitUntil(lambda: bool(window.work.jobs.running and window.work.jobs.running[0].share))
    line = window.work.jobs.running[0]
    assert (line.title, line.share) == ("Scoring everything", 0.5)
    go_on.set()
    qtbot.waitUntil(lambda: not window.work.jobs.running)


def test_work_that_is_not_to_be_stopped_has_no_cancel(window, controller, qtbot):
    go_on = threading.Event()
    work = lambda _: go_on.wait(PATIENCE_S)  # noqa: E731
    window.work.run("Saving all", work, lambda _: None, cancellable=False)
    qtbot.waitUntil(lambda: bool(window.work.jobs.running))
    assert window.work.jobs.running[0].cancel is None
    go_on.set()
    qtbot.waitUntil(lambda: not window.work.busy)


def test_the_list_tells_what_came_of_each(window, controller, qtbot, tmp_path):
    def fails(_):
        raise OSError(28, "No space left on device")

    window.work.run_behind("One", lambda report: report(1, 1), "done", tmp_path / "one.mp4")
    window.work.run_behind("Two", fails, "done")
    qtbot.waitUntil(lambda: len(window.work.jobs.lines) == 2 and not window.work.jobs.running)
    states = {one.title: one.state for one in window.work.jobs.lines}
    assert states == {"One": JobState.DONE, "Two": JobState.FAILED}
    window.show_jobs()
    dialog = window.findChild(JobsDialog)
    words = [row._word.text() for row in dialog._rows.values()]
    assert any("one.mp4" in word for word in words)
    assert any(word.startswith("Failed: ") for word in words)
    dialog._clear.click()
    qtbot.waitUntil(lambda: not dialog._rows)
    dialog.close()


def test_two_pieces_of_work_go_on_side_by_side(window, controller, qtbot, titles):
    go_on = threading.Event()
    for name in ("One", "Two"):
        window.work.run_behind(name, lambda _: go_on.wait(PATIENCE_S), "done")
    qtbot.waitUntil(lambda: titles() == ["One", "Two"])
    assert not window.work.busy
    go_on.set()
    qtbot.waitUntil(lambda: titles() == [])
