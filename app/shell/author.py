"""The name that edits are logged under."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QInputDialog

from app.core.i18n import tr
from app.core.widgets.user_settings import UserSettings

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

_KEY = "author"
_LONGEST = 80


class Author(QObject):
    """Asks for the user's name, remembers it, and has the open document log edits under it."""

    def __init__(self, window: MainWindow, remembered: UserSettings, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._remembered = remembered

    @property
    def name(self) -> str:
        """The name chosen here; "" for that of the account."""
        return self._remembered.text(_KEY)

    def ask(self) -> None:
        """Ask for the name."""
        dialog = QInputDialog(self._window)
        dialog.setObjectName("author")
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(tr("Your name"))
        dialog.setLabelText(
            tr(
                "Edits are kept in the history under this name. "
                "Leave it empty to use the name of your account."
            )
        )
        controller = self._window.controller
        session = controller.document.session if controller is not None else None
        dialog.setTextValue(self.name or (session.author if session is not None else ""))
        dialog.textValueSelected.connect(self.set_name)
        dialog.open()

    def set_name(self, name: str) -> None:
        """Log edits under another name from now on; earlier ones keep theirs."""
        plain = " ".join(name.split())[:_LONGEST]
        self._remembered.set_text(_KEY, plain)
        self.sign()

    def sign(self) -> None:
        """Have the open document log under the name."""
        controller = self._window.controller
        if controller is not None:
            controller.document.sign(self.name)
