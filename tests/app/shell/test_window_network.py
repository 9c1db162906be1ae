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

from app.features.runs.track_dialog import TrackDialog
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
    window.files.open_path(folder)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.run_command("tracks.track")
    dialog = window.findChild(TrackDialog)
    dialog.put_settings("three-part", {"detections.model": "network/people.toml"}, 0)
    dialog.put_frames(0, 9)
    dialog.accept()
    qtbot.waitUntil(
        lambda: (
            window.files.session is not None
            and len(window.files.session.runs) == 1
            and not window.controller.live.running
        ),
        timeout=60_000,
    )
    window.controller.playback.pause()
    window.controller.playback.go(4)
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
