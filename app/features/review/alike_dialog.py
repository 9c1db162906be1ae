"""Asks which review items are decided together, and shows them first."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListWidget,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, time_text, tr
from app.core.widgets.parts import quiet
from app.core.widgets.tab_order import tab_in_reading_order
from app.features.review.alike import AlikeGroup
from app.features.review.presenter import kind_title

_MOST_LISTED = 500
_WIDTH_LETTERS, _LINES = 100, 12


class AlikeDialog(QDialog):
    """Groups of review items with how many each holds, and a list of those of the chosen one.

    Signals:
        decided(object, str): the items of the chosen group, and "right" or "dismissed".
    """

    decided = Signal(object, str)

    def __init__(self, groups: Sequence[AlikeGroup], fps: float, parent: QWidget) -> None:
        """groups: one at least."""
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Decide for all alike"))
        self._groups, self._fps = tuple(groups), fps
        self.choices = QButtonGroup(self)
        self._about = quiet("", self)
        self._about.setWordWrap(True)
        self.listed = QListWidget(self)
        self.listed.setAccessibleName(tr("Review items that are decided"))
        self.listed.setWordWrap(True)
        self.listed.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(8)
        for number, group in enumerate(self._groups):
            rows.addWidget(self._choice(number, group))
        rows.addWidget(self.listed, 1)
        rows.addWidget(self._about)
        rows.addWidget(self._meaning())
        rows.addWidget(self._buttons())
        tab_in_reading_order(self)
        self.choices.idToggled.connect(lambda number, on: self._show(number) if on else None)
        self.choices.button(0).setChecked(True)
        letters = self.fontMetrics()
        self.resize(
            min(_WIDTH_LETTERS * letters.averageCharWidth(), parent.width()),
            self.sizeHint().height() + _LINES,
        )

    def _choice(self, number: int, group: AlikeGroup) -> QRadioButton:
        count = count_text(len(group.items), "{n} item", "{n} items")
        # An ampersand in a name would be taken for the mark of a key.
        title = tr("{title} ({count})", title=group.title, count=count).replace("&", "&&")
        choice = QRadioButton(title, self)
        self.choices.addButton(choice, number)
        return choice

    def _meaning(self) -> QLabel:
        """What the two decisions say, and what comes of them."""
        words = quiet(
            tr(
                "All are right: the tracks are correct there, and the likelihoods of the items "
                "left learn from it. Dismiss all: the items go, and nothing is said of the tracks."
            ),
            self,
        )
        words.setWordWrap(True)
        return words

    def _buttons(self) -> QDialogButtonBox:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, self)
        role = QDialogButtonBox.ButtonRole.AcceptRole
        self.right = QPushButton(tr("All are right"), self)
        self.dismiss = QPushButton(tr("Dismiss all"), self)
        for button, decision in ((self.right, "right"), (self.dismiss, "dismissed")):
            box.addButton(button, role)
            button.clicked.connect(lambda _=False, said=decision: self._decide(said))
        box.rejected.connect(self.reject)
        return box

    def _show(self, number: int) -> None:
        items = self._groups[number].items
        self.listed.clear()
        self.listed.addItems(
            [
                f"{time_text(one.frame / self._fps)}  {kind_title(one.kind)}: {tr(one.text)}"
                for one in items[:_MOST_LISTED]
            ]
        )
        self._about.setText(
            count_text(
                len(items),
                "{n} item is decided in one step, which can be undone.",
                "{n} items are decided in one step, which can be undone.",
            )
        )

    def _decide(self, decision: str) -> None:
        items = self._groups[self.choices.checkedId()].items
        self.accept()
        self.decided.emit(items, decision)


def open_alike_dialog(groups: Sequence[AlikeGroup], fps: float, window: QWidget) -> AlikeDialog:
    """Open the dialog over a window."""
    dialog = AlikeDialog(groups, fps, window)
    dialog.finished.connect(window.activateWindow)  # not every desktop does so
    dialog.open()
    return dialog
