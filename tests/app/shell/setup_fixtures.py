"""Somebody before the set-up's window, and bare videos for it."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from tests.benchmarks.setup.user import SetupUser

PATIENCE_MS = 60_000


@pytest.fixture
def card(tiny_recording: Path, tmp_path: Path) -> Path:
    """The cameras' files as a camera names them, the right one first."""
    folder = tmp_path / "card"
    folder.mkdir()
    for side, name in (("left", "GX010035"), ("right", "GX010034")):
        source = next(tiny_recording.glob(f"{side}*"))
        shutil.copyfile(source, folder / (name + source.suffix))
    return folder


@pytest.fixture
def with_calibration(card: Path, tiny_recording: Path) -> Path:
    """The same with the calibration beside them."""
    shutil.copyfile(tiny_recording / "calibration.yaml", card / "calibration.yaml")
    return card


@pytest.fixture
def user(window: MainWindow, qtbot: QtBot) -> Iterator[SetupUser]:
    """Who sits before the window."""
    window.resize(1000, 640)
    window.show()
    user = SetupUser(window, lambda ready: qtbot.waitUntil(ready, timeout=PATIENCE_MS))
    yield user
    if window.files.setup.dialog is not None:
        user.wait_for_rest()
        window.files.setup.dialog.reject()


Begin = Callable[[Path], SetupUser]


@pytest.fixture
def begin(user: SetupUser) -> Begin:
    """Drops the videos of a folder and waits until they were looked at."""

    def begin(folder: Path) -> SetupUser:
        user.drop(sorted(folder.glob("GX*")))
        user.wait(lambda: user.window.files.setup.dialog is not None)
        user.wait_for_rest()
        return user

    return begin
