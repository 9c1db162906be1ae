"""Whether each body part's rectangle lies on its part: three answers a part, and their counts."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QLineF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import current_theme, faded, scaled_font
from app.core.scenes.labels import PART_COLOURS
from app.core.widgets.choices import ChoiceButtons
from app.core.widgets.number_boxes import WholeBox, tell_beside
from app.core.widgets.parts import Swatch, quiet
from app.features.labelling.scene import LabellingScene
from app.features.labelling.suggestions import SuggestionsList
from tracking.tracks import PART_NAMES

_ANSWERS: tuple[tuple[str, bool | None], ...] = (("on", True), ("off", False), ("unsure", None))
_LONGEST_STEP = 1000
_STEP_LETTERS, _BAR_LETTERS = 11, 7
_BAR_HIGH_PX = 5.0


class BalanceBar(QWidget):
    """How many labels of a part say on, and how many off: which are missing is seen.

    Filled from the left as far as labels say on; the rest, hatched, says off.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._on, self._off = 0, 0

    def show_counts(self, name: str, on: int, off: int) -> None:
        """Show other counts of a part."""
        self._on, self._off = on, off
        if on + off:
            said = tr("{0}: {1:.0f} % of {2} labels say on its part, {3:.0f} % off")
            text = said.format(name, 100 * on / (on + off), on + off, 100 * off / (on + off))
        else:
            text = tr("{0}: no labels yet").format(name)
        self.setAccessibleName(text)
        self.setToolTip(text)
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """A few letters wide."""
        return QSize(_BAR_LETTERS * self.fontMetrics().averageCharWidth(), round(_BAR_HIGH_PX) + 6)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Never pressed together."""
        return self.sizeHint()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Two colours, and a line at the half."""
        theme, painter = current_theme(), QPainter(self)
        bar = QRectF(0.5, (self.height() - _BAR_HIGH_PX) / 2, self.width() - 1, _BAR_HIGH_PX)
        painter.fillRect(bar, theme.sunken)
        total = self._on + self._off
        if total:
            on = QRectF(bar.left(), bar.top(), bar.width() * self._on / total, bar.height())
            off = QRectF(on.right(), bar.top(), bar.right() - on.right(), bar.height())
            painter.fillRect(on, theme.good)
            painter.fillRect(off, faded(theme.danger, 0.35))
            painter.fillRect(off, QBrush(theme.danger, Qt.BrushStyle.BDiagPattern))
        painter.setPen(theme.text_muted)
        middle = bar.center().x()
        painter.drawLine(QLineF(middle, bar.top() - 2, middle, bar.bottom() + 2))
        painter.end()


class PartsGrid(QWidget):
    """A line a part: its name, three answers with how often each was given in all.

    Signals:
        said(int, object): a part and True, False or None.
        chosen(int): a part's name was clicked.
        step_chosen(int): frames to go on after the last part.
        scope_chosen(int): which of the ways how far an answer goes.
        suggestion_chosen(int): the number of the suggestion that was clicked.
    """

    said = Signal(int, object)
    chosen = Signal(int)
    step_chosen = Signal(int)
    scope_chosen = Signal(int)
    suggestion_chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(8)
        grid = QGridLayout()
        grid.setHorizontalSpacing(3)
        grid.setColumnMinimumWidth(0, self.fontMetrics().ascent())
        grid.setVerticalSpacing(1)
        grid.setColumnStretch(1, 1)
        rows.addLayout(grid)
        self._swatches: list[Swatch] = []
        self._names: list[QToolButton] = []
        self._answers: dict[tuple[int, bool | None], QToolButton] = {}
        self._balances: list[BalanceBar] = []
        for part in range(len(PART_NAMES)):
            self._build_line(grid, part)
        self._scope = ChoiceButtons(self)
        self._scope.chosen.connect(self.scope_chosen)
        rows.addWidget(self._scope)
        self._keys = quiet(
            tr("4 on, 5 off, 6 unsure; then the next part. 7, 8, 9 choose a part."), self
        )
        self._keys.setWordWrap(True)
        rows.addWidget(self._keys)
        self._step_line = QWidget(self)
        self._step_line.setLayout(self._build_step())
        rows.addWidget(self._step_line)
        self._suggestions = SuggestionsList(self)
        self._suggestions.chosen.connect(self.suggestion_chosen)
        rows.addWidget(self._suggestions)

    def _build_line(self, grid: QGridLayout, part: int) -> None:
        swatch, name = Swatch(self), QToolButton(self)
        name.setCheckable(True)
        name.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        name.clicked.connect(partial(self.chosen.emit, part))
        grid.addWidget(swatch, 2 * part, 0)
        grid.addWidget(name, 2 * part, 1, Qt.AlignmentFlag.AlignLeft)
        self._swatches.append(swatch)
        self._names.append(name)
        for column, (_, answer) in enumerate(_ANSWERS, start=2):
            button = QToolButton(self)
            button.setCheckable(True)
            button.setProperty("segment", True)
            button.setProperty("tight", True)
            button.setFont(scaled_font(self.font(), 0.88))
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            button.clicked.connect(partial(self.said.emit, part, answer))
            grid.addWidget(button, 2 * part, column)
            self._answers[part, answer] = button
        balance = BalanceBar(self)
        grid.addWidget(balance, 2 * part + 1, 2, 1, len(_ANSWERS))
        self._balances.append(balance)

    def _build_step(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(QLabel(tr("After the last part, go on"), self))
        self._step = WholeBox(self)
        self._step.setRange(0, _LONGEST_STEP)
        tell_beside(self._step)
        self._step.setMaximumWidth(_STEP_LETTERS * self.fontMetrics().averageCharWidth())
        self._step.setAccessibleName(tr("Frames to go on after the last part"))
        self._step.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._step.valueChanged.connect(self.step_chosen)
        line.addWidget(self._step)
        line.addWidget(QLabel(tr("frames"), self))
        line.addStretch(1)
        return line

    def show_scene(self, scene: LabellingScene) -> None:
        """Show what was said of the parts of the person in the frame."""
        words = {True: tr("On"), False: tr("Off"), None: tr("?")}
        for part, swatch in enumerate(self._swatches):
            there = part < len(scene.parts)
            self._names[part].setVisible(there)
            swatch.setVisible(there)
            for number, (said, answer) in enumerate(_ANSWERS):
                button = self._answers[part, answer]
                button.setVisible(there)
                if there:
                    line = scene.parts[part]
                    button.setText(f"{words[answer]}  {line.counts[number]}")
                    button.setChecked(line.said == said)
                    told = tr("{0}: {1}, labelled {2} times in all")
                    button.setAccessibleName(
                        told.format(line.name, words[answer], line.counts[number])
                    )
                    button.setToolTip(button.accessibleName())
            self._balances[part].setVisible(there)
            if there:
                self._name_line(scene, part)
                line = scene.parts[part]
                self._balances[part].show_counts(line.name, line.counts[0], line.counts[1])
        self._keys.setVisible(bool(scene.parts))
        self._scope.show_scene(scene.scope if scene.parts else None)
        self._step_line.setVisible(scene.suggestions is None)
        self._suggestions.show_scene(scene)
        self._step.blockSignals(True)
        self._step.setValue(scene.step)
        self._step.blockSignals(False)

    def _name_line(self, scene: LabellingScene, part: int) -> None:
        line = scene.parts[part]
        self._swatches[part].set_track_colour(PART_COLOURS[part])
        self._names[part].setText(line.name)
        self._names[part].setChecked(line.chosen)
        self._names[part].setFont(scaled_font(self.font(), 1.0, bold=line.chosen))
