"""The session's runs: what made them, how they score, and any two compared."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QItemSelectionModel, Qt, Signal, SignalInstance
from PySide6.QtGui import QCloseEvent, QGuiApplication, QKeyEvent, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.core.scenes.score_figures import Figure
from app.core.widgets.parts import quiet
from app.core.widgets.tab_order import tab_in_reading_order
from app.core.widgets.work_line import WorkLine
from app.features.runs.presenter import CORRECTED, RUN_FIGURES, RunList, RunRow, RunsScene
from tracking.scoring import Score

_WIDEST = 2
"""The column of what was changed of settings."""
_SETTINGS_LETTERS = 14
"""That this column has at least; all of it is in its tooltip."""
_FIGURES = len(RUN_FIGURES)
"""Columns that only a truth fills, the last ones."""
_MOST_ROWS = 10  # that are seen without scrolling
_NUMBERS = _FIGURES + 1
"""Columns that hold numbers, the last ones."""
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class RunsDialog(QDialog):
    """Lists the runs; figures come in the background where there is a truth.

    Signals:
        compare_asked(int, int): a run with another one, or with `CORRECTED`.
        beside_asked(int, int): the same, with the pictures divided between the two.
        correct_asked(int): have this run's tracks be the ones to correct.
        again_asked(int): track again with the settings of this run.
        drop_asked(int): forget the last run.
    """

    compare_asked = Signal(int, int)
    beside_asked = Signal(int, int)
    correct_asked = Signal(int)
    again_asked = Signal(int)
    drop_asked = Signal(int)

    def __init__(self, runs: RunList, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Runs"))
        self._runs = runs
        self._scene = runs.scene()
        self._job: Job | None = None
        self._table = self._build_table()
        self._about = quiet("", self)
        self._about.setWordWrap(True)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        rows.addWidget(self._table, 1)
        rows.addLayout(self._build_frames())
        rows.addWidget(self._about)
        self._working = WorkLine(tr("Cancel scoring the runs"), self)
        self._working.cancelled.connect(self._cancel_scoring)
        rows.addWidget(self._working)
        rows.addLayout(self._build_buttons())
        tab_in_reading_order(self)
        self._show(self._scene)
        line = self.fontMetrics().height()
        self.resize(min(84 * line, self.screen().availableGeometry().width() - 2 * line), 22 * line)
        self._table.setFocus()  # arrow keys choose, Enter compares
        if self._scene.scored:
            self._score()

    def _build_table(self) -> QTableWidget:
        titles = [
            tr("Tracks"),
            tr("Tracker"),
            tr("Settings"),
            tr("Frames"),
            tr("Made"),
            tr("People"),
            *map(_title, RUN_FIGURES),
        ]
        told = {_title(figure): tr(figure.hint) for figure in RUN_FIGURES}
        told[tr("Settings")] = tr("Those that differ from the tracker's defaults")
        told[tr("People")] = tr("In the frames that are scored")
        table = QTableWidget(0, len(titles), self)
        for column, title in enumerate(titles):
            heading = QTableWidgetItem(title)
            heading.setTextAlignment(_RIGHT if column >= len(titles) - _NUMBERS else _LEFT)
            heading.setToolTip(told.get(title, ""))
            table.setHorizontalHeaderItem(column, heading)
        table.setAccessibleName(tr("Runs of this session"))
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setShowGrid(False)
        table.setProperty("dense", True)  # many figures, on a screen of 1280 px, too
        table.setTabKeyNavigation(False)
        table.verticalHeader().hide()
        table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        table.horizontalHeader().setSectionResizeMode(_WIDEST, QHeaderView.ResizeMode.Stretch)
        table.horizontalHeader().setHighlightSections(False)
        table.itemSelectionChanged.connect(self._enable)
        return table

    def _build_frames(self) -> QVBoxLayout:
        """Over which frames the rows are scored."""
        self._share = QCheckBox(self)
        self._share.setChecked(self._runs.shared)
        self._share.toggled.connect(self._share_frames)
        self._over = quiet("", self)
        self._over.setWordWrap(True)
        column = QVBoxLayout()
        column.setSpacing(4)
        column.addWidget(self._share)
        column.addWidget(self._over)
        return column

    def _build_buttons(self) -> QHBoxLayout:
        self._compare = QPushButton(tr("Compare"), self)
        self._compare.setProperty("primary", True)
        self._compare.setDefault(True)
        self._compare.clicked.connect(lambda: self._ask_compare(self.compare_asked))
        self._beside = QPushButton(tr("Side by side"), self)
        self._beside.setAutoDefault(False)
        self._beside.setAccessibleName(tr("Compare side by side in the pictures"))
        self._beside.clicked.connect(lambda: self._ask_compare(self.beside_asked))
        self._correct = QPushButton(tr("Correct this run"), self)
        self._correct.setAutoDefault(False)
        self._correct.clicked.connect(self._ask_correct)
        self._drop = QPushButton(tr("Delete the last run"), self)
        self._drop.setAutoDefault(False)
        self._drop.clicked.connect(self._ask_drop)
        self._again = QPushButton(tr("Track again..."), self)
        self._again.setAutoDefault(False)
        self._again.setAccessibleName(tr("Track again with these settings"))
        self._again.clicked.connect(self._ask_again)
        close = QPushButton(tr("Close"), self)
        close.setAutoDefault(False)
        close.clicked.connect(self.reject)
        line = QHBoxLayout()
        line.addWidget(self._drop)
        line.addWidget(self._again)
        line.addStretch(1)
        line.addWidget(close)
        line.addWidget(self._correct)
        line.addWidget(self._beside)
        line.addWidget(self._compare)
        return line

    @property
    def chosen(self) -> list[int]:
        """The numbers of the rows that are selected, from above."""
        rows = sorted({index.row() for index in self._table.selectedIndexes()})
        return [self._scene.rows[row].number for row in rows]

    def choose(self, *numbers: int) -> None:
        """Select some rows by number."""
        self._table.clearSelection()
        no_change = QItemSelectionModel.SelectionFlag.NoUpdate
        for row, shown in enumerate(self._scene.rows):
            if shown.number in numbers:
                model = self._table.model()
                whole = QItemSelectionModel.SelectionFlag.Select
                whole |= QItemSelectionModel.SelectionFlag.Rows
                selection = self._table.selectionModel()
                selection.setCurrentIndex(model.index(row, 0), no_change)
                selection.select(model.index(row, 0), whole)

    def _show(self, scene: RunsScene) -> None:
        chosen = self.chosen if self._table.rowCount() else []
        self._scene = scene
        self._table.setRowCount(len(scene.rows))
        for row, shown in enumerate(scene.rows):
            for column, text in enumerate(_texts(shown)):
                item = QTableWidgetItem(text)
                item.setToolTip(text if column else "\n".join(filter(None, (text, shown.notes))))
                if column >= self._table.columnCount() - _NUMBERS:
                    item.setTextAlignment(_RIGHT)
                self._table.setItem(row, column, item)
        self._table.setMinimumHeight(self._height_of(min(len(scene.rows), _MOST_ROWS)))
        for column in range(self._table.columnCount() - _FIGURES, self._table.columnCount()):
            self._table.setColumnHidden(column, not scene.scored)
        self._drop.setVisible(any(row.number != CORRECTED for row in scene.rows))
        self._drop.setEnabled(not scene.why_not_dropped)
        self._drop.setToolTip(scene.why_not_dropped)
        for widget, text in ((self._share, scene.share_text), (self._over, scene.over)):
            widget.setText(text)
            widget.setVisible(bool(text))
        self.choose(*(chosen or ([scene.proposed] if scene.proposed != CORRECTED else [])))
        self._enable()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """The column of settings takes the room that is left, and ends in an ellipsis there."""
        super().resizeEvent(event)
        head = self._table.horizontalHeader()
        others = sum(head.sectionSize(at) for at in range(head.count()) if at != _WIDEST)
        left = self._table.viewport().width() - others
        least = _SETTINGS_LETTERS * self.fontMetrics().averageCharWidth()
        mode = QHeaderView.ResizeMode
        head.setSectionResizeMode(_WIDEST, mode.Stretch if left >= least else mode.Fixed)
        if left < least:
            head.resizeSection(_WIDEST, least)

    def _height_of(self, rows: int) -> int:
        """So many rows, and the headings above, without a scroll bar."""
        head, frame = self._table.horizontalHeader(), 2 * self._table.frameWidth()
        return (
            head.sizeHint().height()
            + rows * self._table.verticalHeader().defaultSectionSize()
            + self._table.horizontalScrollBar().sizeHint().height()  # on a narrow screen
            + frame
        )

    def _enable(self) -> None:
        """What can be compared: one run with the corrected tracks, or two of the rows."""
        chosen = self.chosen
        runs = [number for number in chosen if number != CORRECTED]
        why_not = {row.number: row.why_not_compared for row in self._scene.rows}
        said = why_not[runs[0]] if len(runs) == 1 and len(chosen) <= 2 else ""
        self._compare.setEnabled(len(chosen) in (1, 2) and bool(runs) and not said)
        self._compare.setToolTip(said)
        self._beside.setEnabled(self._compare.isEnabled())
        self._beside.setToolTip(said)
        if len(runs) == 2:
            text = tr("Compares the two runs; you can take differences from either.")
        elif runs and len(chosen) <= 2:
            text = said or tr("Compares the run with the corrected tracks.")
        else:
            text = tr("Select a run, or two of them with Ctrl, to compare.")
        self._about.setText(text)
        self._enable_correcting(chosen)
        self._enable_again(chosen)

    def _enable_again(self, chosen: list[int]) -> None:
        why_not = {row.number: row.why_not_again for row in self._scene.rows}
        one = len(chosen) == 1
        said = why_not[chosen[0]] if one else tr("Select one run to track with its settings.")
        self._again.setEnabled(not said)
        self._again.setToolTip(
            said or tr("Opens the same tracker, settings and seed to be changed")
        )

    def _enable_correcting(self, chosen: list[int]) -> None:
        why_not = {row.number: row.why_not_corrected for row in self._scene.rows}
        said = why_not[chosen[0]] if len(chosen) == 1 else tr("Select one run to correct it.")
        self._correct.setEnabled(not said)
        self._correct.setToolTip(
            said
            or tr(
                "You then correct the tracks of this run. If you have edited already, or it has "
                "fewer frames, you first see what would change, and take that as one edit."
            )
        )

    def _ask_again(self) -> None:
        number = self.chosen[0]
        self.accept()
        self.again_asked.emit(number)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Copy as in every table."""
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        else:
            super().keyPressEvent(event)

    def copy(self) -> None:
        """Put the chosen rows, or all, on the clipboard: headings and cells, parted by tabs."""
        numbers = self.chosen or [row.number for row in self._scene.rows]
        head, table = self._table.horizontalHeader(), self._table
        shown = [at for at in range(head.count()) if not table.isColumnHidden(at)]
        model = table.model()
        rows = [[str(model.headerData(at, Qt.Orientation.Horizontal)) for at in shown]]
        for at, row in enumerate(self._scene.rows):
            if row.number in numbers:
                rows.append([str(model.index(at, column).data()) for column in shown])
        QGuiApplication.clipboard().setText("\n".join(map("\t".join, rows)))

    def _ask_correct(self) -> None:
        number = self.chosen[0]
        self.accept()
        self.correct_asked.emit(number)

    def _share_frames(self, shared: bool) -> None:
        """Score anew, over other frames."""
        self._runs.shared = shared
        self._runs.take({})
        self._show(self._runs.scene())
        self._score()

    def _ask_compare(self, asked: SignalInstance) -> None:
        chosen = self.chosen
        runs = [number for number in chosen if number != CORRECTED]
        if runs:
            self.accept()
            asked.emit(runs[-1], runs[0] if len(runs) == 2 else CORRECTED)

    def _ask_drop(self) -> None:
        self.drop_asked.emit(self._scene.rows[-1].number)
        self._show(self._runs.scene())

    # figures

    def _score(self) -> None:
        work = self._runs.scoring()
        job = Job(tr("Scoring the runs"), work, self)
        job.done.connect(self._take)
        job.failed.connect(lambda error: self._end(explain(error)))
        job.cancelled.connect(lambda: self._end(tr("Not scored: you cancelled it")))
        doing = tr("Scoring...")
        job.progressed.connect(lambda n, total: self._working.show_work(doing, n / max(total, 1)))
        self._job = job
        self._about.setText(doing)
        self._working.show_work(doing)
        self._share.setEnabled(False)
        job.start()

    def _cancel_scoring(self) -> None:
        if self._job is not None:
            self._job.cancel()

    def _take(self, figures: Mapping[int, Score]) -> None:
        self._runs.take(figures)
        self._end()
        self._show(self._runs.scene())

    def _end(self, said: str = "") -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        self._working.show_work("")
        self._share.setEnabled(True)
        self._enable()
        if said:
            self._about.setText(said)

    def done(self, result: int) -> None:
        """Score no further."""
        self._stop()
        super().done(result)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        """Score no further."""
        self._stop()
        super().closeEvent(event)

    def _stop(self) -> None:
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()


def _title(figure: Figure) -> str:
    """Its name, short enough for a column."""
    short = {
        "People kept": tr("Kept"),
        "Position error (median)": tr("Position"),
    }
    return short.get(figure.name) or tr(figure.name)


def _texts(row: RunRow) -> tuple[str, ...]:
    return (
        row.name,
        row.tracker,
        row.settings,
        row.frames,
        row.made,
        row.people,
        *(row.figures or ("",) * _FIGURES),
    )
