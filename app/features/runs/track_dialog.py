"""The question before tracking: which tracker, with which settings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.core.document.detector_choice import DETECTOR, OCCLUDERS, PartSettings
from app.core.i18n import tr
from app.core.widgets.number_boxes import WholeBox, why_refused
from app.core.widgets.parts import quiet
from app.core.widgets.settings_form import SettingsForm
from app.core.widgets.settings_search import SettingSearch
from app.core.widgets.tab_order import tab_in_reading_order
from app.core.widgets.user_settings import UserSettings
from app.features.runs.detections_line import FILLED_IN, DetectionsLine
from app.features.runs.parts_line import PartsLine
from app.features.runs.tracker_state import why_not_tracked
from tracking.plugins import CatalogueFault
from tracking.recording import Recording
from tracking.settings import settings_values
from tracking.trackers import TRACKERS, SettingField, best_tracker, settings_fields

_EXPERT = "track/expert settings"


class TrackDialog(QDialog):
    """Chooses a tracker that can work on the recording, its settings, the frames and the seed.

    `warning` is said above where tracking would replace something; `asked` is filled in for
    trackers that follow body parts; `remembered` says whether expert settings are shown.
    """

    def __init__(
        self,
        recording: Recording,
        chosen: str,
        remembered: UserSettings,
        warning: str = "",
        parent: QWidget | None = None,
        asked: PartSettings | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Track...").rstrip("."))
        self._names = list(TRACKERS)
        self._why_not = {name: why_not_tracked(name, recording) for name in self._names}
        fitting = [name for name in self._names if not self._why_not[name]]
        self._best = best_tracker(recording) if fitting else ""
        self._choice = QComboBox(self)
        self._choice.setAccessibleName(tr("Tracker"))
        self._title = quiet("", self)
        self._title.setWordWrap(True)
        self._number_fields(recording.frame_count - 1)
        self._parts = PartsLine(asked or PartSettings(), self)
        self._detections = DetectionsLine(recording, remembered, self)
        self._remembered = remembered
        self._choose_settings()
        self._forms = QStackedWidget(self)
        for name in self._names:
            self._add_choice(name)
            form = SettingsForm(TRACKERS[name], self, without=(DETECTOR, OCCLUDERS, *FILLED_IN))
            form.show_expert(self._expert.isChecked())
            self._forms.addWidget(_scrolled(form))
        for fault in TRACKERS.faults:
            self._add_fault(fault)
        self._choice.currentIndexChanged.connect(self._show_tracker)
        first = chosen if chosen in fitting else next(iter(fitting), self._names[0])
        self._choice.setCurrentIndex(self._names.index(first))
        self._lay_out(warning)
        self._show_tracker(self._choice.currentIndex())

    def _choose_settings(self) -> None:
        """Which settings are shown: by words, or experts' too."""
        self._search = SettingSearch(self)
        self._search.textChanged.connect(self._find)
        self._expert = QCheckBox(self)
        self._expert.setToolTip(tr("Changed settings are always shown, and search finds all"))
        self._expert.setChecked(self._remembered.text(_EXPERT) == "shown")
        self._expert.toggled.connect(self._show_expert)
        self._nothing = quiet(tr("No setting of this tracker has these words."), self)

    def _number_fields(self, last: int) -> None:
        """The seed, and which frames are tracked."""
        self._refused = quiet("", self, "warning")
        self._refused.setWordWrap(True)
        self._refused.hide()
        self._seed = self._whole_box(tr("Seed of the random numbers"), 2**31 - 1)
        self._seed.setToolTip(tr("The same seed gives the same tracks"))
        self._first = self._whole_box(tr("First frame"), last)
        self._last = self._whole_box(tr("Last frame"), last)
        self._last.setValue(last)
        self._first.valueChanged.connect(self._last.setMinimum)
        self._last.valueChanged.connect(self._first.setMaximum)
        self._whole = (0, last)

    def _add_choice(self, name: str) -> None:
        """One that cannot work on the recording is greyed, and says why."""
        self._choice.addItem(name)
        row, why_not = self._choice.count() - 1, self._why_not[name]
        model = self._choice.model()
        assert isinstance(model, QStandardItemModel)
        if why_not:
            model.item(row).setEnabled(False)
            model.item(row).setText(tr("{0} (not for this recording)").format(name))
        self._choice.setItemData(
            row, why_not or tr(TRACKERS[name].title), Qt.ItemDataRole.ToolTipRole
        )

    def _add_fault(self, fault: CatalogueFault) -> None:
        """A plug-in's tracker that does not work: greyed, behind all others, and says why."""
        self._choice.addItem(tr("{name} (does not work)", name=fault.offer.name))
        row, model = self._choice.count() - 1, self._choice.model()
        assert isinstance(model, QStandardItemModel)
        model.item(row).setEnabled(False)
        self._choice.setItemData(row, tr(fault.error.message), Qt.ItemDataRole.ToolTipRole)

    def _lay_out(self, warning: str) -> None:
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        if warning:
            said = QLabel(warning, self)
            said.setWordWrap(True)
            rows.addWidget(said)
        form = QFormLayout()
        form.addRow(tr("Tracker"), self._choice)
        form.addRow("", self._title)
        form.addRow(tr("Frames"), self._frames_line())
        form.addRow(tr("Seed"), self._seed)
        form.addRow("", self._refused)
        self._detections.add_to(form)
        form.addRow("", self._parts)
        rows.addLayout(form)
        seeking = QHBoxLayout()
        seeking.addWidget(self._search, 1)
        seeking.addWidget(self._expert)
        rows.addLayout(seeking)
        rows.addWidget(self._nothing)
        rows.addWidget(self._forms, 1)
        buttons = QDialogButtonBox(self)
        start = QPushButton(tr("Track...").rstrip("."), buttons)
        start.setProperty("primary", True)  # before it is first polished, or it has no effect
        buttons.addButton(start, QDialogButtonBox.ButtonRole.AcceptRole)
        start.setDefault(True)
        self._detections.usable.connect(start.setEnabled)
        reset = buttons.addButton(tr("Defaults"), QDialogButtonBox.ButtonRole.ResetRole)
        reset.clicked.connect(self._reset)
        buttons.addButton(QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        rows.addWidget(buttons)
        tab_in_reading_order(self)
        line = self.fontMetrics().height()
        room = self.screen().availableSize()
        self.resize(min(48 * line, room.width()), min(44 * line, room.height() - 4 * line))

    def _reset(self) -> None:
        """The settings of the chosen tracker, those of detections too, as they come."""
        self.form.reset()
        self._detections.reset()

    def _whole_box(self, name: str, most: int) -> WholeBox:
        box = WholeBox(self)
        box.setRange(0, most)
        box.setAccessibleName(name)
        box.typed.connect(lambda refused: self._tell(box, refused))
        return box

    def _tell(self, box: WholeBox, refused: str) -> None:
        """Below the numbers: why the one that is typed cannot be."""
        self._refused.setText(why_refused(box, refused))
        self._refused.setVisible(bool(refused))

    def _frames_line(self) -> QHBoxLayout:
        line = QHBoxLayout()
        whole = QPushButton(tr("All"), self)
        whole.setAccessibleName(tr("Track all frames"))
        whole.setAutoDefault(False)
        whole.clicked.connect(lambda: self.put_frames(*self._whole))
        for widget in (self._first, quiet(tr("to"), self), self._last, whole):
            line.addWidget(widget)
        line.addStretch(1)
        return line

    def put_settings(self, tracker: str, values: Mapping[str, Any], seed: int) -> None:
        """Choose a tracker, its settings as far as it knows them, and the seed."""
        if tracker in self._names and not self._why_not[tracker]:
            self._choice.setCurrentIndex(self._names.index(tracker))
            self.form.put_known(values)
            self._detections.put(values)
        self._seed.setValue(seed)

    def put_frames(self, first: int, last: int) -> None:
        """Choose the frames that are tracked, the last one among them."""
        for box, value in ((self._first, first), (self._last, last)):
            box.setRange(*self._whole)
            box.setValue(value)
        self._last.setMinimum(first)
        self._first.setMaximum(last)

    def put_answer(
        self, tracker: str, settings: Any, seed: int, frames: tuple[int, int] | None
    ) -> None:
        """Fill in what was answered once, for whoever has to put one thing of it right."""
        self.put_settings(tracker, settings_values(settings), seed)
        first, stop = frames or (self._whole[0], self._whole[1] + 1)
        self.put_frames(first, stop - 1)

    @property
    def form(self) -> SettingsForm:
        """The chosen tracker's settings."""
        return _form_in(self._forms.currentWidget())

    def answer(self) -> tuple[str, Any, int, tuple[int, int] | None]:
        """Tracker, settings, seed and the half-open range of frames; None: all of them."""
        chosen = (self._first.value(), self._last.value())
        frames = None if chosen == self._whole else (chosen[0], chosen[1] + 1)
        name = self._names[self._choice.currentIndex()]
        asked = self._parts.asked()
        values = {**self.form.values(), **self._detections.values()}
        settings = asked.filled(TRACKERS[name].settings_type, values)
        return name, settings, self._seed.value(), frames

    def _show_tracker(self, index: int) -> None:
        if self._names:
            spec = TRACKERS[self._names[index]]
            about = f"{tr(spec.title)} ({spec.paper})" if spec.paper else tr(spec.title)
            if self._names[index] == self._best:
                about = tr("{0}. The best for this recording.").format(about)
            self._title.setText(about)
            self._forms.setCurrentIndex(index)
            self._parts.show_for(spec.settings_type)
            self._detections.show_for(spec.settings_type, stereo=spec.needs_stereo)
            self._expert.setText(self._expert_words(settings_fields(spec.settings_type)))
            self._find()

    def _expert_words(self, fields: Sequence[SettingField]) -> str:
        """How many there are, of how many the command line lists: some have fields above."""
        shown, all_ = self.form.expert_count, sum(field.expert for field in fields)
        if shown == all_:
            return tr("Expert settings ({n})", n=shown)
        return tr("Expert settings ({n} of {all})", n=shown, all=all_)

    def _show_expert(self, shown: bool) -> None:
        """Show or hide the expert settings of all trackers, and next time too."""
        self._remembered.set_text(_EXPERT, "shown" if shown else "hidden")
        for row in range(self._forms.count()):
            _form_in(self._forms.widget(row)).show_expert(shown)

    def _find(self) -> None:
        """Show what is sought among the chosen tracker's settings."""
        self._nothing.setVisible(not self.form.seek(self._search.text()))


def _form_in(area: QWidget | None) -> SettingsForm:
    assert isinstance(area, QScrollArea)
    form = area.widget()
    assert isinstance(form, SettingsForm)
    return form


def _scrolled(form: SettingsForm) -> QScrollArea:
    area = QScrollArea()
    area.setWidget(form)
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # it follows the setting that is chosen
    return area
