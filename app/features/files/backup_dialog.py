"""A list of backups of the session, and what would be different."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QPlainTextEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.parts import heading, quiet
from app.features.files.backups import BackupLine

_LEAST_WIDTH = 560


class BackupDialog(QDialog):
    """Shows backups; one of them may be restored.

    Signals:
        looked_at(int): one was chosen; `show_differences` is to be called.
        restore_asked(int): that one is to be restored.
    """

    looked_at = Signal(int)
    restore_asked = Signal(int)

    def __init__(self, lines: tuple[BackupLine, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._lines = lines
        self.setObjectName("backups")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Restore a backup"))
        self.setMinimumWidth(_LEAST_WIDTH)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        text = quiet(
            tr(
                "Each save keeps the state before it as a backup. Restoring also keeps the "
                "current state, as the newest backup: nothing is lost."
            ),
            self,
        )
        text.setWordWrap(True)
        rows.addWidget(text)
        self._table = self._build_table()
        rows.addWidget(self._table)
        rows.addWidget(heading(tr("What would change"), self))
        self._differences = QPlainTextEdit(self)
        self._differences.setReadOnly(True)
        self._differences.setAccessibleName(tr("What would change"))
        self._differences.setMinimumHeight(9 * self.fontMetrics().lineSpacing())
        rows.addWidget(self._differences, 1)
        rows.addWidget(self._build_buttons())
        if lines:
            self._table.selectRow(0)

    def _build_table(self) -> QTableWidget:
        table = QTableWidget(len(self._lines), 4, self)
        names = (tr("Saved"), tr("Edits"), tr("Tracks"), tr("Size"))
        table.setHorizontalHeaderLabels(names)
        table.setAccessibleName(tr("Backups, the newest first"))
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        table.verticalHeader().hide()
        table.setShowGrid(False)
        table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        table.horizontalHeader().setHighlightSections(False)
        table.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft)
        for row, line in enumerate(self._lines):
            for column, text in enumerate((line.when, line.edits, line.tracks, line.size)):
                item = QTableWidgetItem(text)
                item.setToolTip(line.problem)
                table.setItem(row, column, item)
        height = table.horizontalHeader().sizeHint().height() + 6
        height += max(1, len(self._lines)) * table.verticalHeader().defaultSectionSize()
        table.setFixedHeight(height)
        table.itemSelectionChanged.connect(self._look)
        return table

    def _build_buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, self)
        self._restore = QPushButton(tr("Restore"), self)
        self._restore.setProperty("primary", True)
        self._restore.setEnabled(False)
        buttons.addButton(self._restore, QDialogButtonBox.ButtonRole.ActionRole)
        self._restore.clicked.connect(self._ask)
        buttons.rejected.connect(self.reject)
        return buttons

    @property
    def chosen(self) -> int:
        """The number of the state that is chosen; 0 for none."""
        row = self._table.currentRow()
        return self._lines[row].number if 0 <= row < len(self._lines) else 0

    def begin(self) -> None:
        """Show the dialog and look at the newest state."""
        self.open()
        self._look()

    def show_differences(self, number: int, lines: tuple[str, ...]) -> None:
        """What differs from now, unless another state was chosen meanwhile."""
        if number == self.chosen:
            self._differences.setPlainText("\n".join(lines))
            self._restore.setEnabled(True)

    def _look(self) -> None:
        self._restore.setEnabled(False)
        number = self.chosen
        if not number:
            self._differences.setPlainText(tr("No backup is kept yet."))
            return
        problem = self._lines[self._table.currentRow()].problem
        self._differences.setPlainText(problem or tr("Looking..."))
        if not problem:
            self.looked_at.emit(number)

    def _ask(self) -> None:
        number = self.chosen
        self.accept()
        self.restore_asked.emit(number)
