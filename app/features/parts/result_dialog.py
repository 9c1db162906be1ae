"""What a training measured: curves, figures, mistakes; the operating point is chosen here."""

from __future__ import annotations

import math
from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.scenes.labels import PART_COLOURS
from app.core.widgets.parts import Swatch, heading, quiet
from app.features.parts.mistakes import Cutter, MistakesList
from app.features.parts.roc import RocPlot
from app.features.parts.training_result import PartFigures, ResultScene, TrainingResult

_UP_TO = (0.05, 0.2, 1.0)
_UP_TO_FIRST = 1
_UNKNOWN = "\u2013"


class ResultDialog(QDialog):
    """Shows a :class:`TrainingResult`; it stays open while its mistakes are looked at.

    Signals:
        use_asked(): the detector as it stands is used from now on. save_asked(): it is kept as a
            file. mistake_sought(object): a :class:`MistakeItem` is to be looked at.
    """

    use_asked = Signal()
    save_asked = Signal()
    mistake_sought = Signal(object)

    def __init__(self, result: TrainingResult, cut: Cutter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Result of the training"))
        self.result_shown = result
        self.plot = RocPlot(self)
        self.plot.put.connect(lambda share: self._change(lambda: result.put(share)))
        self.plot.stepped.connect(lambda way: self._change(lambda: result.step(way)))
        self.part_choice, self._up_to = QComboBox(self), QComboBox(self)
        self._cells: list[tuple[QLabel, ...]] = []
        self._about = quiet("", self)
        self._about.setWordWrap(True)
        self._warning = QLabel(self)
        self._warning.setWordWrap(True)
        self._warning.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._told = QLabel(self)
        self._told.setWordWrap(True)
        self._no_mistakes = quiet(tr("None: nothing was judged wrongly."), self)
        self.mistakes = MistakesList(cut, self)
        self.mistakes.sought.connect(self.mistake_sought)
        self.mistakes.failed.connect(lambda error: self.tell(explain(error)))
        self._lay_out()
        self._show()

    # what it looks like

    def _lay_out(self) -> None:
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(10)
        across = QHBoxLayout()
        across.setSpacing(24)
        across.addWidget(self.plot, 2)
        across.addLayout(self._figures_column())
        rows.addLayout(across, 3)
        title = heading(tr("Most informative mistakes: click one to go there"), self)
        rows.addWidget(title)
        rows.addWidget(self._no_mistakes)
        rows.addWidget(self.mistakes, 2)
        rows.addWidget(self._told)
        rows.addWidget(self._buttons())
        line, room = self.fontMetrics().height(), self.screen().availableSize()
        self.resize(min(62 * line, room.width()), min(50 * line, room.height() - 3 * line))

    def _figures_column(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        column.addWidget(heading(tr("Operating point"), self))
        names = [curve.name for curve in self.result_shown.scene().curves]
        self.part_choice.addItems([tr("of all parts"), *names])
        self.part_choice.setAccessibleName(tr("Part whose operating point is moved"))
        self.part_choice.currentIndexChanged.connect(self._choose)
        self._up_to.addItems([tr("up to {0:.0f} %").format(100 * one) for one in _UP_TO])
        self._up_to.setAccessibleName(tr("How many false alarms the plot shows"))
        self._up_to.currentIndexChanged.connect(lambda at: self.plot.show_up_to(_UP_TO[at]))
        self._up_to.setCurrentIndex(_UP_TO_FIRST)
        line = QHBoxLayout()
        line.addWidget(self.part_choice)
        line.addWidget(self._up_to)
        line.addStretch(1)
        column.addLayout(line)
        column.addLayout(self._steps())
        column.addLayout(self._figures_grid())
        column.addWidget(self._warning)
        column.addWidget(self._about)
        column.addStretch(1)
        return column

    def _steps(self) -> QHBoxLayout:
        """Buttons for what dragging and the arrow keys do, too."""
        line = QHBoxLayout()
        for text, way in ((tr("Fewer false alarms"), -1), (tr("Find more failures"), 1)):
            button = QPushButton(text, self)
            button.setAutoDefault(False)
            button.clicked.connect(
                lambda _=False, way=way: self._change(lambda: self.result_shown.step(way))
            )
            line.addWidget(button)
        line.addStretch(1)
        return line

    def _figures_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(4)
        grid.setColumnStretch(1, 1)
        titles = (
            "",
            "",
            tr("failures found"),
            tr("missed"),
            tr("false alarms"),
            tr("correct, not called failed"),
            tr("area under curve"),
        )
        for column, title in enumerate(titles):
            grid.addWidget(quiet(title, self), 0, column)
        for part in range(len(_rows(self.result_shown.scene()))):
            cells = tuple(QLabel(self) for _ in range(6))
            if part < len(PART_COLOURS):
                swatch = Swatch(self)
                swatch.set_track_colour(PART_COLOURS[part])
                grid.addWidget(swatch, part + 1, 0)
            for column, cell in enumerate(cells, start=1):
                grid.addWidget(cell, part + 1, column)
            self._cells.append(cells)
        return grid

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(self)
        use = QPushButton(tr("Use for tracking"), buttons)
        save = QPushButton(tr("Save as..."), buttons)
        close = QPushButton(tr("Close"), buttons)
        # What is no better than chance is not what Enter, or a glance, should lead to.
        proposed = close if self.result_shown.scene().warning else use
        proposed.setProperty("primary", True)
        buttons.addButton(use, QDialogButtonBox.ButtonRole.ApplyRole)
        buttons.addButton(save, QDialogButtonBox.ButtonRole.ActionRole)
        buttons.addButton(close, QDialogButtonBox.ButtonRole.RejectRole)
        for button in (use, save, close):
            button.setAutoDefault(False)
        proposed.setDefault(True)
        use.clicked.connect(self.use_asked)
        save.clicked.connect(self.save_asked)
        buttons.rejected.connect(self.reject)
        return buttons

    # what it says

    def _choose(self, index: int) -> None:
        self.result_shown.chosen = index - 1
        self._show()

    def _change(self, change: Callable[[], None]) -> None:
        change()
        self._told.clear()
        self._show()

    def tell(self, text: str) -> None:
        """A word about what was just done."""
        self._told.setText(text)

    def _show(self) -> None:
        scene = self.result_shown.scene()
        self.plot.show_scene(scene)
        for cells, figures in zip(self._cells, _rows(scene), strict=True):
            _fill(cells, figures)
        self._warning.setText(scene.warning)
        self._warning.setVisible(bool(scene.warning))
        self._about.setText("\n".join(scene.lines))
        self._about.setToolTip(scene.details)
        self._no_mistakes.setVisible(not scene.mistakes)
        self.mistakes.setVisible(bool(scene.mistakes))
        self.mistakes.show_items(scene.mistakes)

    def done(self, result: int) -> None:
        """Close, once no picture is read any more."""
        self.mistakes.close_pictures()
        super().done(result)


def _rows(scene: ResultScene) -> tuple[PartFigures, ...]:
    """The parts' figures, and below them those of several at once where that was learnt."""
    return scene.figures if scene.several is None else (*scene.figures, scene.several)


def _fill(cells: tuple[QLabel, ...], figures: PartFigures) -> None:
    """The name, and of those off and on their part how many were called failed, and not."""
    texts = (
        figures.name,
        f"{figures.found}  ({_share(figures.found, figures.off)})",
        f"{figures.off - figures.found}",
        f"{figures.false_alarms}  ({_share(figures.false_alarms, figures.on)})",
        f"{figures.on - figures.false_alarms}",
        f"{figures.area:.2f}" if math.isfinite(figures.area) else _UNKNOWN,
    )
    for cell, text in zip(cells, texts, strict=True):
        cell.setText(text)
        cell.setAccessibleName(figures.said)
        cell.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)


def _share(some: int, whole: int) -> str:
    return f"{100 * some / whole:.1f} %" if whole else _UNKNOWN
