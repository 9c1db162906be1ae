"""The list of parts that are worth labelling."""

from __future__ import annotations

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtWidgets import QListView, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.scenes.labels import SuggestedPart
from app.core.scenes.queue_rows import ReviewPerson
from app.core.widgets.parts import heading, quiet
from app.core.widgets.queue_list import ITEM, PeopleDelegate, row_height
from app.features.labelling.scene import LabellingScene

_ROWS = 5
_Index = QModelIndex | QPersistentModelIndex


class _Row:
    """A suggestion as the rows of queues are drawn: what, who, when; below it why."""

    def __init__(self, one: SuggestedPart) -> None:
        self.title, self.when, self.why = one.title, one.when, tr(one.reason)
        self.people = (ReviewPerson(one.key[1], one.label, one.colour),)
        self.text = f"{one.title} {one.label} {one.when}: {self.why}"


class SuggestionsModel(QAbstractListModel):
    """Suggestions, taken as a whole."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._from: tuple[SuggestedPart, ...] = ()
        self._rows: list[_Row] = []

    def take(self, suggestions: tuple[SuggestedPart, ...]) -> None:
        """Show others."""
        if suggestions is not self._from:
            self.beginResetModel()
            self._from, self._rows = suggestions, [_Row(one) for one in suggestions]
            self.endResetModel()

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's name
        """How many there are."""
        return 0 if parent.isValid() else len(self._rows)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """The row, or its words."""
        row = self._rows[index.row()]
        if role == ITEM:
            return row
        texts = (
            Qt.ItemDataRole.DisplayRole,
            Qt.ItemDataRole.AccessibleTextRole,
            Qt.ItemDataRole.ToolTipRole,
        )
        return row.text if role in texts else None


class _Delegate(PeopleDelegate):
    """Draws a row of :class:`SuggestionsModel`."""

    def below(self, item: _Row) -> str:
        """Why it is suggested."""
        return item.why


class SuggestionsList(QWidget):
    """What is worth labelling, the best first; hidden while nobody asked.

    Signals:
        chosen(int): the number of the one that was clicked.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 4, 0, 0)
        rows.setSpacing(4)
        self._title = heading("", self)
        self._title.setWordWrap(True)
        self._told = quiet("", self)
        self._told.setWordWrap(True)
        self._model = SuggestionsModel(self)
        self._list = QListView(self)
        self._list.setModel(self._model)
        self._list.setItemDelegate(_Delegate(self._list))
        self._list.setAccessibleName(tr("Where the part-failure detector is least sure"))
        self._list.setProperty("rows", True)
        self._list.setUniformItemSizes(True)
        self._list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.setFixedHeight(_ROWS * row_height(self.font()) + 4)
        self._list.clicked.connect(lambda index: self.chosen.emit(index.row()))
        for widget in (self._title, self._told, self._list):
            rows.addWidget(widget)
        self.hide()

    def show_scene(self, scene: LabellingScene) -> None:
        """Show what is left."""
        found = scene.suggestions
        self.setVisible(found is not None)
        if found is None:
            return
        left = tr("{0} left  (N, P)").format(len(found)) if found else ""
        self._title.setText(tr("Least sure first, parts in turn") + (f"   {left}" if left else ""))
        self._told.setText(scene.doing)
        self._told.setVisible(bool(scene.doing))
        self._model.take(found)
        self._list.setVisible(bool(found))
        index = self._model.index(scene.current)
        if scene.current >= 0 and self._list.currentIndex() != index:
            self._list.setCurrentIndex(index)
            self._list.scrollTo(index)
        elif scene.current < 0:
            self._list.clearSelection()
