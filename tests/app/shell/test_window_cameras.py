"""Room for the cameras: their pictures fill it, the floor has the rest."""

import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import QSettings

from app.core.widgets.user_settings import UserSettings
from app.shell.workspace import Workspace


@pytest.fixture
def space(window, qtbot, tiny_session):
    window.resize(1280, 700)
    open_for_correcting(window, qtbot, tiny_session)
    window.grab()  # lays it out
    return window.workspace


def _empty_px(view):
    """How much of the width the picture leaves."""
    return view.width() - view.viewport.scale * view.content().width()


def test_nothing_is_empty_beside_both_pictures_at_any_size(space, window, qtbot):
    for size in ((1280, 700), (1920, 1050), (1280, 700)):
        window.resize(*size)
        qtbot.waitUntil(lambda: max(_empty_px(space.left), _empty_px(space.right)) < 4)


def test_one_camera_fills_the_height_where_two_fifths_are_left_for_the_floor(space, window, qtbot):
    fitted = space.left.width()
    window.run_command("view.left")
    filled = space.height() / 2
    qtbot.waitUntil(lambda: filled < space.left.height() < _shown_px(space.left) + 4)
    cameras, floor, _ = space._splitters["top"].sizes()
    assert floor >= 0.4 * (cameras + floor) - 1
    window.run_command("view.both")
    qtbot.waitUntil(lambda: abs(space.left.width() - fitted) < 2)


def _shown_px(view):
    """How high the picture is."""
    return view.viewport.scale * view.content().height()


def test_a_border_moved_beside_one_camera_stays_until_both_are_shown(space, window, qtbot):
    fitted = space.left.width()
    window.run_command("view.left")
    space._splitters["top"].moveSplitter(300, 1)
    window.resize(1280, 720)
    qtbot.wait(20)
    assert abs(space.left.width() - 300) < 3
    window.run_command("view.both")
    qtbot.waitUntil(lambda: abs(space.left.width() - fitted) < 20)


def _moved(window, qtbot, path):
    open_for_correcting(window, qtbot, path)
    window.workspace._splitters["top"].moveSplitter(500, 1)
    return window.workspace._splitters["top"].sizes()


def test_a_border_the_user_moved_stays_as_another_recording_is_opened(
    space, window, qtbot, tiny_session
):
    sizes = _moved(window, qtbot, tiny_session)
    window.files.close_recording()
    open_for_correcting(window, qtbot, tiny_session)
    assert space._splitters["top"].sizes() == sizes


def test_a_border_the_user_moved_is_there_at_the_next_start(
    space, window, qtbot, tiny_session, tmp_path
):
    sizes = _moved(window, qtbot, tiny_session)
    remembered = UserSettings(QSettings(str(tmp_path / "kept.ini"), QSettings.Format.IniFormat))
    space.remember(remembered)
    space._splitters["top"].setSizes([900, 100, 200])
    space.restore(remembered)
    space.show_cameras("both", 4 / 3, stereo=True)
    assert space._splitters["top"].sizes() == sizes


@pytest.fixture
def started_again(space, window, qtbot, tmp_path):
    """The next start after the border was moved beside one image; shows that many images."""
    window.run_command("view.left")
    space._splitters["top"].moveSplitter(300, 1)
    remembered = UserSettings(QSettings(str(tmp_path / "kept.ini"), QSettings.Format.IniFormat))
    space.remember(remembered)
    again = Workspace()
    qtbot.addWidget(again)
    again.resize(space.size())
    again.restore(remembered)
    again.show()

    def shown(cameras):
        again.show_cameras(cameras, 4 / 3, stereo=True)
        qtbot.wait(20)
        return again.left

    return shown


def test_a_border_moved_beside_one_camera_is_there_for_one_at_the_next_start(started_again):
    assert abs(started_again("left").width() - 300) < 3


def test_a_border_moved_beside_one_camera_is_not_kept_for_both_at_the_next_start(started_again):
    left = started_again("both")
    assert abs(left.width() - 4 / 3 * left.height()) < 3


def test_a_border_the_user_moved_stays_where_it_is(space, window, qtbot):
    top = space._splitters["top"]
    top.moveSplitter(500, 1)
    window.resize(1280, 720)
    qtbot.wait(20)
    assert space.left.width() > 450


def test_the_border_of_the_panels_at_the_side_is_none_of_the_cameras(space, window, qtbot):
    top = space._splitters["top"]
    top.moveSplitter(top.width() - 400, 2)
    assert not space._image_room.moved
