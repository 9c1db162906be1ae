"""Ending when the terminal or the system asks for it."""

from __future__ import annotations

import contextlib
import signal
import socket
import sys

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QSocketNotifier, Signal

from app.core.error_messages import explain
from app.shell.main_window import MainWindow
from app.shell.window_host import WindowHost

_SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP")  # the last one is unknown to Windows


class EndSignals(QObject):
    """SIGINT, SIGTERM and SIGHUP as an event: `arrived()`, once.

    Python would run a handler in the midst of whatever Qt has just called, an event filter for
    example, and PySide crashes at a KeyboardInterrupt there. So the handlers do nothing, and the
    signal comes through a socket. Make one before the first widget.
    """

    arrived = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._read, self._written = socket.socketpair()
        self._read.setblocking(False)
        self._written.setblocking(False)
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._tell)
        self._woken_before = signal.set_wakeup_fd(self._written.fileno(), warn_on_full_buffer=False)
        numbers = [getattr(signal, name) for name in _SIGNALS if hasattr(signal, name)]
        self._before = [(number, signal.signal(number, _wait)) for number in numbers]

    def close(self) -> None:
        """Let signals do what they did before; what arrives from now on is not told."""
        self._notifier.setEnabled(False)
        for number, handler in self._before:
            signal.signal(number, handler)
        signal.set_wakeup_fd(self._woken_before)
        self._read.close()
        self._written.close()

    def _tell(self) -> None:
        self._notifier.setEnabled(False)
        self.arrived.emit()


class EndBySignal(QObject):
    """Closes the window at the first signal, and asks nothing: the journal is on disk.

    The terminal is told where work is that was not saved.
    """

    def __init__(self, signals: EndSignals, host: WindowHost) -> None:
        super().__init__(host)
        self._host = host
        signals.arrived.connect(self._end)

    def _end(self) -> None:
        try:
            self._close()
        finally:  # no second signal would be heard
            QCoreApplication.quit()

    def _close(self) -> None:
        window = self._host.window
        window.workspace.take_typed()
        lines = window.files.describe_unsaved()
        window.files.failed.connect(lambda error: lines.append(explain(error)))
        window.files.close_without_asking()
        window.close()
        # The terminal may be gone, closed, or be none.
        with contextlib.suppress(OSError, ValueError, AttributeError):
            sys.stderr.write("".join(f"{line}\n" for line in lines))
            sys.stderr.flush()


def take_down(window: MainWindow) -> None:
    """End all work of a window, without asking, and destroy it while Python and Qt are whole.

    What is left to the end of the interpreter is destroyed in any order, and calls back into
    Python objects that are gone: that ends in a crash now and then.
    """
    if window.isVisible():
        window.files.close_without_asking()
        window.close()
    window.work.close()
    window.files.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def _wait(*_: object) -> None:
    """The socket tells of the signal."""
