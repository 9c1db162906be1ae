"""F1: every key, by menu."""

from __future__ import annotations

from itertools import accumulate

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.scenes import CommandItem
from app.core.widgets.command_list import native_keys
from app.core.widgets.parts import heading, quiet
from app.core.widgets.tab_order import tab_in_reading_order

_MOST_COLUMNS = 3
_SCREEN_SHARE = 0.9
_MARGIN, _SCROLL_BAR, _APART = 16, 16, 16


class ShortcutsDialog(QDialog):
    """All commands that have keys, grouped; a line above narrows them down.

    Signals: `change_asked()`: other keys are wanted.
    """

    change_asked = Signal()

    def __init__(self, items: tuple[CommandItem, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._items = tuple(item for item in items if item.keys)
        self.setWindowTitle(tr("Keyboard shortcuts"))
        self._find = QLineEdit(self)
        self._find.setPlaceholderText(tr("Find a command or a key"))
        self._find.setAccessibleName(tr("Find a command or a key"))
        self._find.setClearButtonEnabled(True)
        self._find.textChanged.connect(self.narrow)
        self._scroll = QScrollArea(self)
        self._scroll.setAccessibleName(tr("Keyboard shortcuts"))
        self._scroll.setWidgetResizable(True)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(_MARGIN, _MARGIN, _MARGIN, _MARGIN)
        rows.setSpacing(12)
        head = QHBoxLayout()
        head.setSpacing(_APART)
        head.addWidget(self._find, 1)
        change = QPushButton(tr("Change keys..."), self)
        change.setAutoDefault(False)
        change.clicked.connect(self._change)
        head.addWidget(change)
        rows.addLayout(head)
        rows.addWidget(self._scroll, 1)
        tab_in_reading_order(self)
        self._columns = self._fitting_columns()
        self.narrow("")
        self._fit_page()

    def narrow(self, typed: str) -> None:
        """Show only commands whose title or key holds what is typed."""
        groups = self._groups(typed.strip().lower())
        self._scroll.setWidget(self._page(groups, self._columns))

    def _change(self) -> None:
        self.accept()
        self.change_asked.emit()

    def _groups(self, wanted: str = "") -> dict[str, list[CommandItem]]:
        groups: dict[str, list[CommandItem]] = {}
        for item in self._items:
            if wanted in f"{item.title} {item.also} {' '.join(item.keys)}".lower():
                groups.setdefault(item.menu, []).append(item)
        return groups

    def _room(self) -> QSize:
        return self.screen().availableSize() * _SCREEN_SHARE

    def _fitting_columns(self) -> int:
        """As many columns as fit on the screen, so that nothing is cut off."""
        fitting = (n for n in range(_MOST_COLUMNS, 1, -1) if self._fits(self._size(n).width()))
        return next(fitting, 1)

    def _fits(self, width: int) -> bool:
        return width <= self._room().width()

    def _fit_page(self) -> None:
        """Be as large as all commands need, where the screen is."""
        size = self._size(self._columns).boundedTo(self._room())
        self.setMinimumWidth(size.width())
        self.resize(size)

    def _size(self, columns: int) -> QSize:
        """What the dialog takes with all commands in so many columns."""
        page = self._page(self._groups(), columns)
        inner = page.sizeHint()
        page.deleteLater()
        find = self._find.sizeHint().height() + 16
        return inner + QSize(2 * _MARGIN + _SCROLL_BAR, 2 * _MARGIN + find + 4)

    def _page(self, groups: dict[str, list[CommandItem]], count: int) -> QWidget:
        """Groups in the order of the menus, down one column and then the next, of like heights."""
        page = QWidget(self._scroll)
        across = QHBoxLayout(page)
        across.setContentsMargins(0, 0, 8, 0)
        across.setSpacing(32)
        columns = [QVBoxLayout() for _ in range(count)]
        for column in columns:
            column.setSpacing(0)
        heights = [len(items) + 2 for items in groups.values()]
        middles = [end - high / 2 for end, high in zip(accumulate(heights), heights, strict=True)]
        for (menu, items), middle in zip(groups.items(), middles, strict=True):
            column = columns[int(count * middle / sum(heights))]
            column.addLayout(self._group(menu, items, page))
            column.addSpacing(20)
        for column in columns:
            column.addStretch(1)
            across.addLayout(column, 1)
        if not groups:
            columns[0].insertWidget(0, quiet(tr("Nothing matches."), page))
        return page

    def _group(self, menu: str, items: list[CommandItem], page: QWidget) -> QGridLayout:
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(4)
        grid.setHorizontalSpacing(_APART)
        grid.setColumnStretch(0, 1)
        grid.addWidget(heading(menu, page), 0, 0, 1, 2)
        for line, item in enumerate(items, start=1):
            grid.addWidget(QLabel(item.title, page), line, 0)
            keys = QHBoxLayout()
            keys.setSpacing(4)
            keys.addStretch(1)
            for key in item.keys:
                keys.addWidget(key_label(key, page))
            grid.addLayout(keys, line, 1)
        return grid


def key_label(keys: str, parent: QWidget) -> QLabel:
    """A key drawn like a key."""
    label = QLabel(native_keys(keys), parent)
    label.setProperty("role", "key")
    label.setFont(scaled_font(parent.font(), 0.88))
    return label
