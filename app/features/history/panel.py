"""What was done, newest first; any point can be gone back to, any edit be undone alone."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import (
    QLineEdit,
    QListView,
    QMenu,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.feature import FeaturePanel
from app.core.i18n import count_text, tr
from app.core.keymap import first_key
from app.core.look.icons import IconButton
from app.core.scenes import HistoryItem
from app.core.widgets.eliding_list import ElidingList
from app.core.widgets.literal import literal
from app.core.widgets.parts import quiet
from app.features.history.history_filter import HistoryFilter
from app.features.history.history_model import ITEM, EditDelegate, HistoryModel, row_height

_AROUND_PX = 20
"""Around the words of the field, px."""
_ROWS = 4  # seen at least
_LAID_AT_ONCE = 300


class HistoryPanel(FeaturePanel):
    """Draws the history, a tuple of :class:`HistoryItem`, oldest first; without edits, a line.

    Signals:
        edit_sought(int): an entry was clicked; to what it changed.
        goto_asked(int): undo, or redo, until this edit is the last one done.
        alone_asked(int): undo this edit alone.
        menu_opening(int): the menu of an edit is about to open: `say_why_not_alone` may be called.
    """

    edit_sought = Signal(int)
    goto_asked = Signal(int)
    alone_asked = Signal(int)
    menu_opening = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("History"), parent)
        self._items: tuple[HistoryItem, ...] = ()
        self._why_not_alone = ""
        self._undo = IconButton("undo", tr("Undo"), "edit.undo", self)
        self._undo.clicked.connect(lambda: self.command_asked.emit("edit.undo"))
        self._redo = IconButton("redo", tr("Redo"), "edit.redo", self)
        self._redo.clicked.connect(lambda: self.command_asked.emit("edit.redo"))
        self._add_filter()
        self.add_to_heading(self._undo)
        self.add_to_heading(self._redo)
        self._model = HistoryModel(self)
        self._list = self._build_list()
        self._empty = quiet(tr("No edits yet: what you correct is listed here."), self)
        self._empty.setWordWrap(True)
        self._listed = QWidget(self)
        rows = QVBoxLayout(self._listed)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        rows.addWidget(self._list, 1)
        self._none = quiet(tr("No edit matches."), self)
        rows.addWidget(self._none)
        both = QVBoxLayout()  # no stack: what is hidden would keep its room
        both.addWidget(self._empty, 0, Qt.AlignmentFlag.AlignTop)
        both.addWidget(self._listed, 1)
        self.layout_body(both)
        self.show_scene(())

    def _build_list(self) -> QListView:
        view = QListView(self)
        view.setModel(self._model)
        view.setAccessibleName(tr("Edits, newest first"))
        view.setProperty("rows", True)
        view.setUniformItemSizes(True)
        view.setLayoutMode(QListView.LayoutMode.Batched)  # all of a long log at once: 50 ms an edit
        view.setBatchSize(_LAID_AT_ONCE)
        view.setMouseTracking(True)
        view.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        view.setItemDelegate(EditDelegate(view))
        view.setMinimumHeight(_ROWS * row_height(view.font()))
        view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        view.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        view.customContextMenuRequested.connect(self._open_menu)
        view.clicked.connect(lambda index: self.edit_sought.emit(_item_of(index).edit))
        view.doubleClicked.connect(lambda index: self.goto_asked.emit(_item_of(index).edit))
        return view

    def _add_filter(self) -> None:
        """In the heading: a line of its own would cost the list one of its rows."""
        self._text = QLineEdit(self)
        self._text.setPlaceholderText(tr("Find"))
        words = self.fontMetrics().horizontalAdvance(self._text.placeholderText())
        self._text.setMinimumWidth(words + _AROUND_PX)
        self._text.setAccessibleName(tr("Find edits by words or a track's id"))
        self._text.setToolTip(self._text.accessibleName())
        self._text.setClearButtonEnabled(True)
        for button in self._text.findChildren(QToolButton):
            button.setAccessibleName(tr("Clear"))
        self._text.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._text.textChanged.connect(self._narrow)
        self._by = ElidingList(tr("Whose edits, or of which kind"), self)
        self._by.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._by.currentIndexChanged.connect(self._narrow)
        self.add_to_heading(self._text, 3)
        self.add_to_heading(self._by, 3)

    @property
    def current_edit(self) -> int:
        """The edit that was clicked last; 0 where there is none."""
        index = self._list.currentIndex()
        return _item_of(index).edit if index.isValid() else 0

    def show_scene(self, items: tuple[HistoryItem, ...]) -> None:
        """Show another history."""
        self._undo.setEnabled(any(not item.undone for item in items))
        self._redo.setEnabled(bool(items) and items[-1].undone)
        self._empty.setVisible(not items)
        for widget in (self._listed, self._text, self._by):
            widget.setVisible(bool(items))
        self.keep_low(not items)
        if items is not self._items:
            self._items = items
            self._offer_filters()
            self._narrow()

    def say_why_not_alone(self, why: str) -> None:
        """Why the edit whose menu opens cannot be undone alone; "" where it can."""
        self._why_not_alone = why

    def _offer_filters(self) -> None:
        """Everybody and every kind of edit that is there."""
        authors = sorted({item.author for item in self._items if item.author})
        kinds = sorted({item.kind for item in self._items if item.kind})
        offered = [
            (tr("All edits"), ("", "")),
            *((tr("By {0}").format(one), (one, "")) for one in authors),
            *((tr("Kind: {0}").format(one), ("", one)) for one in kinds),
        ]
        if [text for text, _ in offered] == [self._by.itemText(n) for n in range(self._by.count())]:
            return
        chosen = self._by.currentText()
        self._by.blockSignals(True)
        self._by.clear()
        for text, wanted in offered:
            self._by.addItem(text, wanted)
        self._by.setCurrentIndex(max(0, self._by.findText(chosen)))
        self._by.blockSignals(False)

    def _narrow(self) -> None:
        author, kind = self._by.currentData() or ("", "")
        shown = HistoryFilter(self._text.text(), author, kind).of(self._items)
        self._model.show_items(shown)
        self._none.setVisible(bool(self._items) and not shown)
        left_out = len(self._items) - len(shown)
        told = count_text(
            left_out, "{n} other edit is not listed", "{n} other edits are not listed"
        )
        self._text.setToolTip(told if left_out else "")

    def _open_menu(self, at: QPoint) -> None:
        index = self._list.indexAt(at)
        if not index.isValid():
            return
        item = _item_of(index)
        menu = QMenu(self._list)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.setToolTipsVisible(True)
        text = tr("Redo to here") if item.undone else tr("Undo to here")
        menu.addAction(text).triggered.connect(lambda: self.goto_asked.emit(item.edit))
        self._add_alone(menu, item)
        go = tr("Go to frame {0}").format(item.frame)
        menu.addAction(go).triggered.connect(lambda: self.edit_sought.emit(item.edit))
        menu.popup(self._list.viewport().mapToGlobal(at))

    def _add_alone(self, menu: QMenu, item: HistoryItem) -> None:
        """Undo this one alone; where that cannot be, the reason stands below it."""
        self._why_not_alone = ""
        self.menu_opening.emit(item.edit)
        alone: QAction = menu.addAction(
            tr("Undo only this edit") + f"\t{first_key('edit.undo_alone')}"
        )
        alone.triggered.connect(lambda: self.alone_asked.emit(item.edit))
        if self._why_not_alone:
            alone.setEnabled(False)
            alone.setToolTip(self._why_not_alone)
            menu.addAction(literal(self._why_not_alone)).setEnabled(False)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Enter on an edit goes to what it changed."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.current_edit:
            self.edit_sought.emit(self.current_edit)
        else:
            super().keyPressEvent(event)


def _item_of(index: QModelIndex) -> HistoryItem:
    item = index.data(ITEM)
    assert isinstance(item, HistoryItem)
    return item
