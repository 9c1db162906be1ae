"""Tracking again from a frame, what would change, and the runs there are by then."""

import threading
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.presenters.comparing.differences import Comparison
from app.presenters.files import opening
from app.presenters.runs.runs import CORRECTED
from app.presenters.words import span_text
from app.views.desk.again import show_runs
from app.views.runs.runs_dialog import RunsDialog
from app.views.runs.track_dialog import TrackDialog
from tracking.editing import plan_delete, plan_mark_reviewed
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, empty

AGAIN_AT = 50
SHIFTED = (58, 72)


@pytest.fixture(scope="session")
def shifted_run(tiny_run):
    """The run with somebody a metre beside where he is for a while, and nobody there late."""
    tracks = {name: column.copy() for name, column in tiny_run.tracks.items()}
    track = tracks["track"][tracks["frame"] == SHIFTED[0]].tolist()[0]
    moved = (tracks["track"] == track) & (tracks["frame"] >= SHIFTED[0])
    moved &= tracks["frame"] < SHIFTED[1]
    tracks["x"][moved] += 1.0
    tracks["left"][moved] += 40.0
    return replace(tiny_run, tracks=tracks, signals=empty(SIGNAL_COLUMNS)), track


@pytest.fixture
def shifted_session(tiny_recording, shifted_run, tmp_path):
    path = tmp_path / "shifted.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [shifted_run[0]], path)
        opening.remember_place(session, recording)
        session.close()
    return path


@pytest.fixture
def desk(window, qtbot, shifted_session):
    window.files.open_path(shifted_session)
    qtbot.waitUntil(lambda: window.desk is not None and window.desk.playback.frame is not None)
    window.desk.playback.go(AGAIN_AT)
    return window.desk


@pytest.fixture
def compared(desk, tiny_run, qtbot):
    """The right run beside the tracks that are shifted."""
    desk.document.session.add_run(tiny_run, adopt=False)
    desk.comparing.open(1)
    _wait_compared(desk, qtbot)
    return desk


def _wait_compared(desk, qtbot):
    qtbot.waitUntil(lambda: desk.comparing.shown, timeout=30_000)
    qtbot.waitUntil(lambda: desk.document.comparison.current is not None, timeout=30_000)


def _items(desk):
    return desk.document.comparison.scene().items


def _place(desk, track, frame):
    return float(desk.document.session.tracks.of_track(track, frame, frame + 1)["x"][0])


def test_tracking_again_goes_on_from_the_playhead_with_the_run_that_was_corrected(
    window, desk, qtbot, shifted_run
):
    session, track = desk.document.session, shifted_run[1]
    before = session.tracks.columns()["x"].copy()
    desk.document.apply(plan_mark_reviewed(session.labels, track, SHIFTED[0], SHIFTED[0] + 3))
    window.run_command("review.again")
    dialog = window.findChild(TrackDialog)
    tracker, _, seed, frames = dialog.answer()
    assert (tracker, seed, frames) == (session.runs[0].tracker, session.runs[0].seed, (50, 80))
    dialog.accept()
    assert desk.document.is_live
    assert len(desk.document.tracks.of_frame(AGAIN_AT - 1)["track"]) >= 1  # still shown before it
    _wait_compared(desk, qtbot)
    run = session.runs[1]
    assert run.frames == (50, 80)
    assert run.known_tracks == session.tracks.highest_track
    assert np.array_equal(session.tracks.columns()["x"], before, equal_nan=True)
    locked = [item for item in _items(desk) if item.locked]
    assert any(person.track == track for item in locked for person in item.people)
    assert all(item.ticked for item in _items(desk) if not item.locked)


def test_taking_what_is_ticked_is_one_edit_that_undo_takes_back(compared, window, shifted_run):
    desk, track = compared, shifted_run[1]
    wrong = _place(desk, track, 65)
    desk.document.comparison.tick_listed(True)
    window.workspace.differences.taken.emit(1)
    assert _place(desk, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert len(desk.document.session.history) == 1
    desk.editing.undo()
    assert _place(desk, track, 65) == wrong


def test_once_all_is_taken_the_comparison_closes_and_says_so(compared, window, qtbot):
    said = []
    compared.comparing.said.connect(said.append)
    compared.document.comparison.tick_listed(True)
    window.workspace.differences.taken.emit(1)
    compared.draw()
    qtbot.waitUntil(lambda: not compared.comparing.shown, timeout=30_000)
    assert window.workspace.differences.isHidden()
    assert said[-1] == "Nothing is left to take from run 1"


def test_a_stretch_is_told_by_its_first_and_last_frame(compared):
    found = compared.document.comparison.current
    assert (found.start, found.end) == SHIFTED
    fps = compared.document.recording.fps
    wanted = span_text(found.start / fps, (found.end - 1) / fps)
    assert [item.when for item in _items(compared)] == [wanted]


def test_a_click_on_a_box_ticks_and_a_click_beside_it_goes_there(compared, window, qtbot):
    desk, panel = compared, window.workspace.differences
    row = panel._list.visualRect(panel._model.index(0))
    left = Qt.MouseButton.LeftButton
    assert not _items(desk)[0].ticked
    qtbot.mouseClick(panel._list.viewport(), left, pos=QPoint(row.left() + 12, row.center().y()))
    assert _items(desk)[0].ticked
    assert panel._take_dashed.isEnabled()
    desk.playback.go(0)
    qtbot.mouseClick(panel._list.viewport(), left, pos=row.center())
    assert _items(desk)[0].ticked
    current = desk.document.comparison.current
    assert 0 < desk.playback.clock.frame <= current.start


def test_the_keyboard_ticks_too(compared, window, qtbot):
    panel = window.workspace.differences
    panel._list.setFocus()
    QTest.keyClick(panel._list, Qt.Key.Key_Space)
    assert _items(compared)[0].ticked
    assert not compared.playback.clock.playing


def _boxes(marks):
    return {mark.label: mark.box for mark in marks}


def test_both_versions_are_shown_in_the_pictures_and_on_the_floor(
    compared, shifted_run, window, qtbot
):
    desk = compared
    instant = desk.document.instant(65)
    assert {trail.after for trail in instant.preview} == {True, False}
    assert {trail.after for trail in instant.picture_preview} == {True, False}
    desk.playback.go(65)
    picture = window.workspace.left
    qtbot.waitUntil(lambda: picture._scene.frame == 65)
    run, corrected = _boxes(picture._others), _boxes(picture._scene.people)
    label = str(shifted_run[1])
    assert run[label][0] == pytest.approx(corrected[label][0] - 40.0, abs=0.01)
    assert {place.label for place in window.workspace.overhead._others} == set(run)
    desk.comparing.close()
    assert desk.document.instant(65).preview == ()
    assert picture._others == ()


def test_n_walks_what_differs_while_it_is_compared(compared, window):
    first = compared.document.comparison.current
    window.run_command("review.next")
    following = compared.document.comparison.current
    assert following != first or len(_items(compared)) == 1


def test_nothing_ticked_is_told(compared, window):
    errors = []
    compared.failed.connect(errors.append)
    compared.comparing._take(1)
    assert "Nothing is ticked" in str(errors[0])
    assert len(compared.document.session.history) == 0


def test_closing_takes_nothing_and_keeps_the_run(compared, window):
    window.workspace.differences.closed.emit()
    assert not window.workspace.differences.isVisible()
    assert window.workspace.review.isVisible()
    assert len(compared.document.session.runs) == 2
    assert len(compared.document.session.history) == 0


def test_a_run_can_be_dropped(compared, window):
    window.workspace.differences.dropped.emit()
    assert len(compared.document.session.runs) == 1
    assert not compared.comparing.shown


def test_an_edit_meanwhile_is_compared_anew(compared, qtbot, shifted_run):
    desk = compared
    session = desk.document.session
    change = plan_mark_reviewed(session.labels, 0, *SHIFTED)
    desk.document.apply(change)
    desk.draw()
    qtbot.waitUntil(lambda: any(item.locked for item in _items(desk)), timeout=10_000)


def test_runs_are_listed_with_their_scores_and_compared(window, desk, qtbot, tiny_run):
    desk.document.session.add_run(replace(tiny_run, seed=7), adopt=False)
    window.run_command("review.runs")
    dialog = window.findChild(RunsDialog)
    table = dialog._table
    assert [row.number for row in dialog._scene.rows] == [CORRECTED, 0, 1]
    assert table.item(1, 0).text() == "run 0, being corrected"
    dialog.choose(0)
    assert not dialog._compare.isEnabled()
    assert "nothing is edited yet" in dialog._about.text()
    assert table.item(2, 2).text() == "seed 7"
    qtbot.waitUntil(lambda: bool(table.item(2, 6).text()), timeout=20_000)
    assert float(table.item(2, 6).text()) >= float(table.item(1, 6).text())
    dialog.choose(0, 1)
    dialog._compare.click()
    qtbot.waitUntil(lambda: bool(_items(desk)), timeout=10_000)
    assert (desk.document.comparison.base, desk.document.comparison.run) == (0, 1)


def _late_part(run):
    late = run.tracks["frame"] >= 40
    rows = {name: column[late] for name, column in run.tracks.items()}
    return replace(run, tracks=rows, frames=(40, 80))


def test_runs_of_other_frames_are_scored_over_those_they_share(window, desk, qtbot):
    session = desk.document.session
    session.add_run(_late_part(session.runs[0]), adopt=False)
    window.run_command("review.runs")
    dialog = window.findChild(RunsDialog)
    figures = lambda: [dialog._table.item(row, 6).text() for row in (1, 2)]  # noqa: E731
    qtbot.waitUntil(lambda: all(figures()), timeout=20_000)
    assert "40 \u2013 79" in dialog._share.text()
    assert figures()[0] == figures()[1]
    dialog._share.setChecked(False)
    assert "cannot be compared" in dialog._over.text()
    qtbot.waitUntil(lambda: all(figures()), timeout=20_000)
    assert figures()[0] != figures()[1]
    dialog.reject()


def test_another_run_is_corrected_where_nobody_has_edited(window, desk, tiny_run, shifted_run):
    wrong = _place(desk, shifted_run[1], 65)
    desk.document.session.add_run(tiny_run, adopt=False)
    window.run_command("review.runs")
    dialog = window.findChild(RunsDialog)
    dialog.choose(0)
    assert not dialog._correct.isEnabled()
    dialog.choose(1)
    dialog._correct.click()
    assert desk.document.session.adopted_run == 1
    assert _place(desk, shifted_run[1], 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert not desk.comparing.shown


def test_no_run_is_corrected_while_a_tracker_is_at_work(window, desk, tiny_run):
    desk.document.session.add_run(tiny_run, adopt=False)
    desk.document.begin_live()
    show_runs(desk)
    dialog = window.findChild(RunsDialog)
    dialog.choose(1)
    assert not dialog._correct.isEnabled()
    assert "stop it first" in dialog._correct.toolTip()
    dialog.reject()
    errors = []
    desk.comparing.failed.connect(errors.append)
    desk.comparing.correct(1)
    assert "stop tracking first" in str(errors[0])
    assert desk.document.is_live
    assert desk.document.session.adopted_run == 0


def test_people_outside_of_the_frames_of_a_shorter_run_stay(
    window, desk, qtbot, tiny_run, shifted_run
):
    session, track = desk.document.session, shifted_run[1]
    wrong, rows = _place(desk, track, 65), len(session.tracks.columns()["x"])
    session.add_run(_late_part(tiny_run), adopt=False)
    desk.comparing.correct(1)
    qtbot.waitUntil(lambda: bool(_items(desk)), timeout=10_000)
    window.workspace.differences.taken.emit(1)
    assert _place(desk, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert len(session.tracks.columns()["x"]) == rows
    assert len(session.history) == 1


def test_over_edits_another_run_is_taken_as_one_edit_that_can_be_undone(
    window, desk, qtbot, tiny_run, shifted_run
):
    session = desk.document.session
    session.apply(plan_delete(session.tracks, shifted_run[1], 60, 70))
    edits = len(session.history)
    session.add_run(tiny_run, adopt=False)
    desk.comparing.correct(1)
    qtbot.waitUntil(lambda: bool(_items(desk)), timeout=10_000)
    assert all(item.ticked or item.locked for item in _items(desk))
    window.workspace.differences.taken.emit(1)
    assert len(session.history) == edits + 1
    desk.editing.undo()
    assert session.history.next_redo is not None


def test_the_better_stretch_is_taken_from_either_of_two_runs(
    window, desk, qtbot, tiny_run, shifted_run
):
    track = shifted_run[1]
    wrong = _place(desk, track, 65)
    desk.document.session.add_run(tiny_run, adopt=False)
    desk.comparing.open(1, 0)
    qtbot.waitUntil(lambda: bool(_items(desk)), timeout=10_000)
    panel = window.workspace.differences
    assert not panel._take_solid.isHidden()
    panel.all_ticked.emit(True)
    panel.taken.emit(1)
    assert _place(desk, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    panel.taken.emit(0)
    assert _place(desk, track, 65) == pytest.approx(wrong, abs=1e-5)


def test_the_boxes_of_both_runs_are_shown_and_not_those_of_the_corrected_tracks(
    window, desk, qtbot, tiny_run, shifted_run
):
    label = str(shifted_run[1])
    session = desk.document.session
    session.apply(plan_delete(session.tracks, shifted_run[1], 60, 70))
    session.add_run(tiny_run, adopt=False)
    desk.comparing.open(1, 0)
    qtbot.waitUntil(lambda: bool(_items(desk)), timeout=10_000)
    desk.playback.go(65)
    picture = window.workspace.left
    qtbot.waitUntil(lambda: picture._scene.frame == 65)
    solid, dashed = _boxes(picture._scene.people), _boxes(picture._others)
    assert dashed[label][0] == pytest.approx(solid[label][0] - 40.0, abs=0.01)
    assert label in {place.label for place in window.workspace.overhead._others}


def test_comparing_tells_how_far_it_is_and_can_be_cancelled(
    window, desk, qtbot, tiny_run, monkeypatch
):
    reached, go_on = threading.Event(), threading.Event()

    def slow(*_, report):
        report(1, 4)
        reached.set()
        go_on.wait(10)
        report(2, 4)

    monkeypatch.setattr(Comparison, "search", lambda _: lambda report: slow(report=report))
    desk.document.session.add_run(tiny_run, adopt=False)
    desk.comparing.open(1)
    panel = window.workspace.differences
    qtbot.waitUntil(lambda: panel._working._bar.value() == 250)
    assert reached.is_set()
    said = []
    desk.said.connect(said.append)
    panel._working._cancel.click()
    go_on.set()
    qtbot.waitUntil(lambda: not desk.comparing.shown)
    assert said == ["Stopped: comparing"]
    assert window.workspace.review.isVisible()


def test_closing_a_comparison_does_not_wait_for_it(window, desk, qtbot, tiny_run, monkeypatch):
    go_on = threading.Event()
    monkeypatch.setattr(Comparison, "search", lambda _: lambda _: go_on.wait(10))
    desk.document.session.add_run(tiny_run, adopt=False)
    desk.comparing.open(1)
    window.workspace.differences.closed.emit()
    assert not desk.comparing.shown
    go_on.set()


def test_the_last_run_is_dropped_from_the_list_but_not_the_one_that_was_corrected(
    window, desk, tiny_run
):
    desk.document.session.add_run(tiny_run, adopt=False)
    window.run_command("review.runs")
    dialog = window.findChild(RunsDialog)
    dialog._drop.click()
    assert len(desk.document.session.runs) == 1
    assert dialog._drop.isHidden()
    dialog.reject()
