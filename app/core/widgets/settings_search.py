"""Which settings of a form are shown: those offered, or those found by words."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit, QToolButton, QWidget

from app.core.i18n import tr
from app.core.look.theme import scaled_font


class FoldButton(QToolButton):
    """A heading that folds what stands below it; folded at first."""

    def __init__(self, title: str, body: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self._body = body
        self.setText(title)
        self.setAccessibleName(tr("{0}: show or hide").format(title))
        self.setFont(scaled_font(parent.font(), 1.0, bold=True))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setCheckable(True)
        self.setProperty("fold", True)
        self.toggled.connect(self._fold)
        self._fold(False)

    def open_found(self, found: bool, sought: bool) -> None:
        """Stand open where something below is found, and as before where nothing is sought."""
        self.setVisible(found)
        self._fold(found if sought else self.isChecked())

    def unfold(self) -> None:
        """Show what stands below."""
        self.setChecked(True)

    def _fold(self, is_open: bool) -> None:
        self.setArrowType(Qt.ArrowType.DownArrow if is_open else Qt.ArrowType.RightArrow)
        self._body.setVisible(is_open)


@dataclass(frozen=True, slots=True)
class SettingRow:
    """A setting in a form.

    Attributes:
        name: dotted. words: what it is found by. widgets: its own. title: the heading it stands
            under, with others. fold: what folds its group; None: it stands open.
    """

    name: str
    words: str
    widgets: tuple[QWidget, ...]
    title: QWidget | None
    fold: FoldButton | None


def show_found(rows: Sequence[SettingRow], sought: str, offered: Container[str]) -> int:
    """Show the settings that have all the words, with their headings, and tell how many.

    Where nothing is sought, those are shown whose names are `offered`.
    """
    words = sought.lower().split()
    found = [
        all(word in row.words.lower() for word in words) if words else row.name in offered
        for row in rows
    ]
    titles: dict[QWidget, bool] = {}
    folds: dict[FoldButton, bool] = {}
    for row, is_found in zip(rows, found, strict=True):
        for widget in row.widgets:
            widget.setVisible(is_found)
        if row.title is not None:
            titles[row.title] = titles.get(row.title, False) or is_found
        if row.fold is not None:
            folds[row.fold] = folds.get(row.fold, False) or is_found
    for title, is_found in titles.items():
        title.setVisible(is_found)
    for fold, is_found in folds.items():
        fold.open_found(is_found, bool(words))
    return sum(found)


class SettingSearch(QLineEdit):
    """What is sought; Enter goes on to what was found, and never answers the dialog."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setPlaceholderText(tr("Search settings"))
        self.setAccessibleName(tr("Search settings"))
        self.setClearButtonEnabled(True)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Enter, and Esc where it clears."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.focusNextChild()
        elif event.key() == Qt.Key.Key_Escape and self.text():
            self.clear()
        else:
            super().keyPressEvent(event)
