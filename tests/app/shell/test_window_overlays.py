import pytest
from correcting_window import CROWDED, open_for_correcting
from PySide6.QtCore import QObject

from app.core.tracks.frame_state import Kinds
from app.features.pictures.overlay_maker import OverlayMaker
from tracking.errors import RecordingError


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


def test_foreground_comes_over_the_left_picture_and_goes_again(window, controller, qtbot):
    left = window.workspace.left
    window.run_command("view.foreground")
    assert window.menus.actions["view.foreground"].isCheckable()
    qtbot.waitUntil(lambda: left._scene.overlay is not None)
    assert [entry.text for entry in left._scene.legend] == ["foreground", "shadow"]
    window.run_command("view.foreground")
    assert left._scene.overlay is None
    assert left._scene.legend == ()


def test_each_frame_has_its_own_overlay(window, controller, qtbot):
    left = window.workspace.left
    window.run_command("view.disparity")
    qtbot.waitUntil(lambda: left._scene.overlay is not None)
    first = left._scene.overlay
    controller.playback.step(1)
    qtbot.waitUntil(lambda: left._scene.frame == CROWDED + 1 and left._scene.overlay is not None)
    assert left._scene.overlay is not first


def test_overlays_that_come_next_are_painted_ahead(qtbot, no_threads_left, tiny_recording):
    frames = {number: _Frame(number) for number in range(6)}
    painted = []

    def paint(frame, kinds):
        painted.append(frame.number)
        return _Picture()

    owner = QObject()
    maker = OverlayMaker(paint, frames.get, 1000, owner)
    kinds = Kinds(foreground=True)
    maker.request(frames[1], kinds, ahead=3)
    qtbot.waitUntil(lambda: len(painted) == 4)
    assert painted == [1, 2, 3, 4]
    assert maker.get(4, kinds) is maker.get(4, kinds) is not None
    maker.request(frames[5], kinds, ahead=-3)
    qtbot.waitUntil(lambda: 5 in painted)
    maker.close()
    assert painted == [1, 2, 3, 4, 5]


def test_an_overlay_that_cannot_be_painted_is_told_once(qtbot, no_threads_left):
    def paint(frame, kinds):
        raise RecordingError("left.mp4: frame 3 cannot be read")

    owner = QObject()
    maker = OverlayMaker(paint, lambda _: None, 1000, owner)
    with qtbot.waitSignal(maker.failed) as failed:
        maker.request(_Frame(3), Kinds(foreground=True))
    assert "frame 3" in str(failed.args[0])
    maker.close()


class _Frame:
    right_lag = None

    def __init__(self, number):
        self.number = number


class _Picture:
    nbytes = 10
