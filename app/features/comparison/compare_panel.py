"""Where another person's session disagrees: figures, and a list to walk through."""

from __future__ import annotations

from PySide6.QtCore import QAbstractListModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QListView,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, joined_text, tr
from app.core.look.theme import scaled_font
from app.core.widgets.parts import NOTICE_MARGINS, quiet
from app.features.comparison.scene import AgreementScene, DisagreementRow

_LEAST_ROWS = 4
_WHOLE = 100
"""Of the room that is left, the list has all until it shows every row."""
_NO_PARENT = QModelIndex()


class _Rows(QAbstractListModel):
    """The stretches: what, and below it when."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.rows: tuple[DisagreementRow, ...] = ()

    def show_rows(self, rows: tuple[DisagreementRow, ...]) -> None:
        if rows is not self.rows:
            self.beginResetModel()
            self.rows = rows
            self.endResetModel()

    def rowCount(  # noqa: N802 - Qt's name
        self, parent: QModelIndex | QPersistentModelIndex = _NO_PARENT
    ) -> int:
        return 0 if parent.isValid() else len(self.rows)

    def data(
        self,
        index: QModelIndex | QPersistentModelIndex,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> object:
        if not index.isValid() or index.row() >= len(self.rows):
            return None
        row = self.rows[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return f"{row.text}\n{row.when}"
        return row.text if role == Qt.ItemDataRole.ToolTipRole else None


class ComparePanel(QFrame):
    """Draws an :class:`AgreementScene`; hidden without one.

    Signals:
        stretch_sought(int, int): a row was clicked: frame, and track of the open session (or 0).
        theirs_asked(int): the disagreement of a row is to be as the other session has it.
        again_asked(): compare again. left(): close the comparison.
    """

    stretch_sought = Signal(int, int)
    theirs_asked = Signal(int)
    again_asked = Signal()
    left = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("notice", True)
        self.setAccessibleName(tr("Comparison"))
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(*NOTICE_MARGINS)
        rows.setSpacing(6)
        self._title = QLabel(self)
        self._title.setFont(scaled_font(self.font(), 1.1, bold=True))
        self._title.setWordWrap(True)
        self._figures = QLabel(self)
        self._figures.setWordWrap(True)
        self._figures.setToolTip(
            tr(
                "IDF1: share of rows that agree on the identity. Cohen's kappa: agreement beyond "
                "chance; 1 is full agreement, 0 is chance."
            )
        )
        self._hint = quiet("", self)
        self._hint.setWordWrap(True)
        for label in (self._title, self._figures, self._hint):
            rows.addWidget(label)
        self._outdated = False
        self._model = _Rows(self)
        self._list = self._build_list()
        rows.addWidget(self._list, _WHOLE)
        rows.addLayout(self._build_ends())
        rows.addStretch(1)
        self.hide()

    def _build_list(self) -> QListView:
        view = QListView(self)
        view.setModel(self._model)
        view.setAccessibleName(tr("Where the sessions disagree"))
        view.setUniformItemSizes(True)
        view.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        view.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        view.selectionModel().currentChanged.connect(self._seek)
        view.clicked.connect(self._seek)
        return view

    def _build_ends(self) -> QHBoxLayout:
        line = QHBoxLayout()
        self._again = QPushButton(tr("Compare again"), self)
        self._again.clicked.connect(self.again_asked)
        done = QPushButton(tr("Close"), self)
        done.clicked.connect(self.left)
        self._theirs = QPushButton(tr("Take theirs"), self)
        self._theirs.setToolTip(
            tr("Put what the other session has in this range in place of yours; undo restores it")
        )
        self._theirs.clicked.connect(self._ask_theirs)
        line.addStretch(1)
        line.addWidget(self._theirs)
        line.addWidget(self._again)
        line.addWidget(done)
        return line

    def show_scene(self, scene: AgreementScene | None) -> None:
        """Show a comparison, or none."""
        self.setVisible(scene is not None)
        self._model.show_rows(() if scene is None else scene.rows)
        if scene is None:
            return
        self._outdated = scene.outdated
        self._title.setText(scene.title)
        self._figures.setText(scene.figures)
        stretches = tr("You agree everywhere.")
        if scene.rows:
            stretches = count_text(
                len(scene.rows), "You disagree in {n} range.", "You disagree in {n} ranges."
            )
        changed = tr("Your session has changed since.") if scene.outdated else ""
        dashed = tr("Their people are dashed.")
        self._hint.setText(joined_text(" ", filter(None, (stretches, dashed, changed))))
        self._list.setVisible(bool(scene.rows))
        self._fit_list(len(scene.rows))
        self._again.setVisible(scene.outdated)
        self._offer_theirs()

    def _fit_list(self, rows: int) -> None:
        """A few rows, as below it may stand the review queue; all of them where there is room."""
        frame = 2 * self._list.frameWidth()
        height = max(1, self._list.sizeHintForRow(0))
        self._list.setMinimumHeight(min(max(rows, 1), _LEAST_ROWS) * height + frame)
        self._list.setMaximumHeight(max(rows, 1) * height + frame)

    def _offer_theirs(self) -> None:
        """Of the row that was chosen, unless it was compared with what stands no more."""
        self._theirs.setVisible(bool(self._model.rows))
        self._theirs.setEnabled(self._list.currentIndex().isValid() and not self._outdated)

    def _ask_theirs(self) -> None:
        self.theirs_asked.emit(self._list.currentIndex().row())

    def _seek(self, index: QModelIndex) -> None:
        self._offer_theirs()
        if index.isValid():
            row = self._model.rows[index.row()]
            self.stretch_sought.emit(row.frame, row.track)
