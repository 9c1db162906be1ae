"""Somebody who corrects tracks in the real window by keys, at random, until the program ends."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, QSettings, Qt
from PySide6.QtTest import QTest

from app.views.application import start_application, wait_until
from app.views.widgets.user_settings import UserSettings
from app.views.window.main_window import MainWindow
from tests.sweeps.session_state import state
from tracking.session import Session

_KEY = Qt.Key
_CONTROL = Qt.KeyboardModifier.ControlModifier
_SHIFT = Qt.KeyboardModifier.ShiftModifier
_PATIENCE_MS = 300_000
"""Machines are shared, and a sweep gets what others leave."""
STEPS_BEFORE_GOING = 400


class Editor:
    """Works in the window; `tell` hears the state of the session after every step."""

    def __init__(
        self,
        session: Path,
        settings: Path,
        seed: int,
        tell: Callable[[str], None],
        steps: int = STEPS_BEFORE_GOING,
    ):
        remembered = UserSettings(QSettings(str(settings), QSettings.Format.IniFormat))
        start_application(remembered)
        self._window = MainWindow(remembered)
        self._window.show()
        self._path, self._tell, self._chance = session, tell, random.Random(seed)
        self._steps_to_go = steps

    def work(self) -> None:
        """Open the session and go on until the program is killed, or for a long while."""
        self._open()
        for _ in range(self._steps_to_go):
            self._chance.choice(self._steps())()
            self._tell(state(self._session))

    def close(self) -> None:
        """Save, close the session and the window."""
        self._save_and_wait()
        self._press(_KEY.Key_W, _CONTROL)
        wait_until(lambda: self._window.controller is None, _PATIENCE_MS)
        self._window.close()

    @property
    def _session(self) -> Session:
        controller = self._window.controller
        session = controller.document.session if controller is not None else None
        if session is None:
            raise AssertionError("no session is open in the window")
        return session

    def _steps(self) -> tuple[Callable[[], None], ...]:
        edits = (self._swap, self._split, self._end_here, self._rename, self._merge)
        undoing = (self._undo, self._undo, self._redo)
        return edits + edits + undoing + (self._save, self._reopen)

    def _open(self) -> None:
        self._window.files.open_path(self._path)
        opened = wait_until(lambda: self._window.controller is not None, _PATIENCE_MS)
        assert opened, "the session did not open"

    # keys

    def _press(self, key: Qt.Key, modifier: Any = Qt.KeyboardModifier.NoModifier) -> None:
        QTest.keyClick(self._window, key, modifier)
        QCoreApplication.processEvents()

    def _select(self) -> None:
        """Somebody, at some frame."""
        self._press(_KEY.Key_Escape)
        self._press(self._chance.choice((_KEY.Key_Home, _KEY.Key_End)))
        for _ in range(self._chance.randint(0, 6)):
            self._press(self._chance.choice((_KEY.Key_Right, _KEY.Key_Left)), _SHIFT)
        for _ in range(self._chance.randint(1, 4)):
            self._press(_KEY.Key_Tab)

    def _swap(self) -> None:
        self._select()
        self._press(_KEY.Key_X)
        self._press(_KEY.Key_Tab)
        for _ in range(self._chance.randint(0, 2)):
            self._press(_KEY.Key_R)
        self._press(_KEY.Key_Return)
        self._press(_KEY.Key_Escape)

    def _split(self) -> None:
        self._select()
        self._press(_KEY.Key_S)
        self._press(_KEY.Key_Return)
        self._press(_KEY.Key_Escape)

    def _end_here(self) -> None:
        """Not so often as to leave nobody."""
        if self._chance.random() < 0.3:
            self._select()
            self._press(_KEY.Key_Delete)
            self._press(_KEY.Key_R)
            self._press(_KEY.Key_Return)
            self._press(_KEY.Key_Escape)

    def _merge(self) -> None:
        self._select()
        self._press(_KEY.Key_M)
        self._press(_KEY.Key_Tab)
        self._press(_KEY.Key_Return)
        self._press(_KEY.Key_Escape)

    def _rename(self) -> None:
        controller = self._window.controller
        if controller is not None and controller.document.selection:
            controller.editing.rename(
                controller.document.selection.track, f"p{self._chance.randint(0, 99)}"
            )

    def _undo(self) -> None:
        self._press(_KEY.Key_Z, _CONTROL)

    def _redo(self) -> None:
        self._press(_KEY.Key_Y, _CONTROL)

    def _save(self) -> None:
        """Begin to save; every other time edit on while that goes on."""
        self._press(_KEY.Key_S, _CONTROL)
        if self._chance.random() < 0.5:
            wait_until(lambda: not self._window.work.busy, _PATIENCE_MS)

    def _save_and_wait(self) -> None:
        self._save()
        wait_until(lambda: not self._window.work.busy, _PATIENCE_MS)

    def _reopen(self) -> None:
        if self._chance.random() < 0.3:
            self._save_and_wait()
            if not self._session.dirty:
                self._press(_KEY.Key_W, _CONTROL)
                wait_until(lambda: self._window.controller is None, _PATIENCE_MS)
                self._open()
