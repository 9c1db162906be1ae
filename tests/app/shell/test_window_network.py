"""Boxes of a network in the window: drawn while it tracks, and from the session afterwards."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

sys.path.insert(0, str(Path(__file__).parents[2] / "networks"))

import numpy as np
from small_networks import saying, written
from tracked_frames import track_ten_frames

from app.shell.main_window import MainWindow

CORNERS = (10.0, 8.0, 30.0, 48.0)
"""Of 64 px: what the network says of any picture."""


@pytest.fixture
def tracked(window: MainWindow, qtbot: QtBot, tiny_recording: Path, tmp_path: Path) -> MainWindow:
    """A window in which ten frames were tracked with a network."""
    folder = Path(shutil.copytree(tiny_recording, tmp_path / "tiny"))
    says = {"dets": np.array([[*CORNERS, 0.8, 0.0]], np.float32)}
    keys = {"decoder": "boxes", "fit": "stretch", "name": "Finder of nobody"}
    written(folder / "network", saying(says), **keys)
    track_ten_frames(window, qtbot, folder, {"detections.model": "network/people.toml"})
    return window


def test_what_a_network_found_is_drawn_from_the_session_without_the_network(
    tracked: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    view = tracked.workspace.left
    qtbot.waitUntil(lambda: len(view._detections.boxes) == 1, timeout=20_000)
    (left, top, width, height), (w, h) = view._detections.boxes[0], _size(tracked)
    drawn = (left / w * 64, top / h * 64, width / w * 64, height / h * 64)
    assert drawn == pytest.approx((10.0, 8.0, 20.0, 40.0), abs=0.1)
    assert [entry.text for entry in view._detections.legend] == ["boxes of Finder of nobody"]
    tracked.run_command("view.detections")
    assert view._detections.boxes == ()
    shutil.rmtree(tmp_path / "tiny" / "network")
    tracked.run_command("view.detections")
    assert len(view._detections.boxes) == 1


def test_frames_that_were_not_tracked_have_no_boxes(tracked: MainWindow, qtbot: QtBot) -> None:
    tracked.controller.playback.go(30)
    qtbot.waitUntil(lambda: tracked.workspace.left._detections.boxes == (), timeout=20_000)


def _size(window: MainWindow) -> tuple[int, int]:
    width, height = window.controller.document.recording.size
    return width, height
