"""The page of a project: what is in the folder, what comes next, all recordings as a table."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import N_, tr
from app.core.look.theme import scaled_font
from app.core.widgets.parts import quiet
from app.core.widgets.progress_strip import ProgressStrip
from app.core.widgets.tab_order import tab_in_reading_order
from app.features.project.presenter import NEXT_RULE
from app.features.project.recording_table import RecordingTable
from app.features.project.scene import ProjectScene, RecordingRow

_ACTIONS = (
    (
        "file.agreement",
        N_("Agreement..."),
        N_("How far annotators agree, over all recordings with two or more sessions"),
    ),
    (
        "file.train_project",
        N_("Train detector..."),
        N_("Trains one part-failure detector from the labels of all sessions"),
    ),
)
_STEPS = 1000
_FILTER_LETTERS = 28
_BAR_LETTERS = 14


class ProjectPage(QWidget):
    """Draws a `ProjectScene`.

    Signals:
        open_asked(row): a `RecordingRow`. next_asked(), track_asked(), close_asked(): the buttons.
        cancel_asked(): the batch at work is to end. command_asked(str): of the window, by its id.
        folder_asked(): another folder is to be opened.
    """

    open_asked = Signal(object)
    command_asked = Signal(str)
    next_asked = Signal()
    track_asked = Signal()
    cancel_asked = Signal()
    close_asked = Signal()
    folder_asked = Signal()

    def __init__(self, image_of: Callable[[str], bytes], parent: QWidget | None = None) -> None:
        """image_of: the image of a recording by its name, as JPEG."""
        super().__init__(parent)
        self.setAccessibleName(tr("Project"))
        self.scene = ProjectScene()
        self.actions_of: dict[str, QPushButton] = {}
        self.table = RecordingTable(image_of, self)
        self.table.open_asked.connect(self.open_asked)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(16, 12, 16, 8)
        rows.setSpacing(8)
        rows.addLayout(self._build_head())
        rows.addLayout(self._build_next())
        rows.addLayout(self._build_tools())
        self._notes = quiet("", self, "warning")
        self._notes.setWordWrap(True)
        rows.addWidget(self._notes)
        rows.addWidget(self.table, 1)
        rows.addWidget(self._build_empty(), 1)
        self.batch = ProgressStrip(self)
        self.batch.cancelled.connect(self.cancel_asked)
        rows.addWidget(self.batch)
        tab_in_reading_order(self)
        self.show_scene(self.scene)

    def _build_head(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(12)
        words = QVBoxLayout()
        words.setSpacing(0)
        self._title = QLabel(self)
        self._title.setFont(scaled_font(self.font(), 1.5, bold=True))
        self._place = quiet("", self)
        self._place.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        words.addWidget(self._title)
        words.addWidget(self._place)
        row.addLayout(words, 1)
        for name, text, hint in _ACTIONS:
            self.actions_of[name] = button = QPushButton(tr(text), self)
            button.setToolTip(tr(hint))
            button.clicked.connect(lambda _=False, name=name: self.command_asked.emit(name))
            row.addWidget(button, 0, Qt.AlignmentFlag.AlignTop)
        close = QPushButton(tr("Close project"), self)
        close.clicked.connect(self.close_asked)
        row.addWidget(close, 0, Qt.AlignmentFlag.AlignTop)
        return row

    def _build_next(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(12)
        self.next = QPushButton(tr("Next to review"), self)
        self.next.setProperty("primary", True)
        self.next.setToolTip(tr(NEXT_RULE))
        self.next.setAccessibleDescription(tr(NEXT_RULE))
        self.next.clicked.connect(self.next_asked)
        self._next_text = quiet("", self)
        self._next_text.setWordWrap(True)
        self.track = QPushButton(tr("Track recordings..."), self)
        self.track.setToolTip(tr("Tracks many recordings, one after the other, in the background"))
        self.track.clicked.connect(self.track_asked)
        row.addWidget(self.next)
        row.addWidget(self._next_text, 1)
        row.addWidget(self.track)
        return row

    def _build_tools(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(12)
        self.filter = QLineEdit(self)
        self.filter.setPlaceholderText(tr("Filter (Ctrl+F)"))
        self.filter.setAccessibleName(tr("Filter the recordings by words"))
        self.filter.setClearButtonEnabled(True)
        self.filter.setMaximumWidth(_FILTER_LETTERS * self.fontMetrics().averageCharWidth())
        self.filter.textChanged.connect(self._filter)
        self.filter.returnPressed.connect(self.focus_table)
        QShortcut(
            QKeySequence(QKeySequence.StandardKey.Find),
            self,
            self.filter.setFocus,
            context=Qt.ShortcutContext.WidgetWithChildrenShortcut,
        )
        self._summary = quiet("", self)
        self._reading = QProgressBar(self)
        self._reading.setRange(0, _STEPS)
        self._reading.setTextVisible(False)
        self._reading.setAccessibleName(tr("Reading the recordings"))
        self._reading.setToolTip(tr("Reading the recordings"))
        self._reading.setFixedWidth(_BAR_LETTERS * self.fontMetrics().averageCharWidth())
        row.addWidget(self.filter, 1)
        row.addWidget(self._summary)
        row.addStretch(1)
        row.addWidget(self._reading)
        return row

    def _build_empty(self) -> QWidget:
        self._empty = QWidget(self)
        rows = QVBoxLayout(self._empty)
        self._empty_text = quiet("", self._empty)
        self._empty_text.setWordWrap(True)
        self._empty_text.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._other = QPushButton(tr("Open another folder..."), self._empty)
        self._other.clicked.connect(self.folder_asked)
        rows.addStretch(1)
        rows.addWidget(self._empty_text)
        rows.addWidget(self._other, 0, Qt.AlignmentFlag.AlignCenter)
        rows.addStretch(2)
        return self._empty

    def show_scene(self, scene: ProjectScene) -> None:
        """Show a project as it is by now."""
        before, self.scene = self.scene, scene
        if before.place != scene.place:
            self.filter.clear()
        self._title.setText(scene.title)
        self._place.setText(scene.place)
        self._summary.setText(scene.summary)
        self._next_text.setText(scene.next_text)
        self.next.setEnabled(bool(scene.next_row))
        self._notes.setText("\n".join(scene.notes))
        self._notes.setVisible(bool(scene.notes))
        self._reading.setVisible(scene.reading is not None)
        if scene.reading is not None:
            self._reading.setValue(round(scene.reading * _STEPS))
        self.table.show_rows(scene.rows)
        self._show_empty()

    def show_batch(self, text: str, share: float | None, seconds_left: float | None) -> None:
        """Show how far a batch is; text: "" where none is at work."""
        self.track.setEnabled(not text)
        if text:
            self.batch.show_scene(text, share, seconds_left)
        else:
            self.batch.finish()

    def enable(self, name: str, why_not: str) -> None:
        """Offer a command; why_not: why it cannot be done now, "" where it can."""
        hints = {command: hint for command, _, hint in _ACTIONS}
        button = self.actions_of[name]
        button.setEnabled(not why_not)
        button.setToolTip(why_not or tr(hints[name]))

    def enable_all(self, why_not: Mapping[str, str]) -> None:
        """Offer the commands that the page has; why_not: as for `enable`, by the command."""
        for name in self.actions_of.keys() & why_not.keys():
            self.enable(name, why_not[name])

    def focus_table(self) -> None:
        """Give the keyboard to the table, on the row it was on or on the first one."""
        self.table.setFocus()
        if not self.table.currentIndex().isValid() and self.table.shown.rowCount():
            self.table.selectRow(0)

    def row_named(self, name: str) -> RecordingRow | None:
        """A recording that is listed."""
        return next((row for row in self.scene.rows if row.name == name), None)

    def _filter(self, text: str) -> None:
        self.table.shown.set_text(text)
        self._show_empty()

    def _show_empty(self) -> None:
        """Say in words why nothing is listed."""
        empty = self.scene.empty
        none_fits = bool(self.scene.rows) and not self.table.shown.rowCount()
        if none_fits:
            empty = tr("No recording holds these words: change or clear the filter")
        self._empty_text.setText(empty)
        self._empty.setVisible(bool(empty))
        self.table.setVisible(not empty)
        self._other.setVisible(bool(empty) and not none_fits and bool(self.scene.summary))
