"""The buttons that a dialog ends with."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QPushButton


def dialog_ends(dialog: QDialog, accept: str) -> QDialogButtonBox:
    """Cancel, and a button that does what the dialog is for, which Enter presses.

    accept: what that button says.
    """
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, dialog)
    button = QPushButton(accept, dialog)
    button.setProperty("primary", True)
    button.setDefault(True)
    buttons.addButton(button, QDialogButtonBox.ButtonRole.AcceptRole)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons
