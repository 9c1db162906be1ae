"""What each command of the catalogue does in the window."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.shell.detector_handlers import DETECTING
from app.shell.label_handlers import LABELLING
from app.shell.playback_handlers import PLAYING
from app.shell.recording_handler import RecordingHandler
from app.shell.review_handlers import REVIEWING
from app.shell.track_handlers import CORRECTING
from app.shell.view_handlers import VIEWING
from app.shell.window_handlers import of_the_window

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

__all__ = ["runnable_commands"]


def runnable_commands(window: MainWindow) -> dict[str, Callable[[], None]]:
    """For each command of the catalogue what it does."""
    commands = of_the_window(window)
    recording_handlers = {**PLAYING, **VIEWING, **CORRECTING, **REVIEWING, **LABELLING, **DETECTING}
    for name, run in recording_handlers.items():
        commands[name] = _for_open_recording(window, run)
    return commands


def _for_open_recording(window: MainWindow, run: RecordingHandler) -> Callable[[], None]:
    def command() -> None:
        if window.controller is not None:
            run(window.controller)

    return command
