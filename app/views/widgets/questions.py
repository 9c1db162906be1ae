"""Questions to the user that do not stop the event loop."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from app.presenters.words import tr

OnPath = Callable[[Path], object]


def choose_file(
    parent: QWidget, title: str, filters: str, chosen: OnPath, folder: bool = False
) -> None:
    """Ask for a file or folder that exists; `chosen` gets its path."""
    dialog = QFileDialog(parent, title)
    mode = QFileDialog.FileMode.Directory if folder else QFileDialog.FileMode.ExistingFile
    dialog.setFileMode(mode)
    if filters:
        dialog.setNameFilters([filters, tr("All files (*)")])
    _open(dialog, chosen)


def choose_new_file(parent: QWidget, title: str, start: Path, filters: str, chosen: OnPath) -> None:
    """Ask where to write; the file dialog itself asks before something is replaced."""
    dialog = QFileDialog(parent, title, str(start.parent), filters)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setDefaultSuffix(start.suffix.lstrip("."))
    dialog.selectFile(start.name)
    _open(dialog, chosen)


def _open(dialog: QFileDialog, chosen: OnPath) -> None:
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(lambda text: chosen(Path(text)))
    dialog.open()


def ask_about_unsaved(
    parent: QWidget, save: Callable[[], object] | None, discard: Callable[[], object]
) -> None:
    """Save, Discard or Cancel; without `save` a tracker is still at work, and there is no Save."""
    box = QMessageBox(parent)
    box.setObjectName("unsaved")
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setIcon(QMessageBox.Icon.Question)
    buttons = QMessageBox.StandardButton
    if save is None:
        box.setText(tr("The tracker is still at work."))
        box.setInformativeText(tr("What it found so far is lost unless you stop it first."))
        box.setStandardButtons(buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Cancel)
    else:
        box.setText(tr("Save the changes to this session?"))
        box.setInformativeText(tr("What is not saved is lost."))
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)

    def answered(_: int) -> None:
        chosen = box.standardButton(box.clickedButton())
        if chosen == buttons.Save and save is not None:
            save()
        elif chosen == buttons.Discard:
            discard()

    box.finished.connect(answered)
    box.open()
