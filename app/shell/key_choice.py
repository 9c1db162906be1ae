"""The keys of the program: what the user chose, kept from one start to the next."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.core import keymap
from app.core.widgets.user_settings import UserSettings
from app.features.keys.dialog import KeysDialog
from app.features.keys.presenter import KeysPresenter
from app.features.keys.profile_file import parse_profile, profile_text
from app.features.keys.scene import OwnKeys, resolved

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

_KEY = "keys"


class KeyChoice(QObject):
    """Gives the commands of a window their keys.

    Signals: `changed()`: commands have other keys.
    """

    changed = Signal()

    def __init__(self, window: MainWindow, remembered: UserSettings) -> None:
        super().__init__(window)
        self._window, self._remembered = window, remembered
        self._declared = {one.id: one.keys for one in window.registry.commands}
        keymap.use_keys(resolved(self._declared, self.own))

    @property
    def own(self) -> OwnKeys:
        """What the user chose; the program's own keys where that cannot be read."""
        try:
            return parse_profile(self._remembered.text(_KEY), self._declared)
        except (ValueError, RecursionError):
            return OwnKeys()

    def use(self, own: OwnKeys) -> None:
        """Use other keys and remember them."""
        self._remembered.set_text(_KEY, profile_text(own))
        keymap.use_keys(resolved(self._declared, own))
        self.changed.emit()

    def edit(self) -> None:
        """Let the user change them."""
        presenter = KeysPresenter(self._window.registry.items(), self._declared, self.own)
        dialog = KeysDialog(presenter, self._remembered.last_folder("keys"), self._window)
        dialog.changed.connect(self.use)
        dialog.finished.connect(self._window.activateWindow)
        dialog.open()
