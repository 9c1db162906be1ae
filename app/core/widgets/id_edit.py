"""A field for the id of a track."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QIntValidator, QKeyEvent
from PySide6.QtWidgets import QLineEdit, QWidget

_LARGEST_ID = 2**31 - 1
_CONSIDERED_MS = 250
"""A pause in typing after which the id may be whole."""


class IdEdit(QLineEdit):
    """Takes a track's id. It wants digits and their correction only: other keys stay shortcuts.

    Signals:
        typed(int): Enter was pressed.
        considered(int): typing paused at this id; 0: at none.
    """

    typed = Signal(int)
    considered = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setValidator(QIntValidator(1, _LARGEST_ID, self))
        self._pause = QTimer(self, singleShot=True, interval=_CONSIDERED_MS)
        self._pause.timeout.connect(lambda: self.considered.emit(int(self.text() or 0)))
        self.textEdited.connect(lambda: self._pause.start())
        self.returnPressed.connect(self._send)

    @property
    def being_typed(self) -> bool:
        """Whether the user is typing into it."""
        return self.isModified() and self.window().focusWidget() is self

    def _send(self) -> None:
        self._pause.stop()
        self.typed.emit(int(self.text()))

    def take_back(self) -> None:
        """Forget what was typed."""
        self._pause.stop()
        self.setText("")

    def wants(self, event: QKeyEvent) -> bool:
        """Whether a key is typed into the field rather than a shortcut of the window."""
        corrections = (Qt.Key.Key_Backspace, Qt.Key.Key_Return, Qt.Key.Key_Enter)
        return event.text().isdigit() or (bool(self.text()) and event.key() in corrections)

    def event(self, event: QEvent) -> bool:
        """Leave the keys to the window that are not wanted here."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            event.setAccepted(self.wants(event))
            return event.isAccepted()
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Pass on letters, which no field of digits takes: the window may say something of them."""
        text = event.text()
        if text.isprintable() and text and not text.isdigit():
            event.ignore()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        """What is typed replaces what is there."""
        super().focusInEvent(event)
        self.selectAll()
