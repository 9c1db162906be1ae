"""The real window on the tiny session, with the keyboard at hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot
from setup_fixtures import begin, card, user, with_calibration  # noqa: F401 - fixtures
from shifted_runs import AGAIN_AT, SHIFTED, swapped

from app.core.document import document_loader
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, Run, empty

Press = Callable[..., None]


@pytest.fixture
def controller(window: MainWindow, qtbot: QtBot, tiny_session: Path) -> RecordingController:
    """The recording's controller once its first frame is shown."""
    window.files.open_path(tiny_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    assert window.controller is not None
    return window.controller


@pytest.fixture
def press(window: MainWindow, controller: RecordingController, qtbot: QtBot) -> Press:
    """Press a key where the keyboard is."""

    def press(key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        QTest.keyClick(window.focusWidget() or window, key, modifiers)
        qtbot.wait(1)

    return press


@pytest.fixture(scope="session")
def shifted_run(tiny_run: Run) -> tuple[Run, int]:
    """The run with somebody a metre beside where he is for a while, and nobody there late."""
    tracks = {name: column.copy() for name, column in tiny_run.tracks.items()}
    track = tracks["track"][tracks["frame"] == SHIFTED[0]].tolist()[0]
    moved = (tracks["track"] == track) & (tracks["frame"] >= SHIFTED[0])
    moved &= tracks["frame"] < SHIFTED[1]
    tracks["x"][moved] += 1.0
    tracks["left"][moved] += 40.0
    return replace(tiny_run, tracks=tracks, signals=empty(SIGNAL_COLUMNS)), track


@pytest.fixture
def shifted_session(tiny_recording: Path, shifted_run: tuple[Run, int], tmp_path: Path) -> Path:
    """A saved session of that run."""
    path = tmp_path / "shifted.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [shifted_run[0]], path)
        document_loader.remember_place(session, recording)
        session.close()
    return path


@pytest.fixture
def shifted_controller(
    window: MainWindow, qtbot: QtBot, shifted_session: Path
) -> RecordingController:
    """The recording's controller on that session, at the frame to track again from."""
    window.files.open_path(shifted_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    assert window.controller is not None
    window.controller.playback.go(AGAIN_AT)
    return window.controller


@pytest.fixture
def swapped_session(tiny_recording: Path, tiny_run: Run, tmp_path: Path) -> tuple[Path, set[int]]:
    """A session in which two people have each other's id from a frame on, and who they are."""
    path = tmp_path / "swapped.h5"
    run, who = swapped(tiny_run)
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [run], path)
        document_loader.remember_place(session, recording)
        session.close()
    return path, who
