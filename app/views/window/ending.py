"""Ending when the terminal or the system asks for it."""

from __future__ import annotations

import contextlib
import signal
import socket
import sys

from PySide6.QtCore import QCoreApplication, QObject, QSocketNotifier

from app.views.window.main_window import MainWindow

_SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP")  # the last one is unknown to Windows


class EndBySignal(QObject):
    """Closes the window at SIGINT, SIGTERM and SIGHUP, and asks nothing: the journal is on disk.

    The terminal is told where work is that was not saved.

    Python would run a handler in the midst of whatever Qt has just called, an event filter for
    example. So the handlers do nothing, and the signal comes through a socket as an event.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._read, self._written = socket.socketpair()
        self._read.setblocking(False)
        self._written.setblocking(False)
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._end)
        signal.set_wakeup_fd(self._written.fileno(), warn_on_full_buffer=False)
        for name in _SIGNALS:
            if hasattr(signal, name):
                signal.signal(getattr(signal, name), lambda *_: None)

    def _end(self) -> None:
        self._notifier.setEnabled(False)
        try:
            self._close()
        finally:  # no second signal would be heard
            QCoreApplication.quit()

    def _close(self) -> None:
        self._window.workspace.take_typed()
        lines = self._window.files.told_at_end()
        self._window.files.close_without_asking()
        self._window.close()
        # The terminal may be gone, closed, or be none.
        with contextlib.suppress(OSError, ValueError, AttributeError):
            sys.stderr.write("".join(f"{line}\n" for line in lines))
            sys.stderr.flush()
