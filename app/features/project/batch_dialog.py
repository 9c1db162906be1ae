"""What a batch is asked before it starts: which recordings, which tracker, where results go."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, tr
from app.core.widgets.parts import quiet
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import LastFolder
from app.features.project.batch_process import BatchWish
from tracking.trackers import TRACKERS

_LETTERS = 84


class BatchDialog(QDialog):
    """Asks for a `BatchWish`; `answer` gives it once the dialog is accepted."""

    def __init__(
        self,
        choices: Mapping[str, tuple[Path, ...]],
        out: Path,
        last: LastFolder,
        parent: QWidget,
    ) -> None:
        """Shows what can be chosen.

        Args:
            choices: recordings by what the choice is called; those without any are left out.
            out: the folder that is proposed. last: where a folder was chosen last.
        """
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Track recordings"))
        self._last = last
        self._choices = {name: paths for name, paths in choices.items() if paths}
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        form = QFormLayout()
        form.setVerticalSpacing(12)
        form.addRow(tr("Recordings"), self._build_choices())
        self.tracker = QComboBox(self)
        self.tracker.addItem(tr("The best one for each recording"), "")
        for spec in TRACKERS.values():
            self.tracker.addItem(f"{spec.name}: {tr(spec.title)}", spec.name)
        self.tracker.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        form.addRow(tr("Tracker"), self.tracker)
        form.addRow(tr("Results in"), self._build_place(out))
        rows.addLayout(form)
        about = quiet(
            tr(
                "Each recording gets a session in this folder, and a report lists them all. What "
                "is done already is not tracked again; sessions that somebody corrected stay."
            ),
            self,
        )
        about.setWordWrap(True)
        rows.addWidget(about)
        rows.addStretch(1)
        rows.addWidget(self._build_buttons())
        self.resize(_LETTERS * self.fontMetrics().averageCharWidth() + 40, self.sizeHint().height())

    def answer(self) -> BatchWish:
        """What was chosen."""
        checked = self.choice.checkedButton()
        paths = self._choices[checked.objectName()] if checked is not None else ()
        return BatchWish(paths, Path(self.place.text().strip()), self.tracker.currentData())

    def _build_choices(self) -> QWidget:
        box = QWidget(self)
        rows = QVBoxLayout(box)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        self.choice = QButtonGroup(self)
        for name, paths in self._choices.items():
            count = count_text(len(paths), "{n} recording", "{n} recordings")
            button = QRadioButton(f"{name} ({count})", box)
            button.setObjectName(name)
            self.choice.addButton(button)
            rows.addWidget(button)
        self.choice.buttons()[0].setChecked(True)
        return box

    def _build_place(self, out: Path) -> QWidget:
        box = QWidget(self)
        row = QHBoxLayout(box)
        row.setContentsMargins(0, 0, 0, 0)
        self.place = QLineEdit(str(out), box)
        self.place.setAccessibleName(tr("Folder for the results"))
        self.place.textChanged.connect(self._check)
        browse = QPushButton(tr("Choose..."), box)
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        row.addWidget(self.place, 1)
        row.addWidget(browse)
        return box

    def _build_buttons(self) -> QDialogButtonBox:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, self)
        self.start = QPushButton(tr("Start"), box)
        self.start.setProperty("primary", True)
        box.addButton(self.start, QDialogButtonBox.ButtonRole.AcceptRole)
        self.start.setDefault(True)
        box.accepted.connect(self.accept)
        box.rejected.connect(self.reject)
        return box

    def _browse(self) -> None:
        choose_file(
            self,
            tr("Folder for the results"),
            "",
            lambda path: self.place.setText(str(path)),
            self._last,
            folder=True,
        )

    def _check(self, text: str) -> None:
        self.start.setEnabled(Path(text.strip()).is_absolute())
