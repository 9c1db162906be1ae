import threading

import numpy as np
import pytest
import shiboken6
from patient import PATIENCE_S
from PySide6.QtCore import QObject

from app.core.jobs.jobs import Job
from app.core.playback import late_camera
from app.core.playback.frames import FrameReader
from app.core.widgets.progress_strip import ProgressStrip
from app.core.widgets.work import Work
from tracking.errors import CancelledError, OutputError, RecordingError
from tracking.recording import open_recording


@pytest.fixture
def strip(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    return strip


@pytest.fixture
def work(strip, no_threads_left):
    work = Work(strip, strip)
    yield work
    work.close()


def test_a_job_gives_its_result_in_the_thread_it_was_started_from(work, qtbot):
    threads = []
    work.run(
        "Counting",
        lambda _: threads.append(threading.current_thread()) or 42,
        lambda result: threads.append((threading.current_thread(), result)),
    )
    qtbot.waitUntil(lambda: len(threads) == 2)
    assert threads[0] is not threading.current_thread()
    assert threads[1] == (threading.current_thread(), 42)
    assert not work.busy


def test_one_job_may_begin_another(work, qtbot):
    results = []
    work.run(
        "First", lambda _: 1, lambda one: work.run("Second", lambda _: one + 1, results.append)
    )
    qtbot.waitUntil(lambda: results == [2])
    assert not work.busy


def test_while_a_job_runs_a_second_is_refused_with_a_word(work, qtbot):
    go, said, results = threading.Event(), [], []
    work.said.connect(said.append)
    work.run("First", lambda _: go.wait(PATIENCE_S), results.append)
    work.run("Second", lambda _: 2, results.append)
    go.set()
    qtbot.waitUntil(lambda: results == [True])
    assert said == ["Wait until the work in progress is done"]


def test_cancelled_work_stops_at_its_next_word_and_is_undone(work, strip, qtbot):
    undone = []

    def count(progress) -> None:
        while True:  # work that could end by itself may end before it is cancelled
            progress(1, 9)

    work.run("Counting", count, lambda _: undone.append("done"), lambda: undone.append("undone"))
    qtbot.wait(20)
    assert strip.isVisibleTo(strip.parentWidget())
    work.cancel()
    qtbot.waitUntil(lambda: undone == ["undone"])
    assert strip.isHidden()


def test_failed_work_is_told_with_its_error(work, qtbot):
    told = []

    def fail(_) -> None:
        raise OutputError("disk full")

    work.failed.connect(told.append)
    work.run("Saving", fail, told.append)
    qtbot.waitUntil(lambda: len(told) == 1)
    assert str(told[0]) == "disk full"


def test_closing_waits_for_the_work(work):
    work.run("Waiting", lambda progress: [progress(n, 9) for n in iter(int, 1)], lambda _: None)
    work.close()
    assert not work.busy


def test_a_job_reports_how_far_it_is(qtbot, no_threads_left):
    parent, steps = QObject(), []
    job = Job("Counting", lambda progress: progress(3, 3), parent)
    job.progressed.connect(lambda done, total: steps.append((done, total)))
    with qtbot.waitSignal(job.done):
        job.start()
    assert steps == [(3, 3)]


@pytest.fixture
def reader(tiny_recording, no_threads_left):
    parent = QObject()
    with open_recording(tiny_recording) as recording:
        reader = FrameReader(recording, 50_000_000, parent)
        yield reader
        reader.close()


def test_the_newest_request_is_answered_with_both_cameras_of_its_frame(reader, qtbot):
    answers = []
    reader.ready.connect(lambda ticket, frame: answers.append((ticket, frame)))
    for number in (3, 9, 27):
        ticket = reader.request(number)
    qtbot.waitUntil(lambda: bool(answers) and answers[-1][0] == ticket)
    frame = answers[-1][1]
    assert frame.number == 27
    assert frame.left.shape == frame.right.shape
    assert not np.array_equal(frame.left, frame.right)


def test_what_comes_next_is_read_ahead_in_the_play_direction(reader, qtbot):
    reader.request(40, -1)
    qtbot.waitUntil(lambda: reader.get_cached(35) is not None)
    assert reader.get_cached(45) is None


def test_a_frame_that_is_not_there_is_told_and_the_next_request_works(reader, qtbot):
    with qtbot.waitSignal(reader.failed) as told:
        reader.request(9999)
    assert isinstance(told.args[1], RecordingError)
    with qtbot.waitSignal(reader.ready) as answer:
        reader.request(5)
    assert answer.args[1].number == 5


def test_a_bug_in_reading_is_told_and_the_next_request_works(reader, qtbot, monkeypatch):
    read = reader._cache.read

    def stumble(frame):
        monkeypatch.setattr(reader._cache, "read", read)
        raise ValueError("nobody expected this")

    monkeypatch.setattr(reader._cache, "read", stumble)
    with qtbot.waitSignal(reader.failed) as told:
        reader.request(7)
    assert isinstance(told.args[1], ValueError)
    with qtbot.waitSignal(reader.ready):
        reader.request(5)


@pytest.mark.parametrize("fails", [False, True])
def test_a_reader_that_goes_while_it_reads_ends_in_silence(
    tiny_recording, no_threads_left, monkeypatch, fails
):
    parent, reading, go, fell = QObject(), threading.Event(), threading.Event(), []
    monkeypatch.setattr(threading, "excepthook", fell.append)
    with open_recording(tiny_recording) as recording:
        reader = FrameReader(recording, 50_000_000, parent)
        read, thread = reader._cache.read, reader._thread

        def slow(frame):
            reading.set()
            go.wait(PATIENCE_S)
            return read(9999 if fails else frame)

        monkeypatch.setattr(reader._cache, "read", slow)
        reader.request(7)
        assert reading.wait(PATIENCE_S)
        shiboken6.delete(parent)
        go.set()
        thread.join(PATIENCE_S)
    assert not thread.is_alive()
    assert fell == []


def test_playing_never_waits_for_the_search_for_a_late_camera(reader, qtbot, monkeypatch):
    go = threading.Event()

    def slow(_recording, start):
        yield start
        go.wait(PATIENCE_S)

    monkeypatch.setattr(late_camera, "lag_looks", slow)
    reader.request(10)
    qtbot.waitUntil(lambda: reader.get_cached(20) is not None)
    with qtbot.waitSignal(reader.ready) as answer:
        reader.request(60)
    assert answer.args[1].number == 60
    go.set()


def test_a_search_for_a_late_camera_ends_when_the_reader_is_closed(reader, qtbot, monkeypatch):
    looked = threading.Event()

    def endless(_recording, start):
        while True:
            yield start
            looked.set()

    monkeypatch.setattr(late_camera, "lag_looks", endless)
    reader.request(10)
    qtbot.waitUntil(looked.is_set)
    reader.close()
    assert not any(thread.name == "late camera" for thread in threading.enumerate())


def test_a_bug_in_the_search_for_a_late_camera_is_logged_and_frames_are_read_on(
    reader, qtbot, monkeypatch, caplog
):
    def stumble(_recording, start):
        yield start
        raise ValueError("nobody expected this")

    monkeypatch.setattr(late_camera, "lag_looks", stumble)
    reader.request(10)
    qtbot.waitUntil(lambda: "nobody expected this" in caplog.text)
    with qtbot.waitSignal(reader.ready) as answer:
        reader.request(60)
    assert answer.args[1].number == 60


def test_a_job_may_go_with_its_parent_while_its_work_goes_on(qtbot, no_threads_left):
    parent, begun, go = QObject(), threading.Event(), threading.Event()
    told, asked_to_stop = [], []

    def work(progress) -> None:
        begun.set()
        go.wait(PATIENCE_S)
        try:
            progress(1, 2)
        except CancelledError:
            asked_to_stop.append(True)
            raise

    job = Job("Reading", work, parent)
    job.done.connect(told.append)
    job.cancelled.connect(lambda: told.append("cancelled"))
    job.start()
    assert begun.wait(PATIENCE_S)
    shiboken6.delete(parent)
    assert not shiboken6.isValid(job)
    go.set()
    job.wait()
    qtbot.wait(20)
    assert (asked_to_stop, told) == ([True], [])


def test_a_job_may_go_after_its_work_ended_and_before_that_is_told(qtbot, no_threads_left):
    parent, told = QObject(), []
    job = Job("Reading", lambda _: 1, parent)
    job.done.connect(told.append)
    job.start()
    job.wait()
    shiboken6.delete(parent)
    qtbot.wait(20)
    assert told == []


def test_work_that_begins_while_other_work_is_stopping_can_be_cancelled(work, strip, qtbot):
    strip.show_scene("Tracking", None, stoppable=True)
    strip._cancel.click()
    go = threading.Event()
    work.run("Counting", lambda _: go.wait(PATIENCE_S), lambda _: None)
    assert strip._cancel.isEnabled()
    go.set()
    qtbot.waitUntil(lambda: not work.busy)


def test_work_that_cannot_be_cancelled_never_offers_it(work, strip, qtbot):
    go = threading.Event()

    def counted(progress):
        progress(1, 2)
        go.wait(PATIENCE_S)

    work.run("Counting", counted, lambda _: None, cancellable=False)
    qtbot.waitUntil(lambda: strip._bar.maximum() > 0)
    assert strip._cancel.isHidden()
    go.set()
    qtbot.waitUntil(lambda: not work.busy)
