"""Somebody who corrects tracks in the real window by keys, at random."""

from __future__ import annotations

import random
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSettings, Qt
from PySide6.QtTest import QTest

from app.core.widgets.user_settings import UserSettings
from app.shell.application import start_application, wait_until
from app.shell.main_window import MainWindow
from tests.sweeps.session_state import state
from tracking.session import Session

_KEY = Qt.Key
_CONTROL = Qt.KeyboardModifier.ControlModifier
_SHIFT = Qt.KeyboardModifier.ShiftModifier
_PATIENCE_MS = 300_000
"""Machines are shared, and a sweep gets what others leave."""
_EDITS = {
    "swap": (_KEY.Key_X, _KEY.Key_Tab),
    "split": (_KEY.Key_S,),
    "end here": (_KEY.Key_Delete, _KEY.Key_R),
    "merge": (_KEY.Key_M, _KEY.Key_Tab),
}
"""The keys of an edit between selecting somebody and Enter."""
_OFTEN = (*_EDITS, "rename")
_STEPS = (*_OFTEN, *_OFTEN, "undo", "undo", "redo", "save", "reopen")


class Editor:
    """Works on a session in the window."""

    def __init__(self, session: Path, seed: int) -> None:
        settings = str(session.with_name("settings.ini"))
        remembered = UserSettings(QSettings(settings, QSettings.Format.IniFormat))
        start_application(remembered)
        self._window = MainWindow(remembered)
        self._window.show()
        self._path, self._chance = session, random.Random(seed)
        self._open()

    def step(self) -> str:
        """Take a step; what the session is like then."""
        self._step(self._chance.choice(_STEPS))
        return state(self._session)

    def close(self) -> None:
        """Save, close the session and the window."""
        self._save()
        self._close_session()
        self._window.close()

    @property
    def _session(self) -> Session:
        controller = self._window.controller
        session = controller.document.session if controller is not None else None
        if session is None:
            raise AssertionError("no session is open in the window")
        return session

    def _open(self) -> None:
        self._window.files.open_path(self._path)
        opened = wait_until(lambda: self._window.controller is not None, _PATIENCE_MS)
        assert opened, "the session did not open"

    def _close_session(self) -> None:
        self._press(_KEY.Key_W, modifier=_CONTROL)
        wait_until(lambda: self._window.controller is None, _PATIENCE_MS)

    def _step(self, name: str) -> None:
        if name in _EDITS:
            self._edit(name)
        elif name == "rename":
            self._rename()
        elif name in ("undo", "redo"):
            self._press(_KEY.Key_Z if name == "undo" else _KEY.Key_Y, modifier=_CONTROL)
        elif name == "save":
            self._save(wait=self._chance.random() < 0.5)
        elif self._chance.random() < 0.3:
            self._save()
            if not self._session.dirty:
                self._close_session()
                self._open()

    def _press(
        self, *keys: Qt.Key, modifier: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
    ) -> None:
        for key in keys:
            QTest.keyClick(self._window, key, modifier)
            QCoreApplication.processEvents()

    def _edit(self, name: str) -> None:
        """Select somebody at some frame, and change them; people end seldom, or nobody is left."""
        if name == "end here" and self._chance.random() > 0.3:
            return
        self._press(_KEY.Key_Escape, self._chance.choice((_KEY.Key_Home, _KEY.Key_End)))
        for _ in range(self._chance.randint(0, 6)):
            self._press(self._chance.choice((_KEY.Key_Right, _KEY.Key_Left)), modifier=_SHIFT)
        self._press(*[_KEY.Key_Tab] * self._chance.randint(1, 4), *_EDITS[name])
        if name == "swap":
            self._press(*[_KEY.Key_R] * self._chance.randint(0, 2))
        self._press(_KEY.Key_Return, _KEY.Key_Escape)

    def _rename(self) -> None:
        controller = self._window.controller
        if controller is not None and controller.document.selection:
            name = f"p{self._chance.randint(0, 99)}"
            controller.editing.rename(controller.document.selection.track, name)

    def _save(self, *, wait: bool = True) -> None:
        """Save; without waiting, edits go on meanwhile."""
        self._press(_KEY.Key_S, modifier=_CONTROL)
        if wait:
            wait_until(lambda: not self._window.work.busy, _PATIENCE_MS)
