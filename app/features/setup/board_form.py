"""A calibration from pictures of a board: what is entered, and the error of each picture."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from app.features.setup.board_fields import BoardFields
from app.features.setup.calibration_presenter import other_source, source_of_board, with_board
from app.features.setup.scene import SetupScene
from app.features.setup.step_page import choose, named
from tracking.calibration.boards import BoardCalibration

if TYPE_CHECKING:
    from app.features.setup.calibration_page import CalibrationPage

_ROWS_SEEN = 7


class BoardPanel(QWidget):
    """Sources, kind and size of the board; then each picture with its error, to be left out."""

    def __init__(self, page: CalibrationPage, remembered: UserSettings) -> None:
        super().__init__(page)
        self._page, self._remembered = page, remembered
        self._shown: BoardCalibration | None = None
        self._errors: dict[str, float] = {}
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        form = page.form()
        self.left, left = self._source(tr("Pictures of the left camera"), "left")
        self.right, self._right_row = self._source(tr("Pictures of the right camera"), "right")
        form.addRow(tr("Left"), left)
        form.addRow(tr("Right"), self._right_row)
        self.fields = BoardFields(page, form, self._change)
        lenses = (("standard", tr("Standard")), ("fisheye", tr("Fisheye")))
        self.lens = page.choice(lenses, self._change)
        form.addRow(tr("Lens"), named(self.lens, tr("Kind of lens")))
        self._form = form
        rows.addLayout(form)
        self.calibrate = page.button(tr("Calibrate"), page.calibrate_board)
        rows.addWidget(self.calibrate)
        self.table = self._table()
        rows.addWidget(self.table)

    def _source(self, name: str, side: str) -> tuple[QLineEdit, QWidget]:
        """A field for a video, a folder or a pattern of pictures, with buttons to choose."""
        row = QWidget(self)
        across = QHBoxLayout(row)
        across.setContentsMargins(0, 0, 0, 0)
        field = QLineEdit(row)
        field.setAccessibleName(name)
        field.setPlaceholderText(tr("video, folder or left*.png"))
        field.editingFinished.connect(lambda: self._type(side, field.text()))
        choose_one = QPushButton("...", row)
        choose_one.setAutoDefault(False)
        choose_one.setAccessibleName(tr("Choose: {what}", what=name))
        choose_one.setToolTip(tr("A video, or one picture of a series"))
        choose_one.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        choose_one.clicked.connect(lambda: self._ask(side, name))
        across.addWidget(field, 1)
        across.addWidget(choose_one)
        return field, row

    def _table(self) -> QTableWidget:
        table = QTableWidget(0, 2, self)
        table.setHorizontalHeaderLabels([tr("Picture"), tr("Error, px")])
        table.verticalHeader().hide()
        fit = QHeaderView.ResizeMode
        table.horizontalHeader().setSectionResizeMode(0, fit.Stretch)
        table.horizontalHeader().setSectionResizeMode(1, fit.ResizeToContents)
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setAccessibleName(tr("Pictures of the board; unchecked ones are left out"))
        table.itemChanged.connect(self._toggle)
        height = table.fontMetrics().height() + 10
        table.verticalHeader().setDefaultSectionSize(height)
        table.setFixedHeight((_ROWS_SEEN + 1) * height)
        table.hide()
        return table

    def fill(self, scene: SetupScene) -> None:
        """What was entered, and the errors."""
        plan, board = scene.state.plan, scene.state.board
        stereo = plan is not None and plan.is_stereo
        for field, text in ((self.left, board.left), (self.right, board.right)):
            if field.text() != text:
                field.setText(text)
                field.setToolTip(text)
        self._form.setRowVisible(self._right_row, stereo)
        self.fields.fill(board)
        choose(self.lens, board.lens)
        self.calibrate.setEnabled(plan is not None and not scene.busy)
        self.table.setEnabled(not scene.busy)
        if scene.boards is not self._shown:
            self._show(scene.boards)

    def _show(self, boards: BoardCalibration | None) -> None:
        self._shown = boards
        self.table.setVisible(boards is not None)
        if boards is None:
            return
        self._errors |= boards.per_picture
        names = sorted({*boards.used, *boards.rejected})
        self.table.blockSignals(True)
        self.table.setRowCount(len(names))
        for row, name in enumerate(names):
            used = name in boards.used
            item = QTableWidgetItem(name)
            item.setFlags(Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsEnabled)
            item.setCheckState(Qt.CheckState.Checked if used else Qt.CheckState.Unchecked)
            error = self._errors.get(name)
            text = "" if error is None else f"{error:.2f}"
            out = tr("{error} left out", error=text) if text else tr("left out")
            said = text if used else out
            self.table.setItem(row, 0, item)
            self.table.setItem(row, 1, QTableWidgetItem(said))
        self.table.blockSignals(False)

    # gestures

    def _toggle(self, item: QTableWidgetItem) -> None:
        if item.column() != 0:
            return
        unchecked = frozenset(
            one.text()
            for row in range(self.table.rowCount())
            if (one := self.table.item(row, 0)) is not None
            and one.checkState() is Qt.CheckState.Unchecked
        )
        self._page.fit_again(unchecked)

    def _change(self, *_: Any) -> None:
        editor = self._page.editor
        form = replace(self.fields.read(editor.state.board), lens=self.lens.currentData())
        editor.change(with_board(editor.state, form))

    def _type(self, side: str, text: str) -> None:
        editor = self._page.editor
        board, text = editor.state.board, text.strip()
        if text == getattr(board, side):
            return
        changed = replace(board, left=text) if side == "left" else replace(board, right=text)
        if side == "left" and text and not board.right:
            changed = replace(changed, right=other_source(text))
        editor.change(with_board(editor.state, changed))

    def _ask(self, side: str, name: str) -> None:
        def take(path: Path) -> None:
            self._type(side, source_of_board(path))

        choose_file(self, name, "", take, self._remembered.last_folder("calibration"))
