"""Light, dark or like the system: what the user chose."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication

from app.core.look.theme import Look, apply_look
from app.core.widgets.user_settings import UserSettings


class LookChoice(QObject):
    """The look of the program, kept from one start to the next.

    Signals: `changed()`, everything is drawn in other colours.
    """

    changed = Signal()

    def __init__(self, remembered: UserSettings, parent: QObject) -> None:
        super().__init__(parent)
        self._remembered = remembered
        QApplication.styleHints().colorSchemeChanged.connect(self._follow_system)

    @property
    def look(self) -> Look:
        """What the user chose."""
        return look_of(self._remembered)

    def choose(self, look: Look) -> None:
        """Give the program another look and remember it."""
        self._remembered.set_text("look", look.value)
        self._apply()

    def close(self) -> None:
        """Follow the system no longer."""
        QApplication.styleHints().colorSchemeChanged.disconnect(self._follow_system)

    def _apply(self) -> None:
        application = QApplication.instance()
        if isinstance(application, QApplication):
            apply_look(application, self.look)
            self.changed.emit()

    def _follow_system(self) -> None:
        if self.look is Look.SYSTEM:
            self._apply()


def look_of(remembered: UserSettings) -> Look:
    """The look that was chosen; the system's where it was none or is no choice any more."""
    named = remembered.text("look")
    return Look(named) if named in {look.value for look in Look} else Look.SYSTEM
