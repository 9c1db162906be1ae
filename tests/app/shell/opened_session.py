"""A session opened in the window for tests of all that it shows."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent
from pytestqt.qtbot import QtBot

from app.shell.features import FEATURES
from app.shell.main_window import MainWindow

PANELS = (*(f"view.{feature.id}" for feature in FEATURES if feature.opens), "labels.parts")
"""The commands that open and close each panel."""


def open_with_anna(window: MainWindow, qtbot: QtBot, path: Path) -> None:
    """Open a session, select its first person, name her, wait until nothing is looked for."""
    window.files.open_path(path)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    controller = window.controller
    assert controller is not None
    first = controller.document.tracks.ids[0]
    controller.editing.pick(first)
    controller.editing.rename(first, "Anna")
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    laid_out(qtbot)


def laid_out(qtbot: QtBot) -> None:
    """Wait until everything has its place, and closed dialogs have gone."""
    qtbot.wait(60)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def told(found: Iterable[str]) -> str:
    """What was found, each once, a line each."""
    return "\n".join(dict.fromkeys(found))
