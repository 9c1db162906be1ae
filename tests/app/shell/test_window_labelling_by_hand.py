"""A recording nobody has tracked, also with one camera and no calibration, labelled by hand."""

import cv2
import numpy as np
import pytest
from correcting_window import CTRL, Hands, open_for_correcting
from PySide6.QtCore import Qt

from app.shell import save_controller
from tracking.session import Session
from tracking.tracks import Source

Key = Qt.Key


@pytest.fixture
def hands(window, qtbot, tmp_path) -> Hands:
    folder = tmp_path / "one-camera"
    folder.mkdir()
    for number in range(12):
        picture = np.full((96, 128, 3), 40 + number, np.uint8)
        assert cv2.imwrite(str(folder / f"{number:03d}.png"), picture)
    (folder / "recording.toml").write_text(
        'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    )
    return Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)


def _draw(hands, corner: tuple[float, float]) -> None:
    view = hands.window.workspace.left
    hands.press(Key.Key_W)
    start, end = view.viewport.point(*corner), view.viewport.point(corner[0] + 20, corner[1] + 40)
    hands.drag(view, start, end)


def test_the_first_box_makes_the_session_and_asks_nothing(hands):
    assert hands.controller.document.session is None
    _draw(hands, (30, 20))
    session = hands.controller.document.session
    assert session.tracks.track_ids == (1,)
    row = hands.row(1, 2)
    assert [row[n] for n in ("left", "top")] == pytest.approx([30, 20], abs=1)
    assert row["source"] == Source.PERSON
    assert session.path.is_file()  # a crash now loses nothing


def test_boxes_drawn_on_two_frames_are_joined_straight_through_the_picture(hands):
    _draw(hands, (30, 20))
    hands.go(6)
    _draw(hands, (50, 20))
    middle = hands.row(1, 4)
    assert middle["source"] == Source.INTERPOLATED
    assert middle["left"] == pytest.approx(40, abs=1)


def test_undo_takes_the_first_box_back_at_once_and_redo_brings_it_again(hands):
    _draw(hands, (30, 20))
    hands.press(Key.Key_Z, CTRL)
    assert hands.controller.document.session.tracks.track_ids == ()
    hands.press(Key.Key_Y, CTRL)
    assert hands.controller.document.session.tracks.track_ids == (1,)


def test_leaving_the_first_box_undone_makes_no_session(hands):
    hands.press(Key.Key_W)
    hands.press(Key.Key_Escape)
    assert hands.controller.document.session is None


def test_what_was_labelled_is_saved_where_the_dialog_says(hands, tmp_path, monkeypatch):
    path = tmp_path / "labelled.h5"
    monkeypatch.setattr(save_controller, "choose_new_file", lambda *given: given[4](path))
    _draw(hands, (30, 20))
    hands.press(Key.Key_S, CTRL)
    hands.qtbot.waitUntil(lambda: path.is_file() and not hands.window.work.busy)
    hands.window.run_command("file.close")
    again = Session.open(path)
    assert again.tracks.track_ids == (1,)
    again.close()
