"""What was drawn, by name, and what was reviewed, by range."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.literal import literal
from app.core.widgets.number_boxes import WholeBox, tell_beside
from app.core.widgets.parts import quiet
from app.features.labelling.scene import LabellingScene, RangeLine

_ROWS = 4
_FRAME_LETTERS = 13
_NAME_LETTERS = 14
_LARGEST_FRAME = 2**31 - 2


class DrawnList(QWidget):
    """Names of occluders, lines or regions; a double click or F2 names one anew.

    Signals:
        picked(int): its number. renamed(int, str). removed(int).
    """

    picked = Signal(int)
    renamed = Signal(int, str)
    removed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        self._empty = quiet(tr("None is drawn yet."), self)
        rows.addWidget(self._empty)
        self._list = _short_list(self)
        self._list.setAccessibleName(tr("What is drawn"))
        self._list.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
        )
        self._list.currentRowChanged.connect(self._pick)
        self._list.itemChanged.connect(self._rename)
        rows.addWidget(self._list)
        line = QHBoxLayout()
        self._rename_button = QPushButton(tr("Name"), self)
        self._rename_button.clicked.connect(self._edit)
        self._remove = QPushButton(tr("Delete"), self)
        self._remove.setToolTip(tr("Delete what is chosen (Del)"))
        self._remove.clicked.connect(lambda: self.removed.emit(self._list.currentRow()))
        line.addWidget(self._rename_button)
        line.addWidget(self._remove)
        line.addStretch(1)
        rows.addLayout(line)

    def show_scene(self, scene: LabellingScene) -> None:
        """Show what there is; a name that is being typed is left alone."""
        self._empty.setVisible(not scene.names)
        self._list.setVisible(bool(scene.names))
        self._list.blockSignals(True)
        if scene.names != tuple(self._text(row) for row in range(self._list.count())):
            self._list.clear()
            for name in scene.names:
                item = QListWidgetItem(name)
                item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
                self._list.addItem(item)
        if self._list.currentRow() != scene.picked:
            self._list.setCurrentRow(scene.picked)
        self._list.blockSignals(False)
        some = 0 <= scene.picked < len(scene.names)
        self._rename_button.setEnabled(some)
        self._remove.setEnabled(some)

    def _text(self, row: int) -> str:
        item = self._list.item(row)
        return item.text() if item is not None else ""

    def _pick(self, row: int) -> None:
        if row >= 0:
            self.picked.emit(row)

    def _rename(self, item: QListWidgetItem) -> None:
        self.renamed.emit(self._list.row(item), item.text())

    def _edit(self) -> None:
        item = self._list.currentItem()
        if item is not None:
            self._list.setFocus()
            self._list.editItem(item)


class RangesList(QWidget):
    """Reviewed ranges; a click goes there, and further ones are marked below.

    Signals:
        frame_sought(int): a range was clicked.
        marked(bool, int, int): of everybody, else of the selected track; start, end (half-open).
        unmarked(int, int, int): track (0: everybody), start, end.
    """

    frame_sought = Signal(int)
    marked = Signal(bool, int, int)
    unmarked = Signal(int, int, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ranges: tuple[RangeLine, ...] = ()
        self._proposed: tuple[int, int] = (-1, -1)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        self._unmark = QPushButton(tr("Unmark"), self)
        self._unmark.setToolTip(tr("Unmark the chosen range"))
        self._unmark.setEnabled(False)
        self._unmark.clicked.connect(self._take_away)
        self._empty = quiet(tr("Nothing is marked as reviewed yet."), self)
        rows.addWidget(self._empty)
        self._list = _short_list(self)
        self._list.setAccessibleName(tr("Reviewed ranges"))
        self._list.itemClicked.connect(
            lambda item: self.frame_sought.emit(self._ranges[self._list.row(item)].start)
        )
        self._list.currentRowChanged.connect(lambda row: self._unmark.setEnabled(row >= 0))
        rows.addWidget(self._list)
        rows.addWidget(self._unmark, 0, Qt.AlignmentFlag.AlignLeft)
        rows.addLayout(self._build_frames())
        rows.addLayout(self._build_buttons())

    def _build_frames(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.addWidget(QLabel(tr("Frames"), self))
        self._first, self._last = WholeBox(self), WholeBox(self)
        for box, name in (
            (self._first, tr("First frame")),
            (self._last, tr("Last frame")),
        ):
            box.setRange(0, _LARGEST_FRAME)
            tell_beside(box)
            box.setMaximumWidth(_FRAME_LETTERS * self.fontMetrics().averageCharWidth())
            box.setAccessibleName(name)
        line.addWidget(self._first)
        line.addWidget(quiet(tr("to"), self))
        line.addWidget(self._last)
        line.addStretch(1)
        return line

    def _build_buttons(self) -> QHBoxLayout:
        line = QHBoxLayout()
        self._one, self._all = QPushButton(self), QPushButton(tr("Mark everybody"), self)
        self._one.clicked.connect(lambda: self._mark(False))
        self._all.clicked.connect(lambda: self._mark(True))
        for button in (self._one, self._all):
            # However long a name is, the panel keeps its width.
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            line.addWidget(button, 1)
        return line

    def show_scene(self, scene: LabellingScene) -> None:
        """Show the ranges; what is typed into the numbers stays until other ones are proposed."""
        if scene.ranges != self._ranges:
            self._ranges = scene.ranges
            self._list.clear()
            self._list.addItems([one.text for one in scene.ranges])
        self._empty.setVisible(not scene.ranges)
        self._list.setVisible(bool(scene.ranges))
        self._unmark.setVisible(bool(scene.ranges))
        if scene.proposed != self._proposed:
            self._proposed = scene.proposed
            self._first.setValue(scene.proposed[0])
            self._last.setValue(scene.proposed[1])
        self._one.setEnabled(bool(scene.selected))
        who = scene.selected or tr("selected")
        self._one.setToolTip(tr("Mark {0}").format(who))
        room = _NAME_LETTERS * self.fontMetrics().averageCharWidth()
        elide = self.fontMetrics().elidedText
        self._one.setText(literal(elide(self._one.toolTip(), Qt.TextElideMode.ElideRight, room)))

    def _mark(self, everybody: bool) -> None:
        self.marked.emit(everybody, self._first.value(), self._last.value() + 1)

    def _take_away(self) -> None:
        row = self._list.currentRow()
        if 0 <= row < len(self._ranges):
            seen = self._ranges[row]
            self.unmarked.emit(seen.track, seen.start, seen.end)


def _short_list(parent: QWidget) -> QListWidget:
    """A list of a few lines, that scrolls."""
    made = QListWidget(parent)
    made.setUniformItemSizes(True)
    made.setMaximumHeight(_ROWS * (made.fontMetrics().height() + 10))
    made.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return made
