"""The program with its window: started, shown, and drawn into a picture."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from types import TracebackType

from PySide6.QtCore import (
    QCoreApplication,
    QEventLoop,
    QLockFile,
    QSettings,
    Qt,
    QTimer,
)
from PySide6.QtWidgets import QApplication

from app.core.document import document_loader
from app.core.look.icons import application_icon
from app.core.look.theme import Look, apply_look
from app.core.memory import map_large_blocks
from app.core.widgets.user_settings import UserSettings
from app.shell.language_choice import show_language
from app.shell.look_choice import look_of
from app.shell.main_window import MainWindow
from app.shell.shutdown_signals import EndBySignal, EndSignals, take_down
from app.shell.window_host import WindowHost
from tracking.atomic_output import part_of
from tracking.errors import OutputError, RecordingError
from tracking.recording import OpenOptions

_log = logging.getLogger(__name__)
_PATIENCE_MS = 60_000
_EFFECTS = (
    *(Qt.UIEffect.UI_AnimateMenu, Qt.UIEffect.UI_FadeMenu, Qt.UIEffect.UI_AnimateCombo),
    *(Qt.UIEffect.UI_AnimateTooltip, Qt.UIEffect.UI_FadeTooltip, Qt.UIEffect.UI_AnimateToolBox),
)
"""What a desktop may have moving; here nothing moves but the footage."""


def run(
    path: Path | None,
    options: OpenOptions | None = None,
    *,
    play: bool = False,
    save_at: Path | None = None,
) -> int:
    """Show the window until it is closed; the exit status.

    Args:
        path: a recording or session to open, None for the welcome page.
        options: what a bare recording does not say of itself.
        play: play at once, and track what has no tracks yet.
        save_at: the place that is proposed for the session.
    """
    map_large_blocks()
    remembered = UserSettings()
    application = start_application(remembered)
    signals = EndSignals(application)  # before the first widget
    host = WindowHost(application, remembered)
    _catch_bugs(host)
    EndBySignal(signals, host)
    window = host.window
    alone = QLockFile(str(document_loader.window_lock()))
    left_open = remembered.left_open if alone.tryLock(0) else ()
    first = path or next(iter(left_open), None)
    try:
        if first is not None:
            if first.resolve() in left_open:
                window.files.greet_after_crash()
            window.files.open_path(first, options=options, play=play, save_at=save_at)
        window.show()
        window.tell_of_letters()
        return application.exec()
    finally:
        take_down(host.window)


def start_application(remembered: UserSettings) -> QApplication:
    """The one QApplication of this process, named and dressed as the user chose."""
    there = QApplication.instance()
    application = there if isinstance(there, QApplication) else QApplication(sys.argv[:1])
    application.setApplicationName("trackwright")
    application.setApplicationDisplayName("trackwright")
    application.setOrganizationName("trackwright")
    application.setDesktopFileName("trackwright")
    application.setWindowIcon(application_icon())
    show_language(application, remembered)
    apply_look(application, look_of(remembered))
    for effect in _EFFECTS:
        application.setEffectEnabled(effect, False)
    return application


def picture(
    session_path: Path,
    out_png: Path,
    frame: int | None = None,
    theme: str | None = None,
    size: tuple[int, int] = (1600, 1000),
) -> Path:
    """Draw the real window on a session or recording into a PNG; also without a display.

    Args:
        session_path: what to open.
        out_png: where the picture goes.
        frame: shown; None takes the one with the most people.
        theme: "dark", "light", or None for the system's.
        size: of the window, in pixels.

    Raises:
        TrackwrightError: it cannot be opened, or the picture cannot be written.
        KeyboardInterrupt: a signal asked for the end meanwhile.
    """
    with borrowed_window(theme or Look.SYSTEM.value, size) as window:
        show_document(window, session_path, frame)
        save_picture(window, out_png)
    return out_png


@contextmanager
def borrowed_window(look: str, size: tuple[int, int]) -> Iterator[MainWindow]:
    """A window that nobody sits before, which remembers nothing and asks nothing at the end."""
    with TemporaryDirectory(prefix="trackwright-") as folder:
        path = str(Path(folder) / "settings.ini")
        remembered = UserSettings(QSettings(path, QSettings.Format.IniFormat))
        remembered.set_text("look", look)
        application = start_application(remembered)
        interrupts: list[None] = []
        signals = EndSignals(application)
        signals.arrived.connect(lambda: interrupts.append(None))
        signals.arrived.connect(application.quit)  # whoever waits for the window waits no more
        window = MainWindow(remembered)
        window.resize(*size)
        try:
            yield window
        finally:
            take_down(window)
            signals.close()
            if interrupts:
                raise KeyboardInterrupt


def save_picture(window: MainWindow, out_png: Path) -> None:
    """Draw a window into a PNG once it is at rest.

    Raises:
        OutputError: it cannot be written.
    """
    if not wait_until(lambda: not window.work.busy):
        raise OutputError("{out_png}: the window did not come to rest; try again", out_png=out_png)
    with part_of(out_png) as part:
        if not window.grab().save(str(part), "PNG"):
            raise OutputError("cannot write {out_png}: the picture cannot be made", out_png=out_png)


def show_document(window: MainWindow, path: Path, frame: int | None = None) -> None:
    """Open a path in a window that nobody sits before, and wait until a frame is shown.

    Raises:
        TrackwrightError: it cannot be opened.
    """
    problems: list[Exception] = []
    window.work.failed.connect(problems.append)
    window.files.failed.connect(problems.append)
    window.show()
    window.files.open_path(path)
    wait_until(lambda: window.controller is not None or bool(problems))
    controller = window.controller
    if problems or controller is None:
        raise (
            problems[0] if problems else RecordingError("{path}: opening took too long", path=path)
        )
    controller.playback.go(controller.document.busiest_frame if frame is None else frame)
    wait_until(
        lambda: controller.playback.number == controller.playback.clock.frame or bool(problems)
    )
    wait_until(lambda: controller.playback.frame is not None or bool(problems))
    if problems:
        raise problems[0]


def wait_until(ready: Callable[[], bool], patience_ms: int = _PATIENCE_MS) -> bool:
    """Let the window live until something is so; False where it did not come in time."""
    loop = QEventLoop()
    patience = QTimer(singleShot=True, interval=patience_ms)
    patience.timeout.connect(loop.quit)
    look = QTimer(interval=10)
    look.timeout.connect(lambda: loop.quit() if ready() else None)
    patience.start()
    look.start()
    if not ready():
        loop.exec()
    QCoreApplication.processEvents()
    return ready()


def _catch_bugs(host: WindowHost) -> None:
    """Show what nobody caught as a bug of the program, logged; the journal is safe on disk."""

    def caught(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if isinstance(error, Exception):
            host.window.tell_error(error.with_traceback(trace))
        else:
            sys.__excepthook__(kind, error, trace)

    sys.excepthook = caught
