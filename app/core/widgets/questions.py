"""Questions to the user that do not stop the event loop."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from app.core.i18n import tr
from app.core.widgets.user_settings import LastFolder

OnPath = Callable[[Path], object]


def choose_file(
    parent: QWidget,
    title: str,
    filters: str,
    chosen: OnPath,
    last: LastFolder,
    *,
    folder: bool = False,
) -> None:
    """Ask for a file or folder that exists; `chosen` gets its path.

    It begins where one was chosen last, else beside what is open or was opened last, else at home.
    """
    dialog = QFileDialog(parent, title)
    mode = QFileDialog.FileMode.Directory if folder else QFileDialog.FileMode.ExistingFile
    dialog.setFileMode(mode)
    if filters:
        dialog.setNameFilters([filters, tr("All files (*)")])
    dialog.setDirectory(str(last.folder or last.remembered.recent_folder or Path.home()))
    _open(dialog, chosen, last)


def choose_new_file(
    parent: QWidget, title: str, start: Path, filters: str, chosen: OnPath, last: LastFolder
) -> None:
    """Ask where to write; the file dialog itself asks before something is replaced.

    It begins where such a file was written last, else in the folder of `start`.
    """
    dialog = QFileDialog(parent, title, str(last.folder or start.parent), filters)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setDefaultSuffix(start.suffix.lstrip("."))
    dialog.selectFile(start.name)
    _open(dialog, chosen, last)


def _open(dialog: QFileDialog, chosen: OnPath, last: LastFolder) -> None:
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def take(text: str) -> None:
        last.note(Path(text))
        chosen(Path(text))

    dialog.fileSelected.connect(take)
    dialog.open()


def ask_unit(parent: QWidget, name: str, chosen: Callable[[str], object]) -> None:
    """Ask for the unit of lengths in a file of that name; `chosen` gets "m" or "cm"."""
    box = QMessageBox(parent)
    box.setObjectName("unit")
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setIcon(QMessageBox.Icon.Question)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(tr("{name} does not state the unit of its lengths.", name=name))
    box.setInformativeText(tr("People walk about a metre in a second."))
    role = QMessageBox.ButtonRole.AcceptRole
    units = {box.addButton(tr("Metres"), role): "m", box.addButton(tr("Centimetres"), role): "cm"}
    box.addButton(QMessageBox.StandardButton.Cancel)

    def answered(_: int) -> None:
        unit = next((unit for button, unit in units.items() if button is box.clickedButton()), "")
        if unit:
            chosen(unit)

    box.finished.connect(answered)
    box.open()


def ask_about_unsaved(
    parent: QWidget,
    words: tuple[str, str],
    save: Callable[[], object] | None,
    discard: Callable[[], object],
    stay: Callable[[], object] = lambda: None,
) -> QMessageBox:
    """Save, Discard or Cancel; without `save` a tracker is still at work, and there is no Save.

    words: the question, and what is lost. stay: after Cancel. Gives the open box; closing it is
    Cancel.
    """
    box = QMessageBox(parent)
    box.setObjectName("unsaved")
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setIcon(QMessageBox.Icon.Question)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(words[0])
    box.setInformativeText(words[1])
    buttons = QMessageBox.StandardButton
    if save is None:
        box.setStandardButtons(buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Cancel)
    else:
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)

    def answered(_: int) -> None:
        chosen = box.standardButton(box.clickedButton())
        if chosen == buttons.Save and save is not None:
            save()
        elif chosen == buttons.Discard:
            discard()
        else:
            stay()

    box.finished.connect(answered)
    box.open()
    return box
