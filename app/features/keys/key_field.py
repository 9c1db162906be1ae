"""A field that takes the next key pressed, whatever it is, also Tab, Enter and Esc."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QKeyCombination, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QLineEdit, QWidget

from app.core.i18n import tr
from app.features.keys.profile_file import key_text

_ALONE = frozenset(
    {
        Qt.Key.Key_Control,
        Qt.Key.Key_Shift,
        Qt.Key.Key_Alt,
        Qt.Key.Key_AltGr,
        Qt.Key.Key_Meta,
        Qt.Key.Key_CapsLock,
        Qt.Key.Key_unknown,
        Qt.Key(0),
    }
)
"""Keys that are none by themselves."""


class KeyField(QLineEdit):
    """Waits for one key.

    Signals: `pressed(str)`: the key in Qt's portable text. `left()`: another control was chosen.
    """

    pressed = Signal(str)
    left = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setReadOnly(True)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)
        self.setPlaceholderText(tr("Press the key"))
        self.setAccessibleName(tr("Press the key"))

    def event(self, event: QEvent) -> bool:
        """Take keys before anybody makes a shortcut of them, or leaves the field by Tab."""
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()
            return True
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            self._take(event)
            event.accept()
            return True
        return super().event(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        """Wait no longer."""
        super().focusOutEvent(event)
        self.left.emit()

    def _take(self, event: QKeyEvent) -> None:
        if Qt.Key(event.key()) in _ALONE:
            return
        key, modifiers = Qt.Key(event.key()), event.modifiers()
        if key == Qt.Key.Key_Backtab:
            key = Qt.Key.Key_Tab
        sign = event.text()
        if sign.isprintable() and sign.strip() and not sign.isalnum():
            modifiers &= ~Qt.KeyboardModifier.ShiftModifier  # the sign says it already
        modifiers &= ~Qt.KeyboardModifier.KeypadModifier
        text = key_text(QKeySequence(QKeyCombination(modifiers, key)))
        if text:
            self.pressed.emit(text)
