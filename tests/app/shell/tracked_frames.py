"""Ten frames tracked in the window, as a person would have them tracked."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from pytestqt.qtbot import QtBot

from app.features.runs.track_dialog import TrackDialog
from app.shell.main_window import MainWindow


def track_ten_frames(
    window: MainWindow, qtbot: QtBot, recording: Path, settings: Mapping[str, str]
) -> None:
    """Open a recording, track ten frames of it with `three-part`, and go to one of them."""
    window.files.open_path(recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.run_command("tracks.track")
    dialog = window.findChild(TrackDialog)
    dialog.put_settings("three-part", dict(settings), 0)
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
