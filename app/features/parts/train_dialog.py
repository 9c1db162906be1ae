"""The question before training: which labels, with which settings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain
from app.core.i18n import N_, tr
from app.core.jobs.jobs import Job, Progress
from app.core.keymap import in_brackets
from app.core.look.theme import line_height
from app.core.widgets.parts import heading, quiet
from app.core.widgets.questions import choose_file
from app.core.widgets.settings_form import SettingsForm
from app.core.widgets.tab_order import tab_in_reading_order
from app.core.widgets.user_settings import LastFolder
from app.features.parts.training_set import Source, TrainingSet, build_training_set, source_at
from app.features.parts.training_settings import (
    PartCount,
    SettingsOfTraining,
    TrainingSettings,
    counts_of,
)
from tracking.trackers import body_part_tracker

_TAUGHT = N_("Sessions and samples (*.h5 *.csv)")
_ROWS = 4


class TrainDialog(QDialog):
    """Chooses sessions whose labels are learnt from, and says whether they are enough.

    Reading a session goes on in the background; the dialog waits for it when it is closed.
    """

    def __init__(
        self,
        here: Callable[[], Source] | None,
        before: Sequence[Path],
        last: LastFolder,
        parent: QWidget | None = None,
    ) -> None:
        """A dialog with what is learnt from so far.

        Args:
            here: gives the labels of the open session; None where none is open.
            before: sessions and samples that were learnt from the last time.
            last: where one of them was chosen last.
        """
        super().__init__(parent)
        self._last = last
        self.setWindowTitle(tr("Train the part-failure detector"))
        self._sources: list[Source] = []
        self._job: Job | None = None
        self._waiting = [partial(source_at, path) for path in before]
        self._list = QListWidget(self)
        self._list.setAccessibleName(tr("Sessions with labels to learn from"))
        self._list.setMaximumHeight(_ROWS * (self.fontMetrics().height() + 12))
        self._list.itemChanged.connect(lambda _: self._show_counts())
        self._list.currentRowChanged.connect(lambda row: self._off_list.setEnabled(row >= 0))
        self._told = quiet("", self)
        self._told.setWordWrap(True)
        self._cells: list[tuple[QLabel, ...]] = []
        self._form = SettingsForm(SettingsOfTraining(), self)
        self._buttons = QDialogButtonBox(self)
        self._lay_out()
        if here is not None:
            self._read(here)
        else:
            self._end(tr("No session is open: add sessions or samples with labels"))

    # what it looks like

    def _lay_out(self) -> None:
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(10)
        about = quiet(
            tr(
                "The detector learns from rectangles that are labelled on or off their part, and "
                "from corrected rectangles. More people are better."
            ),
            self,
        )
        about.setWordWrap(True)
        rows.addWidget(about)
        rows.addWidget(heading(tr("Labels"), self))
        rows.addWidget(self._list)
        rows.addLayout(self._list_buttons())
        rows.addWidget(self._told)
        rows.addLayout(self._counts_grid())
        rows.addSpacing(8)
        rows.addWidget(heading(tr("Settings"), self))
        area = QScrollArea(self)
        area.setWidget(self._form)
        area.setWidgetResizable(True)
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # it follows the setting that is chosen
        rows.addWidget(area, 1)
        self._train = QPushButton(tr("Train"), self._buttons)
        self._train.setProperty("primary", True)
        self._buttons.addButton(self._train, QDialogButtonBox.ButtonRole.AcceptRole)
        self._train.setDefault(True)
        self._buttons.addButton(QDialogButtonBox.StandardButton.Cancel)
        self._buttons.accepted.connect(self.accept)
        self._buttons.rejected.connect(self.reject)
        rows.addWidget(self._buttons)
        tab_in_reading_order(self)
        line, room = line_height(self.font()), self.screen().availableSize()
        self.resize(min(44 * line, room.width()), min(50 * line, room.height() - 4 * line))

    def _list_buttons(self) -> QHBoxLayout:
        line = QHBoxLayout()
        add = QPushButton(tr("Add sessions or samples..."), self)
        add.setAutoDefault(False)
        add.clicked.connect(self._ask)
        self._off_list = QPushButton(tr("Remove from the list"), self)
        self._off_list.setToolTip(tr("Remove the chosen line; its file stays as it is"))
        self._off_list.setAutoDefault(False)
        self._off_list.clicked.connect(self._remove)
        line.addWidget(add)
        line.addWidget(self._off_list)
        line.addStretch(1)
        return line

    def _ask(self) -> None:
        title = tr("Add a session or samples")
        choose_file(self, title, tr(_TAUGHT), self.add, self._last)

    def _counts_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(24)
        grid.setColumnStretch(4, 1)
        titles = ("", tr("on its part"), tr("off its part"), tr("people"))
        for column, title in enumerate(titles):
            grid.addWidget(quiet(title, self), 0, column)
        for row in range(1, 4):
            cells = tuple(QLabel(self) for _ in range(5))
            cells[4].setProperty("role", "muted")
            cells[4].setWordWrap(True)
            for column, cell in enumerate(cells[:4]):
                grid.addWidget(cell, 2 * row - 1, column)
            grid.addWidget(cells[4], 2 * row, 1, 1, 4)  # a line of its own: sentences may be long
            self._cells.append(cells)
        return grid

    # sources

    def add(self, path: Path) -> None:
        """Read the labels of another session."""
        if any(one.path == path for one in self._sources):
            self._tell(tr("{0} is listed already").format(path.name))
            return
        self._read(lambda: source_at(path))

    def _read(self, read: Callable[[], Source]) -> None:
        if self._job is not None:
            self._tell(tr("Wait until the previous session has been read"))
            return

        def work(_: Progress) -> object:
            return read()

        self._tell(tr("Reading labels..."))
        self._job = Job(tr("Reading labels"), work, self, cancellable=False)
        self._job.done.connect(self._take)
        self._job.failed.connect(lambda error: self._end(explain(error)))
        self._job.start()
        self._show_counts()

    def _take(self, source: Source) -> None:
        self._sources.append(source)
        item = QListWidgetItem(source.said)
        item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
        item.setCheckState(Qt.CheckState.Checked)
        self._list.addItem(item)
        self._end("" if len(source.samples) else self._no_samples(source))

    def _no_samples(self, source: Source) -> str:
        return tr(
            "{session} holds no labels of tracked parts: label some{key} in a session "
            "tracked with {tracker}",
            session=source.title,
            tracker=body_part_tracker(),
            key=in_brackets("detector.suggest"),
        )

    def _end(self, told: str) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        self._tell(told)
        if self._waiting:
            self._read(self._waiting.pop(0))
        self._show_counts()

    def _tell(self, text: str) -> None:
        self._told.setText(text)
        self._told.setVisible(bool(text))

    def _remove(self) -> None:
        row = self._list.currentRow()
        if row >= 0:
            del self._sources[row]
            self._list.takeItem(row)
            self._show_counts()

    # the answer

    def _chosen(self) -> list[Source]:
        checked = Qt.CheckState.Checked
        rows = range(self._list.count())
        return [self._sources[row] for row in rows if self._list.item(row).checkState() is checked]

    def _show_counts(self) -> None:
        counts = counts_of(build_training_set(self._chosen()).samples)
        for cells, count in zip(self._cells, counts, strict=True):
            self._show_count(cells, count)
        self._off_list.setEnabled(self._list.currentRow() >= 0)
        enough = any(not count.missing for count in counts)
        self._train.setEnabled(enough and self._job is None)

    def _show_count(self, cells: tuple[QLabel, ...], count: PartCount) -> None:
        people = tr("{0} on, {1} off").format(count.people_on, count.people_off)
        texts = (count.name, str(count.on), str(count.off), people, count.missing)
        for cell, text in zip(cells, texts, strict=True):
            cell.setText(text)
        cells[4].setVisible(bool(count.missing))

    def answer(self) -> tuple[TrainingSet, TrainingSettings]:
        """What is learnt from and the settings."""
        settings: TrainingSettings = self._form.settings()
        return build_training_set(self._chosen()), settings

    def done(self, result: int) -> None:
        """Close, once nothing is read any more."""
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()
        super().done(result)
