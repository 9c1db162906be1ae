"""The panel of what is counted: at the frame shown, over time, step by step."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.feature import FeaturePanel
from app.core.i18n import tr
from app.core.look.icons import IconButton
from app.core.plots.axis import TimeAxis
from app.core.widgets.eliding_list import ElidingList
from app.core.widgets.number_boxes import NumberBox, tell_beside
from app.core.widgets.parts import quiet, quiet_beside
from app.features.counting.counts_plot import CountsPlot
from app.features.counting.scene import CountingScene
from app.features.counting.steps_table import StepsTable
from app.features.counting.tally_list import TallyList
from tracking.counting import CountSettings
from tracking.settings import settings_fields

_NUMBER_LETTERS = 12
"""Of a field for a number, its arrows among them: the list beside them needs the room."""
_MOST = {field.name: field.range[1] for field in settings_fields(CountSettings) if field.range}
"""The largest value of each setting."""


class CountingPanel(FeaturePanel):
    """Draws a :class:`CountingScene`; hidden without one.

    Signals:
        frame_sought(int): a click into a plot or on a step.
        picked(bool, str): what is to be plotted. track_source_chosen(int): its number.
        step_chosen(float), jitter_chosen(float), jitter_px_chosen(float): seconds, metres, pixels.
        copied(int): so many steps are on the clipboard.
    """

    frame_sought = Signal(int)
    picked = Signal(bool, str)
    track_source_chosen = Signal(int)
    step_chosen = Signal(float)
    jitter_chosen = Signal(float)
    jitter_px_chosen = Signal(float)
    copied = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Counting"), parent)
        self._doing = quiet("", self)
        self.add_to_heading(self._doing)
        self._add_buttons()
        close = IconButton("close", tr("Hide the counting"), "view.counting", self)
        close.clicked.connect(lambda: self.command_asked.emit("view.counting"))
        self.add_to_heading(close)
        self.tallies = TallyList(self)
        self.plot, self.table = CountsPlot(self), StepsTable(self)
        self._pages = QStackedWidget(self)
        self._pages.addWidget(self.plot)
        self._pages.addWidget(self.table)
        self._tracks: tuple[str, ...] = ()
        body = QVBoxLayout()
        body.setSpacing(6)
        body.addLayout(self._ways())
        body.addWidget(self.tallies)
        body.addWidget(self._pages, 1)
        self.layout_body(body)
        self._connect()
        self.hide()

    def _ways(self) -> QHBoxLayout:
        """How time is cut, what trembling is, whose tracks are counted."""
        line = QHBoxLayout()
        line.setSpacing(6)
        self._step = self._number(tr("Step"), tr("How long a step is"), _MOST["step_s"], " s")
        self._jitter = self._number(
            tr("Jitter"),
            tr("Ignore re-crossings within this distance of a line on the floor"),
            _MOST["jitter_m"],
            " m",
        )
        self._jitter_px = self._number(
            tr("Jitter in the image"),
            tr("Ignore re-crossings within this distance of a line in the image"),
            _MOST["jitter_px"],
            " px",
        )
        self._track_sources = ElidingList(tr("Whose tracks are counted"), self)
        self._jitter_px.setDecimals(1)
        self._jitter_px.setSingleStep(1.0)
        line.addWidget(quiet_beside(tr("Step"), self))
        line.addWidget(self._step)
        line.addWidget(quiet_beside(tr("Jitter"), self))
        line.addWidget(self._jitter)
        line.addWidget(self._jitter_px)
        line.addWidget(self._track_sources, 1)
        return line

    def _add_buttons(self) -> None:
        """Plots or table; copy, save."""
        self._as_table = self._button(tr("Table"), tr("Show every step as a table, or the plots"))
        self._as_table.setCheckable(True)
        self._copy = self._button(tr("Copy"), tr("Copy the chosen steps, or all"))
        self._save = self._button(tr("Save..."), tr("Save all steps as CSV"))
        for button in (self._as_table, self._copy, self._save):
            self.add_to_heading(button)

    def _number(self, name: str, hint: str, most: float, unit: str) -> NumberBox:
        spin = NumberBox(self)
        tell_beside(spin)
        spin.setRange(0.0, most)
        spin.setDecimals(2)
        spin.setSingleStep(0.05)
        spin.setSuffix(unit)
        spin.setMaximumWidth(_NUMBER_LETTERS * self.fontMetrics().averageCharWidth())
        spin.setAccessibleName(name)
        spin.setToolTip(hint)
        spin.setKeyboardTracking(False)
        return spin

    def _button(self, text: str, hint: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(hint)
        button.setProperty("outlined", True)
        return button

    def _connect(self) -> None:
        self.tallies.picked.connect(self.picked)
        self.plot.frame_sought.connect(self.frame_sought)
        self.table.frame_sought.connect(self.frame_sought)
        self._track_sources.activated.connect(self.track_source_chosen)
        self._step.valueChanged.connect(self.step_chosen)
        self._jitter.valueChanged.connect(self.jitter_chosen)
        self._jitter_px.valueChanged.connect(self.jitter_px_chosen)
        self._as_table.toggled.connect(self._turn)
        self._copy.clicked.connect(lambda: self.copied.emit(self.table.copy()))
        self._save.clicked.connect(lambda: self.command_asked.emit("file.export_counts"))

    def show_axis(self, axis: TimeAxis) -> None:
        """The timeline shows other frames."""
        self.plot.show_axis(axis)

    def _turn(self, to_table: bool) -> None:
        """The table says what the tallies do, and needs their room."""
        self._pages.setCurrentIndex(int(to_table))
        self.tallies.setHidden(to_table)

    def show_scene(self, scene: CountingScene | None) -> None:
        """Show another frame, or nothing at all."""
        self.setVisible(scene is not None)
        if scene is None:
            return
        self._doing.setText(scene.doing)
        self._show_ways(scene)
        self.tallies.show_scene(scene)
        self.tallies.setHidden(self._as_table.isChecked() or not scene.rows)
        self.plot.show_scene(scene)
        self.table.show_counts(scene.counts, scene.frame, scene.fps)

    def _show_ways(self, scene: CountingScene) -> None:
        if scene.tracks != self._tracks:
            self._tracks = scene.tracks
            self._track_sources.clear()
            self._track_sources.addItems(list(scene.tracks))
        self._track_sources.setCurrentIndex(scene.track_source)
        for spin, shown in zip((self._jitter, self._jitter_px), scene.jitters, strict=True):
            spin.setVisible(shown)
        values = (scene.step_s, scene.jitter_m, scene.jitter_px)
        for spin, value in zip((self._step, self._jitter, self._jitter_px), values, strict=True):
            blocked = spin.blockSignals(True)
            if spin is self._step:
                spin.setMinimum(scene.least_step_s)
            if not spin.hasFocus():
                spin.setValue(value)
            spin.blockSignals(blocked)
        for button in (self._copy, self._save):
            button.setEnabled(scene.counts is not None and bool(scene.rows))
