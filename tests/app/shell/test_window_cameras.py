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


def _half_of_the_width(space):
    """Whether the images have at least half of the width above the timeline, and the floor room."""
    cameras, floor, side = space._shares.splitters["top"].sizes()
    return cameras >= 0.5 * (cameras + floor + side) - 1 and floor > 100


@pytest.mark.parametrize("mode", ["left", "both", "anaglyph"])
def test_the_images_have_half_of_the_window_at_any_size(space, window, qtbot, mode):
    window.run_command(f"view.{mode}")
    for size in ((1000, 640), (1920, 1050), (1280, 800), (3840, 2160), (1000, 640)):
        window.resize(*size)
        qtbot.waitUntil(lambda: _half_of_the_width(space))


def test_two_images_are_as_large_as_one_above_the_other_or_side_by_side(space, window, qtbot):
    for size in ((1000, 640), (1280, 700), (1400, 1300)):
        window.resize(*size)
        qtbot.waitUntil(lambda: _half_of_the_width(space))
        qtbot.waitUntil(lambda: _as_large_as_can_be(space))


def _as_large_as_can_be(space):
    content, pane = space.left.content(), space._shares.splitters["eyes"]
    aspect = content.width() / content.height()
    above = min(pane.width(), aspect * pane.height() / 2)
    beside = min(pane.width() / 2, aspect * pane.height())
    shown = [view.viewport.scale * content.width() for view in (space.left, space.right)]
    return min(shown) >= max(above, beside) - 8


def test_one_camera_fills_the_height_where_the_floor_keeps_its_share(space, window, qtbot):
    fitted = space.left.width()
    window.resize(1280, 560)
    window.run_command("view.left")
    qtbot.waitUntil(lambda: abs(_shown_px(space.left) - space.left.height()) < 4)
    window.resize(1280, 700)
    window.run_command("view.both")
    qtbot.waitUntil(lambda: abs(space.left.width() - fitted) < 2)


def _shown_px(view):
    """How high the picture is."""
    return view.viewport.scale * view.content().height()


def test_without_a_floor_the_images_have_all_beside_the_panels(space, window, qtbot):
    space.know_floor(False)
    qtbot.waitUntil(lambda: not space.overhead.isVisible())
    qtbot.waitUntil(
        lambda: space._shares.splitters["eyes"].width() > space.width() - space._side.width() - 20
    )
    space.know_floor(True)
    qtbot.waitUntil(lambda: _half_of_the_width(space))


def test_a_border_moved_beside_one_camera_stays_until_both_are_shown(space, window, qtbot):
    fitted = space.left.width()
    window.run_command("view.left")
    space._shares.splitters["top"].moveSplitter(300, 1)
    window.resize(1280, 720)
    qtbot.wait(20)
    assert abs(space.left.width() - 300) < 3
    window.run_command("view.both")
    qtbot.waitUntil(lambda: abs(space.left.width() - fitted) < 20)


def _moved(window, qtbot, path):
    open_for_correcting(window, qtbot, path)
    qtbot.wait(20)
    window.workspace._shares.splitters["top"].moveSplitter(500, 1)
    qtbot.wait(20)
    return window.workspace._shares.splitters["top"].sizes()


def test_a_border_the_user_moved_stays_as_another_recording_is_opened(
    space, window, qtbot, tiny_session
):
    sizes = _moved(window, qtbot, tiny_session)
    window.files.close_recording()
    open_for_correcting(window, qtbot, tiny_session)
    qtbot.waitUntil(lambda: space._shares.splitters["top"].sizes() == sizes)


def test_a_border_the_user_moved_is_there_at_the_next_start(
    space, window, qtbot, tiny_session, tmp_path
):
    sizes = _moved(window, qtbot, tiny_session)
    remembered = UserSettings(QSettings(str(tmp_path / "kept.ini"), QSettings.Format.IniFormat))
    space.remember(remembered)
    space._shares.splitters["top"].setSizes([900, 100, 200])
    space.restore(remembered)
    space.show_cameras("both", 4 / 3, stereo=True)
    qtbot.waitUntil(lambda: space._shares.splitters["top"].sizes() == sizes)


@pytest.fixture
def started_again(space, window, qtbot, tmp_path):
    """The next start after the border was moved beside one image; shows that many images."""
    window.run_command("view.left")
    space._shares.splitters["top"].moveSplitter(300, 1)
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
    images = started_again("both").parentWidget()
    assert images.width() == pytest.approx(images.parentWidget().width() / 2, abs=3)


def test_a_border_the_user_moved_stays_where_it_is(space, window, qtbot):
    top = space._shares.splitters["top"]
    top.moveSplitter(500, 1)
    window.resize(1280, 720)
    qtbot.wait(20)
    assert space.left.width() > 450


def test_the_border_of_the_panels_at_the_side_is_none_of_the_cameras(space, window, qtbot):
    top = space._shares.splitters["top"]
    top.moveSplitter(top.width() - 400, 2)
    assert not space._image_room.moved
