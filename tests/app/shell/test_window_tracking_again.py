"""Tracking again from a frame, what would change, and the runs there are by then."""

import threading

import numpy as np
import pytest
from patient import PATIENCE_S
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from shifted_runs import AGAIN_AT, SHIFTED, boxes, items, place

from app.core.i18n import span_text
from app.features.comparison.presenter import Comparison
from app.features.runs.track_dialog import TrackDialog
from tracking.editing import plan_mark_reviewed


@pytest.fixture
def controller(shifted_controller):
    return shifted_controller


@pytest.fixture
def compared(controller, tiny_run, qtbot):
    """The right run beside the tracks that are shifted."""
    controller.document.session.add_run(tiny_run, adopt=False)
    controller.comparing.open(1)
    _wait_compared(controller, qtbot)
    return controller


def _wait_compared(controller, qtbot):
    qtbot.waitUntil(lambda: controller.comparing.shown)
    qtbot.waitUntil(lambda: controller.document.comparison.current is not None)


def test_tracking_again_goes_on_from_the_playhead_with_the_run_that_was_corrected(
    window, controller, qtbot, shifted_run
):
    session, track = controller.document.session, shifted_run[1]
    before = session.tracks.columns()["x"].copy()
    controller.document.apply(plan_mark_reviewed(session.labels, track, SHIFTED[0], SHIFTED[0] + 3))
    window.run_command("review.again")
    dialog = window.findChild(TrackDialog)
    tracker, _, seed, frames = dialog.answer()
    assert (tracker, seed, frames) == (session.runs[0].tracker, session.runs[0].seed, (50, 80))
    dialog.accept()
    assert controller.document.is_live
    assert (
        len(controller.document.tracks.of_frame(AGAIN_AT - 1)["track"]) >= 1
    )  # still shown before it
    _wait_compared(controller, qtbot)
    run = session.runs[1]
    assert run.frames == (50, 80)
    assert run.known_tracks == session.tracks.highest_track
    assert np.array_equal(session.tracks.columns()["x"], before, equal_nan=True)
    locked = [item for item in items(controller) if item.locked]
    assert any(person.track == track for item in locked for person in item.people)
    assert all(item.ticked for item in items(controller) if not item.locked)


def test_taking_what_is_ticked_is_one_edit_that_undo_takes_back(compared, window, shifted_run):
    controller, track = compared, shifted_run[1]
    wrong = place(controller, track, 65)
    controller.document.comparison.tick_listed(True)
    window.workspace.differences.taken.emit(1)
    assert place(controller, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert len(controller.document.session.history) == 1
    controller.editing.undo()
    assert place(controller, track, 65) == wrong


def test_once_all_is_taken_the_comparison_closes_and_says_so(compared, window, qtbot):
    said = []
    compared.comparing.said.connect(said.append)
    compared.document.comparison.tick_listed(True)
    window.workspace.differences.taken.emit(1)
    compared.draw()
    qtbot.waitUntil(lambda: not compared.comparing.shown)
    assert window.workspace.differences.isHidden()
    assert said[-1].startswith("Done: ")
    assert said[-1].endswith("; nothing is left to take from run 1")


def test_a_stretch_is_told_by_its_first_and_last_frame(compared):
    found = compared.document.comparison.current
    assert (found.start, found.end) == SHIFTED
    fps = compared.document.recording.fps
    wanted = span_text(found.start / fps, (found.end - 1) / fps)
    assert [item.when for item in items(compared)] == [wanted]


def test_a_click_on_a_box_ticks_and_a_click_beside_it_goes_there(compared, window, qtbot):
    controller, panel = compared, window.workspace.differences
    row = panel._list.visualRect(panel._model.index(0))
    left = Qt.MouseButton.LeftButton
    assert not items(controller)[0].ticked
    qtbot.mouseClick(panel._list.viewport(), left, pos=QPoint(row.left() + 12, row.center().y()))
    assert items(controller)[0].ticked
    assert panel._take_dashed.isEnabled()
    controller.playback.go(0)
    qtbot.mouseClick(panel._list.viewport(), left, pos=row.center())
    assert items(controller)[0].ticked
    current = controller.document.comparison.current
    assert 0 < controller.playback.clock.frame <= current.start


def test_the_keyboard_ticks_too(compared, window, qtbot):
    panel = window.workspace.differences
    panel._list.setFocus()
    QTest.keyClick(panel._list, Qt.Key.Key_Space)
    assert items(compared)[0].ticked
    assert not compared.playback.clock.playing


def test_both_versions_are_shown_in_the_pictures_and_on_the_floor(
    compared, shifted_run, window, qtbot
):
    controller = compared
    state = controller.document.frame_state(65)
    assert {trail.after for trail in state.preview} == {True, False}
    assert {trail.after for trail in state.picture_preview} == {True, False}
    controller.playback.go(65)
    picture = window.workspace.left
    qtbot.waitUntil(lambda: picture._scene.frame == 65)
    run, corrected = boxes(picture._others), boxes(picture._scene.people)
    label = str(shifted_run[1])
    assert run[label][0] == pytest.approx(corrected[label][0] - 40.0, abs=0.01)
    assert {place.label for place in window.workspace.overhead._others} == set(run)
    controller.comparing.close()
    assert controller.document.frame_state(65).preview == ()
    assert picture._others == ()


def test_n_walks_what_differs_while_it_is_compared(compared, window):
    first = compared.document.comparison.current
    window.run_command("review.next")
    following = compared.document.comparison.current
    assert following != first or len(items(compared)) == 1


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
    controller = compared
    session = controller.document.session
    change = plan_mark_reviewed(session.labels, 0, *SHIFTED)
    controller.document.apply(change)
    controller.draw()
    qtbot.waitUntil(lambda: any(item.locked for item in items(controller)))


def test_comparing_tells_how_far_it_is_and_can_be_cancelled(
    window, controller, qtbot, tiny_run, monkeypatch
):
    reached, go_on = threading.Event(), threading.Event()

    def slow(*_, report):
        report(1, 4)
        reached.set()
        go_on.wait(PATIENCE_S)
        report(2, 4)

    monkeypatch.setattr(Comparison, "search", lambda _: lambda report: slow(report=report))
    controller.document.session.add_run(tiny_run, adopt=False)
    controller.comparing.open(1)
    panel = window.workspace.differences
    qtbot.waitUntil(lambda: panel._working._bar.value() == 250)
    assert reached.is_set()
    said = []
    controller.said.connect(said.append)
    panel._working._cancel.click()
    go_on.set()
    qtbot.waitUntil(lambda: not controller.comparing.shown)
    assert said == ["Stopped: comparing"]
    assert window.workspace.review.isVisible()


def test_closing_a_comparison_does_not_wait_for_it(
    window, controller, qtbot, tiny_run, monkeypatch
):
    go_on, waited = threading.Event(), []
    slow = lambda _: waited.append(go_on.wait(PATIENCE_S))  # noqa: E731
    monkeypatch.setattr(Comparison, "search", lambda _: slow)
    controller.document.session.add_run(tiny_run, adopt=False)
    controller.comparing.open(1)
    window.workspace.differences.closed.emit()
    assert not controller.comparing.shown
    assert not waited
    go_on.set()
