"""The panel of the score: the truth, how rows are paired, the figures, the kinds of errors."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.drawing.error_signs import sign_icon
from app.core.feature import FeaturePanel
from app.core.i18n import tr
from app.core.keymap import key_or_title
from app.core.look.icons import IconButton
from app.core.scenes.ground_truth import ERROR_COLOURS
from app.core.scenes.score_figures import awaited_rows
from app.core.widgets.eliding_list import ElidingList
from app.core.widgets.number_boxes import NumberBox, tell_beside
from app.core.widgets.parts import quiet, quiet_beside
from app.features.scoring.figures_table import FiguresTable
from app.features.scoring.scene import ErrorChoice, ScoreScene
from tracking.scoring import ErrorKind

_LEAST, _WIDEST_M = 0.05, 10.0
_KINDS_APART = 4
_ONE_LINE_LETTERS, _SHORTENED_LETTERS = 118, 84
"""A panel so wide asks for truth, result and pairing in one line; a low one shortens them first."""
_LOW_LINES = 19
"""A panel of fewer lines of text is low."""


class ScorePanel(FeaturePanel):
    """Draws a :class:`ScoreScene`; hidden without one.

    Signals:
        truth_chosen(int), result_chosen(int): of the lists.
        floor_chosen(bool): by distance on the floor. threshold_chosen(float): overlap or metres.
        kind_shown(object, bool): a kind of error is to be shown or not.
        next_asked(int): 1 the next error, -1 the one before.
    """

    truth_chosen = Signal(int)
    result_chosen = Signal(int)
    floor_chosen = Signal(bool)
    threshold_chosen = Signal(float)
    kind_shown = Signal(object, bool)
    next_asked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Score"), parent)
        self._lists: dict[QComboBox, tuple[str, ...]] = {}
        self._doing = quiet_beside("", self)
        self.add_to_heading(self._doing)
        self._add_buttons()
        self.table = FiguresTable(self)
        self._message = self._words("muted")
        self._moved = self._words("muted")
        self._notes = self._words("muted")
        self._kinds: dict[ErrorKind, QToolButton] = {}
        self._counted: dict[ErrorKind, tuple[str, str]] = dict.fromkeys(ERROR_COLOURS, ("", ""))
        body = QVBoxLayout()
        body.setSpacing(6)
        # Side by side where there is room: figures are what the panel is for.
        self._asked = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self._asked.setSpacing(6)
        self._asked.addLayout(self._choice(), 11)
        self._asked.addLayout(self._pairing(), 10)
        body.addLayout(self._asked)
        for widget in (self._message, self._notes):
            body.addWidget(widget)
        body.addWidget(self.table, 1)
        body.addWidget(self._moved)
        body.addLayout(self._errors())
        self.layout_body(body)
        self.hide()

    def _words(self, role: str) -> QLabel:
        label = quiet("", self, role)
        label.setWordWrap(True)
        return label

    def _add_buttons(self) -> None:
        for drawing, name, command, step in (
            ("step-back", tr("Previous error"), "review.previous_error", -1),
            ("step-forward", tr("Next error"), "review.next_error", 1),
        ):
            button = IconButton(drawing, name, command, self)
            button.clicked.connect(lambda _=False, step=step: self.next_asked.emit(step))
            self.add_to_heading(button)
        self._report = QToolButton(self)
        self._report.setText(tr("Report..."))
        self._report.setToolTip(tr("Write a page with all results into a folder, to pass on"))
        self._report.setProperty("outlined", True)
        self._report.clicked.connect(lambda: self.command_asked.emit("file.export_report"))
        self.add_to_heading(self._report)
        close = IconButton("close", tr("Hide the score"), "view.score", self)
        close.clicked.connect(lambda: self.command_asked.emit("view.score"))
        self.add_to_heading(close)

    def _choice(self) -> QHBoxLayout:
        """Which truth, and whose tracks."""
        line = QHBoxLayout()
        line.setSpacing(6)
        self._truth = ElidingList(tr("Ground truth"), self)
        self._truth.activated.connect(self.truth_chosen)
        self._result = ElidingList(tr("Whose tracks are scored"), self)
        self._result.activated.connect(self.result_chosen)
        for chooser in (self._truth, self._result):
            chooser.take_room()
        line.addWidget(quiet_beside(tr("Ground truth"), self))
        line.addWidget(self._truth, 6)
        line.addWidget(quiet_beside(tr("Result"), self))
        line.addWidget(self._result, 5)
        return line

    def _pairing(self) -> QHBoxLayout:
        """How a row of the truth and one of the result are one person."""
        line = QHBoxLayout()
        line.setSpacing(6)
        self._way = ElidingList(tr("How rows of ground truth and result are matched"), self)
        self._way.addItems([tr("Boxes that overlap"), tr("Positions on the floor")])
        self._way.activated.connect(lambda at: self.floor_chosen.emit(at == 1))
        self._threshold = NumberBox(self)
        tell_beside(self._threshold)
        self._threshold.setDecimals(2)
        self._threshold.setSingleStep(0.05)
        self._threshold.setKeyboardTracking(False)
        self._threshold.setAccessibleName(tr("Limit for two boxes or positions to match"))
        self._threshold.valueChanged.connect(self.threshold_chosen)
        line.addWidget(quiet_beside(tr("Matched by"), self))
        line.addWidget(self._way, 1)
        line.addWidget(self._threshold)
        return line

    def _errors(self) -> QHBoxLayout:
        """A button for each kind, with its sign: on, it is shown and walked through."""
        line = QHBoxLayout()
        line.setSpacing(_KINDS_APART)
        for kind in ERROR_COLOURS:
            button = QToolButton(self)
            button.setCheckable(True)
            button.setProperty("outlined", True)
            button.setToolButtonStyle(button.toolButtonStyle().ToolButtonTextBesideIcon)
            button.setIcon(sign_icon(kind))
            button.toggled.connect(lambda on, kind=kind: self.kind_shown.emit(kind, on))
            self._kinds[kind] = button
            line.addWidget(button)
        line.addStretch(1)
        return line

    def _fit_kinds(self) -> None:
        """Buttons of errors without room for their words say how many, beside their sign."""
        margins = self._rows.contentsMargins()
        room = self.width() - margins.left() - margins.right()
        for terse in (False, True):
            for kind, button in self._kinds.items():
                name, number = self._counted[kind]
                button.setText(number if terse else f"{name} {number}".strip())
            if sum(one.sizeHint().width() + _KINDS_APART for one in self._kinds.values()) <= room:
                return

    # showing

    def show_scene(self, scene: ScoreScene | None) -> None:
        """Show another score, or nothing at all."""
        self.setVisible(scene is not None)
        if scene is None:
            return
        self._doing.setText(scene.doing)
        self._fill(self._truth, scene.truths, scene.truth)
        self._fill(self._result, scene.results, scene.result)
        self._way.setCurrentIndex(int(scene.on_floor))
        self._show_threshold(scene)
        self._say(self._message, scene.message)
        self._say(self._notes, "\n".join(map(tr, scene.notes)))
        self._say(self._moved, scene.moved)
        self._report.setEnabled(bool(scene.rows))
        if not scene.rows and (scene.doing or not scene.message):
            scene = replace(scene, rows=awaited_rows())  # nothing moves once the figures come
        self.table.setVisible(bool(scene.rows))
        self.table.show_scene(scene)
        for choice in scene.errors:
            self._show_kind(choice)
        self._fit_kinds()

    def _fill(self, chooser: QComboBox, texts: tuple[str, ...], current: int) -> None:
        if self._lists.get(chooser) != texts:
            self._lists[chooser] = texts
            chooser.clear()
            chooser.addItems(list(texts))
        chooser.setCurrentIndex(current)

    def _show_threshold(self, scene: ScoreScene) -> None:
        spin = self._threshold
        blocked = spin.blockSignals(True)
        unit = " m" if scene.on_floor else " IoU"
        if spin.suffix() != unit:  # setting it, though the same, would undo what is being typed
            spin.setRange(_LEAST, _WIDEST_M if scene.on_floor else 1.0)
            spin.setSuffix(unit)
        spin.setToolTip(
            tr("Positions farther apart than this do not match")
            if scene.on_floor
            else tr("Boxes that overlap less than this (intersection over union) do not match")
        )
        if not spin.hasFocus():
            spin.setValue(scene.threshold)
        spin.blockSignals(blocked)

    def _show_kind(self, choice: ErrorChoice) -> None:
        button = self._kinds[choice.kind]
        number = str(choice.count) if choice.count >= 0 else ""
        blocked = button.blockSignals(True)
        self._counted[choice.kind] = choice.name, number
        button.setChecked(choice.shown)
        button.blockSignals(blocked)
        said = tr("shown") if choice.shown else tr("left out")
        button.setAccessibleName(f"{choice.name} {number}, {said}")
        told = tr("{0}: show them on the timeline; {1} goes to the next")
        button.setToolTip(told.format(choice.name, key_or_title("review.next_error")))

    @staticmethod
    def _say(label: QLabel, text: str) -> None:
        label.setText(text)
        label.setVisible(bool(text))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """What is asked takes as few lines as it can."""
        super().resizeEvent(event)
        self._fit_kinds()
        metrics = self.fontMetrics()
        low = self.height() < _LOW_LINES * metrics.lineSpacing()
        letters = _SHORTENED_LETTERS if low else _ONE_LINE_LETTERS
        wide = self.width() >= letters * metrics.averageCharWidth()
        way = QBoxLayout.Direction
        self._asked.setDirection(way.LeftToRight if wide else way.TopToBottom)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            for kind, button in getattr(self, "_kinds", {}).items():
                button.setIcon(sign_icon(kind))
