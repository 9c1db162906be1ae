"""What a board looks like: the fields of its kind, its size and its squares."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtWidgets import QFormLayout, QHBoxLayout

from app.core.i18n import tr
from app.features.setup.scene import BoardForm
from app.features.setup.step_page import StepPage, choose, named, plain


class BoardFields:
    """The fields, put into a page's form; `changed` is called when one of them is."""

    def __init__(self, page: StepPage, form: QFormLayout, changed: Callable[..., None]) -> None:
        kinds = (
            ("chessboard", tr("Chessboard")),
            ("charuco", tr("ChArUco board")),
            ("circles", tr("Circles")),
            ("asymmetric-circles", tr("Circles, asymmetric")),
        )
        self.kind = page.choice(kinds, changed)
        form.addRow(tr("Kind"), named(self.kind, tr("Kind of board")))
        self.columns, self.rows = (page.whole(3, 60, changed) for _ in range(2))
        size = QHBoxLayout()
        size.addWidget(named(self.columns, tr("Columns of the board")))
        size.addWidget(plain("\N{MULTIPLICATION SIGN}", page))
        size.addWidget(named(self.rows, tr("Rows of the board")))
        size.setStretch(0, 4)
        size.setStretch(1, 1)
        size.setStretch(2, 4)
        form.addRow(tr("Size"), size)
        self.told = plain("", page)
        form.addRow(self.told)
        self.square = page.number(" mm", 0.0, 5000.0, 3, changed)
        self.square.setSpecialValueText(tr("not measured"))
        form.addRow(tr("Square, mm"), named(self.square, tr("Side of a square")))

    def fill(self, board: BoardForm) -> None:
        """What was entered."""
        choose(self.kind, board.kind)
        self.columns.setValue(board.columns)
        self.rows.setValue(board.rows)
        self.square.setValue(board.square_mm)
        self.told.setText(_size_told(board))

    def read(self, board: BoardForm) -> BoardForm:
        """The same with what the fields say."""
        return replace(
            board,
            kind=self.kind.currentData(),
            columns=self.columns.value(),
            rows=self.rows.value(),
            square_mm=self.square.value(),
        )


def _size_told(board: BoardForm) -> str:
    return {
        "chessboard": tr("inner corners, not squares"),
        "charuco": tr("squares"),
    }.get(board.kind, tr("circles"))
