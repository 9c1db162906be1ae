"""What a file of another tool holds, and how it is taken."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, joined_text, tr
from app.core.widgets.number_boxes import NumberBox, tell_beside
from app.core.widgets.parts import heading, quiet
from app.features.files.track_import import USUAL_TOLERANCE_PX, ImportChoice, ImportScene

_LETTERS, _BAD_LINES = 78, 7
_LEAST_PX, _MOST_PX = 0.1, 100.0


class ImportDialog(QDialog):
    """Draws an :class:`ImportScene`.

    Signals:
        format_chosen(str): the file is to be read as another format.
        choice_made(): tracks are to be taken otherwise; see `choice`.
    """

    format_chosen = Signal(str)
    choice_made = Signal()

    def __init__(self, name: str, formats: Sequence[tuple[str, str]], parent: QWidget) -> None:
        """`formats`: names and titles of those that can be read. name: of the file."""
        super().__init__(parent)
        self.setWindowTitle(tr("Import tracks"))
        self.setMinimumWidth(_LETTERS * self.fontMetrics().averageCharWidth())
        self._names = tuple(key for key, _ in formats)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(10)
        rows.addLayout(self._source(name, [title for _, title in formats]))
        self._lines = QLabel(self)
        self._lines.setWordWrap(True)
        self._notes = quiet("", self)
        self._notes.setWordWrap(True)
        rows.addWidget(self._lines)
        rows.addWidget(self._notes)
        self._add_choices(rows)
        self._add_bad_rows(rows)
        rows.addStretch(1)
        rows.addWidget(self._ends())

    def _source(self, name: str, titles: list[str]) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(8)
        self._format = QComboBox(self)
        self._format.addItems(titles)
        self._format.setAccessibleName(tr("Read as"))
        self._format.activated.connect(lambda at: self.format_chosen.emit(self._names[at]))
        line.addWidget(heading(name, self), 1)
        line.addWidget(quiet(tr("read as"), self))
        line.addWidget(self._format)
        return line

    def _add_choices(self, rows: QVBoxLayout) -> None:
        self._thins = QCheckBox(
            tr("&Thin tracks with a keyframe in every frame; edges move by at most"), self
        )
        self._tolerance = NumberBox(self)
        tell_beside(self._tolerance)
        self._tolerance.setRange(_LEAST_PX, _MOST_PX)
        self._tolerance.setDecimals(1)
        self._tolerance.setSingleStep(0.5)
        self._tolerance.setValue(USUAL_TOLERANCE_PX)
        self._tolerance.setSuffix(" px")
        self._tolerance.setKeyboardTracking(False)
        self._tolerance.setAccessibleName(tr("Tolerance of thinning"))
        self._tolerance.setEnabled(False)
        self._as_new = QCheckBox(tr("Give all of them &new ids"), self)
        self._as_new.setToolTip(tr("Otherwise they replace the session's tracks with the same ids"))
        self._only_people = QCheckBox(tr("Only &people, no other classes"), self)
        line = QHBoxLayout()
        line.addWidget(self._thins)
        line.addWidget(self._tolerance)
        line.addStretch(1)
        rows.addLayout(line)
        rows.addWidget(self._as_new)
        rows.addWidget(self._only_people)
        self._thins.toggled.connect(self._tolerance.setEnabled)
        self._tolerance.valueChanged.connect(self.choice_made)
        for box in (self._thins, self._as_new, self._only_people):
            box.toggled.connect(self.choice_made)

    def _add_bad_rows(self, rows: QVBoxLayout) -> None:
        self._bad_title = heading("", self)
        self._bad = QTableWidget(0, 2, self)
        self._bad.setHorizontalHeaderLabels([tr("Where"), tr("Why")])
        self._bad.setAccessibleName(tr("Rows that cannot be used"))
        self._bad.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._bad.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._bad.setTabKeyNavigation(False)
        self._bad.setShowGrid(False)
        self._bad.verticalHeader().hide()
        self._bad.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 5)
        header = self._bad.horizontalHeader()
        header.setHighlightSections(False)
        header.setDefaultAlignment(header.defaultAlignment().AlignLeft)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self._bad.setMinimumHeight(_BAD_LINES * self.fontMetrics().lineSpacing())
        self._takes_good = QCheckBox(tr("Leave them out and import the &other rows"), self)
        self._takes_good.toggled.connect(self.choice_made)
        for widget in (self._bad_title, self._bad, self._takes_good):
            rows.addWidget(widget)
            widget.hide()

    def _ends(self) -> QWidget:
        self._why_not = quiet("", self)
        self._why_not.setWordWrap(True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, self)
        self._import = QPushButton(tr("&Import"), self)
        self._import.setProperty("primary", True)
        self._import.setDefault(True)
        buttons.addButton(self._import, QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        whole = QWidget(self)
        line = QHBoxLayout(whole)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self._why_not, 1)
        line.addWidget(buttons)
        return whole

    @property
    def choice(self) -> ImportChoice:
        """How tracks are to be taken."""
        return ImportChoice(
            self._thins.isChecked(),
            self._tolerance.value(),
            self._as_new.isChecked(),
            self._only_people.isChecked(),
            self._takes_good.isChecked(),
        )

    def show_scene(self, scene: ImportScene, format_name: str) -> None:
        """Show what would happen."""
        with QSignalBlocker(self._format):
            self._format.setCurrentIndex(self._names.index(format_name))
        first, *others = scene.lines
        self._lines.setText("\n".join((first, *(f"\u2022 {line}" for line in others))))
        self._notes.setText("\n".join(scene.notes))
        self._notes.setVisible(bool(scene.notes))
        self._only_people.setVisible(scene.classes)
        self._show_bad(scene)
        self._why_not.setText(scene.why_not)
        self._import.setEnabled(not scene.why_not)

    def show_progress(self, done: int, total: int) -> None:
        """Say how far the tracks are thinned, while that lasts."""
        if self._thins.isChecked() and not self._import.isEnabled() and done < total:
            self._why_not.setText(tr("Thinning: {0} %").format(100 * done // total))

    def _show_bad(self, scene: ImportScene) -> None:
        for widget in (self._bad_title, self._bad, self._takes_good):
            widget.setVisible(bool(scene.bad_count))
        title = count_text(scene.bad_count, "{n} row cannot be used", "{n} rows cannot be used")
        more = scene.bad_count - len(scene.bad)
        told = tr("the list shows the first {0}").format(len(scene.bad)) if more else ""
        self._bad_title.setText(joined_text("; ", filter(None, (title, told))))
        if self._bad.rowCount() == len(scene.bad):
            return
        self._bad.setRowCount(len(scene.bad))
        for row, texts in enumerate(scene.bad):
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                self._bad.setItem(row, column, item)
