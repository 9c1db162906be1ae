"""What each command of the catalogue does in the window."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.views.window.command_handlers.detector_handlers import DETECTING
from app.views.window.command_handlers.label_handlers import LABELLING
from app.views.window.command_handlers.on_desk import OnDesk
from app.views.window.command_handlers.playback_handlers import PLAYING
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
    on_desk = {**PLAYING, **VIEWING, **CORRECTING, **REVIEWING, **LABELLING, **DETECTING}
    for name, run in on_desk.items():
        commands[name] = _on_desk(window, run)
    return commands


def _on_desk(window: MainWindow, run: OnDesk) -> Callable[[], None]:
    def command() -> None:
        if window.desk is not None:
            run(window.desk)

    return command
