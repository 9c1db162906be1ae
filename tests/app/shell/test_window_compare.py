"""Another person's session beside the open one, in the real window."""

import shutil
from contextlib import closing

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from tracking.editing import plan_delete, plan_swap
from tracking.recording import open_recording
from tracking.session import Session

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def anns(controller, tiny_session, tmp_path):
    """A second person's session: two ids swapped from frame 60 on, one person gone at the end."""
    path = tmp_path / "ann.h5"
    shutil.copy(tiny_session, path)
    with closing(Session.open(path)) as session:
        a, b = session.tracks.of_frame(60)["track"].tolist()[:2]
        session.apply(plan_swap(session.tracks, a, b, 60))
        session.apply(plan_delete(session.tracks, a, 70, 75))
        session.save()
    return path, a, b


@pytest.fixture
def compared(window, anns, qtbot):
    window.files.beside.compare_with(anns[0])
    qtbot.waitUntil(lambda: window.workspace.compare.isVisible())
    return window.workspace.compare


def test_figures_and_stretches_are_listed_and_a_click_goes_there(
    window, controller, compared, anns, qtbot
):
    _, a, b = anns
    assert "kappa 0." in compared._figures.text()
    frames = [(row.frame, row.track) for row in compared._model.rows]
    assert (70, b) in frames  # whom Ann took out under the other id
    row = frames.index((70, b))
    index = compared._model.index(row)
    compared._list.scrollTo(index)
    point = compared._list.visualRect(index).center()
    QTest.mouseClick(compared._list.viewport(), LEFT, pos=point)
    assert controller.playback.clock.frame == 70
    assert controller.document.selection.track == b
    qtbot.waitUntil(lambda: controller.playback.number == 70)
    there = {one.label for one in window.workspace.left._others}
    own = {str(one.track) for one in window.workspace.left._scene.people}
    assert own - there == {str(a)}
    assert {one.label for one in window.workspace.overhead._others} == there


def test_what_they_disagree_about_is_not_cut(compared):
    view = compared._list
    metrics = view.fontMetrics()
    for row in compared._model.rows:
        for line in (row.text, row.when):
            assert metrics.horizontalAdvance(line) < view.viewport().width() - 10
    assert view.sizeHintForRow(0) >= 2 * metrics.height()


def test_after_an_edit_it_can_be_compared_again(window, controller, compared, anns, qtbot):
    _, a, b = anns
    session = controller.document.session
    assert compared._again.isHidden()
    controller.document.apply(plan_swap(session.tracks, a, b, 60))
    controller.draw()
    assert not compared._again.isHidden()
    compared._again.click()
    qtbot.waitUntil(lambda: not window.work.busy)
    assert [row.track for row in compared._model.rows] == [a]
    assert compared._again.isHidden()


def test_theirs_is_taken_of_one_disagreement_as_one_edit(window, controller, compared, anns, qtbot):
    _, _, b = anns
    session = controller.document.session
    assert not compared._theirs.isEnabled()
    rows = [(row.frame, row.track) for row in compared._model.rows]
    compared._list.setCurrentIndex(compared._model.index(rows.index((70, b))))
    compared._theirs.click()
    qtbot.waitUntil(lambda: not window.work.busy)
    assert len(session.history) == 1
    assert (70, b) not in [(row.frame, row.track) for row in compared._model.rows]
    assert not set(range(70, 75)) & set(session.tracks.frames_of_track(b).tolist())
    controller.editing.undo()
    assert set(range(70, 75)) <= set(session.tracks.frames_of_track(b).tolist())
    assert not compared._theirs.isEnabled()  # it was compared with what stands no more


def test_closing_takes_the_others_away(window, controller, compared, qtbot):
    controller.playback.go(60)
    qtbot.waitUntil(lambda: bool(window.workspace.left._others))
    compared.left.emit()
    assert compared.isHidden()
    assert window.workspace.left._others == ()
    assert window.workspace.overhead._others == ()


def test_the_other_session_is_left_as_it_was_and_free_for_others(window, compared, anns):
    with closing(Session.open(anns[0])) as again:
        assert not again.read_only
        assert len(again.history) == 2


def test_the_open_session_itself_and_other_recordings_are_refused(
    window, controller, qtbot, tiny_session, tiny_recording, tiny_run, tmp_path
):
    window.files.beside.compare_with(tiny_session)
    qtbot.waitUntil(lambda: not window.work.busy)
    assert "open session itself" in window.notice._text.text()
    elsewhere = shutil.copytree(tiny_recording, tmp_path / "elsewhere")
    video = elsewhere / "left.mp4"
    video.write_bytes(video.read_bytes() + b"\0" * 64)
    with open_recording(elsewhere) as footage:
        Session.create(footage, [tiny_run], tmp_path / "elsewhere.h5").close()
    window.files.beside.compare_with(tmp_path / "elsewhere.h5")
    qtbot.waitUntil(lambda: not window.work.busy)
    assert "of another recording" in window.notice._text.text()
    assert window.workspace.compare.isHidden()


def test_one_comparison_is_shown_at_a_time(window, controller, compared, anns, tiny_run, qtbot):
    session = controller.document.session
    session.add_run(tiny_run)
    controller.comparing.open(1, 0)
    qtbot.waitUntil(lambda: controller.comparing.dashed is not None)
    controller.draw()
    assert compared.isHidden()
    window.files.beside.compare_with(anns[0])
    qtbot.waitUntil(lambda: window.workspace.compare.isVisible())
    assert not controller.comparing.shown


def test_runs_that_are_compared_meanwhile_stay(window, controller, anns, tiny_run, qtbot):
    controller.document.session.add_run(tiny_run)
    window.files.beside.compare_with(anns[0])
    controller.comparing.open(1, 0)
    qtbot.waitUntil(lambda: not window.work.busy and controller.comparing.dashed is not None)
    qtbot.waitUntil(lambda: "Runs are being compared" in window.statusBar().currentMessage())
    assert controller.comparing.shown
    assert window.workspace.compare.isHidden()
