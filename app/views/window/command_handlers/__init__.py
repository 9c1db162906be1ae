"""What each command of the catalogue does in the window."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.views.window.command_handlers.detector_handlers import DETECTING
from app.views.window.command_handlers.label_handlers import LABELLING
from app.views.window.command_handlers.playback_handlers import PLAYING
from app.views.window.command_handlers.recording_handler import RecordingHandler
from app.views.window.command_handlers.review_handlers import REVIEWING
from app.views.window.command_handlers.track_handlers import CORRECTING
from app.views.window.command_handlers.view_handlers import VIEWING
from app.views.window.command_handlers.window import of_the_window

if TYPE_CHECKING:
    from app.views.window.main_window import MainWindow

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
