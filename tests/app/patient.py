"""Waiting for the window as long as a slow and busy machine needs.

What comes at all comes within a second on a quiet one; a test that waits for it never sleeps
longer than that takes. So patience costs nothing where all is well. Only a test that checks that
nothing happens waits for a while of its own, with `qtbot.wait`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import SignalInstance
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

PATIENCE_S = 120.0
PATIENCE_MS = 120_000


class PatientBot(QtBot):
    """A `QtBot` that gives up after two minutes rather than after five seconds."""

    def waitUntil(  # noqa: N802, Qt's way
        self, callback: Callable[[], bool | None], *, timeout: int = PATIENCE_MS
    ) -> None:
        super().waitUntil(callback, timeout=timeout)

    def waitSignal(self, signal: SignalInstance, **how: Any) -> Any:  # noqa: N802
        return super().waitSignal(signal, **{"timeout": PATIENCE_MS, **how})

    def waitSignals(self, signals: list[SignalInstance], **how: Any) -> Any:  # noqa: N802
        return super().waitSignals(signals, **{"timeout": PATIENCE_MS, **how})

    def waitCallback(self, **how: Any) -> Any:  # noqa: N802
        return super().waitCallback(**{"timeout": PATIENCE_MS, **how})

    def waitActive(self, widget: QWidget, *, timeout: int = PATIENCE_MS) -> Any:  # noqa: N802
        return super().waitActive(widget, timeout=timeout)

    def waitExposed(self, widget: QWidget, *, timeout: int = PATIENCE_MS) -> Any:  # noqa: N802
        return super().waitExposed(widget, timeout=timeout)
