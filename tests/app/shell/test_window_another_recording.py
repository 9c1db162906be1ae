"""What stays and what begins anew as another recording or session is opened."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from app.core.document import document_loader
from app.core.drawing.canvas import Canvas
from app.core.drawing.viewport import Viewport
from tracking.recording import open_recording
from tracking.session import Session


def _is_fitted(view: Canvas) -> bool:
    """Whether a view shows its whole content as large as it can."""
    area = view.rect().marginsRemoved(view.contentsMargins()).toRectF()
    return view.viewport == Viewport.fitting(view.content(), area, view.viewport.upward)


def _views(window) -> tuple[Canvas, Canvas, Canvas]:
    return window.workspace.left, window.workspace.right, window.workspace.overhead


def _open(window, qtbot, path) -> None:
    before = window.controller
    window.files.open_path(path)
    qtbot.waitUntil(lambda: window.controller is not None and window.controller is not before)
    qtbot.waitUntil(lambda: window.controller.playback.frame is not None)


@pytest.fixture
def other_session(tiny_recording, tiny_run, tmp_path):
    path = tmp_path / "other.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [tiny_run], path)
        document_loader.remember_place(session, recording)
        session.close()
    return path


def test_another_recording_is_shown_whole_however_the_last_one_was_zoomed(
    window, qtbot, controller, other_session
):
    for view in _views(window):
        view.zoom(6.0, QPointF(20, 20))
        assert not _is_fitted(view)
    window.files.close_without_asking()
    _open(window, qtbot, other_session)
    assert [_is_fitted(view) for view in _views(window)] == [True, True, True]


def test_a_slip_of_the_mouse_leaves_a_view_fitted_in_a_window_of_any_size(
    window, qtbot, controller
):
    for view in _views(window):
        place = QPoint(12, 30)
        QTest.mousePress(view, Qt.MouseButton.LeftButton, pos=place)
        QTest.mouseMove(view, place + QPoint(40, 25))
        QTest.mouseMove(view, place + QPoint(60, 35))
        QTest.mouseRelease(view, Qt.MouseButton.LeftButton, pos=place + QPoint(60, 35))
    for size in ((1024, 700), (1280, 800)):
        window.resize(*size)
        qtbot.wait(20)
        assert [_is_fitted(view) for view in _views(window)] == [True, True, True]


def test_zoomed_in_and_out_again_a_view_follows_the_size_of_the_window(window, qtbot, controller):
    view = window.workspace.overhead
    for factor in (1.2, 1.2, 1 / 1.2, 1 / 1.2):
        view.zoom(factor, QPointF(30, 40))
    window.resize(1024, 700)
    qtbot.wait(20)
    assert _is_fitted(view)


def test_a_command_shows_the_whole_picture_and_the_floor(window, qtbot, press):
    for view in _views(window):
        view.zoom(6.0, QPointF(20, 20))
    press(Qt.Key.Key_A, Qt.KeyboardModifier.ShiftModifier)
    assert [_is_fitted(view) for view in _views(window)] == [True, True, True]


def test_what_is_laid_over_the_pictures_is_remembered(
    window, qtbot, controller, press, other_session
):
    assert controller.view_options.counts
    press(Qt.Key.Key_U, Qt.KeyboardModifier.ShiftModifier)
    press(Qt.Key.Key_F)
    window.files.close_without_asking()
    _open(window, qtbot, other_session)
    assert not window.controller.view_options.counts
    assert window.controller.view_options.grid
    assert window.controller.view_options.trails


def test_panels_that_were_open_are_open_with_another_recording_too(
    window, qtbot, controller, press, other_session
):
    press(Qt.Key.Key_C, Qt.KeyboardModifier.ShiftModifier)
    assert "counting" in controller.view_options.panels
    window.files.close_without_asking()
    _open(window, qtbot, other_session)
    assert window.controller.view_options.panels == {"counting"}


@pytest.mark.parametrize("text", ["", "counts", "+nothing -", "-score \u2603 ++"])
def test_views_that_are_remembered_wrong_are_as_usual(
    window, qtbot, remembered, tiny_session, text
):
    remembered.set_text("pictured", text)
    _open(window, qtbot, tiny_session)
    assert window.controller.view_options.counts
    assert not window.controller.view_options.panels
