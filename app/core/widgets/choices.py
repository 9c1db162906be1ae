"""Joined buttons to choose one of a few things, and chips of what was found."""

from __future__ import annotations

from unicodedata import east_asian_width

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap, QResizeEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import joined_text, tr
from app.core.look.theme import current_theme, scaled_font
from app.core.scenes import ChoiceRow, Proposal
from app.core.widgets.literal import literal
from app.core.widgets.parts import quiet

_WIDEST_ROW = 44
"""Letters of a row of buttons; where there are more they stand in several rows."""
_DOT_PX = 10


class ChoiceButtons(QWidget):
    """Draws a :class:`ChoiceRow`; hidden without one.

    Signals:
        chosen(int): the number of the option that was clicked.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._options: tuple[str, ...] = ()
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        self._title = quiet("", self)
        self._frame = QFrame(self)
        self._frame.setProperty("track", True)
        self._grid = QGridLayout(self._frame)
        self._grid.setContentsMargins(2, 2, 2, 2)
        self._grid.setSpacing(2)
        self._group = QButtonGroup(self)
        rows.addWidget(self._title)
        rows.addWidget(self._frame, 0, Qt.AlignmentFlag.AlignLeft)
        self.hide()

    def show_scene(self, row: ChoiceRow | None) -> None:
        """Show other options, or that another one is in force."""
        self.setVisible(row is not None)
        if row is None:
            return
        with_key = tr("{0}  ({1})").format(row.title, row.key)
        self._title.setText(with_key if row.key else row.title)
        self._frame.setAccessibleName(row.title)
        if row.options != self._options:
            self._options = row.options
            self._fill()
        self._group.button(row.chosen).setChecked(True)

    def _fill(self) -> None:
        for button in self._group.buttons():
            self._group.removeButton(button)
            self._grid.removeWidget(button)
            button.deleteLater()
        columns = _columns(self._options)
        for number, text in enumerate(self._options):
            button = _segment(text, self._frame)
            button.clicked.connect(lambda _=False, number=number: self.chosen.emit(number))
            self._group.addButton(button, number)
            self._grid.addWidget(button, number // columns, number % columns)


class ProposalChips(QWidget):
    """Draws some :class:`Proposal`; hidden without any.

    Signals:
        chosen(int): the number of the proposal that was clicked.
    """

    chosen = Signal(int)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._proposals: tuple[Proposal, ...] = ()
        self._name = title
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(4)
        self._label = QLabel(title, self) if title else None
        if self._label is not None:
            self._label.setProperty("role", "muted")
            self._row.addWidget(self._label)
        self._row.addStretch(1)
        self._chips: list[QToolButton] = []
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.hide()

    def show_scene(self, proposals: tuple[Proposal, ...]) -> None:
        """Show what was found."""
        self.setVisible(bool(proposals))
        if proposals == self._proposals:
            return
        self._proposals = proposals
        for chip in self._chips:
            self._row.removeWidget(chip)
            chip.deleteLater()
        self._chips = [self._chip(one) for one in proposals]
        for chip in self._chips:
            self._row.insertWidget(self._row.count() - 1, chip)
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Show as many as there is room for."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Leave out the last ones rather than cut one off."""
        room = self.width() - (self._label.sizeHint().width() if self._label is not None else 0)
        for number, chip in enumerate(self._chips):
            room -= chip.sizeHint().width() + self._row.spacing()
            chip.setVisible(number == 0 or room >= 0)

    def _chip(self, proposal: Proposal) -> QToolButton:
        chip = _segment(proposal.text, self)
        chip.setChecked(proposal.chosen)
        chip.setAutoExclusive(True)
        chip.setProperty("chip", True)
        chip.setToolTip(proposal.why)
        spoken = joined_text(" ", filter(None, (self._name, proposal.text, proposal.why)))
        chip.setAccessibleName(spoken)
        if proposal.colour is not None:
            chip.setIcon(_dot(current_theme().track(proposal.colour), self.devicePixelRatioF()))
            chip.setIconSize(QSize(_DOT_PX, _DOT_PX))
            chip.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        chip.clicked.connect(lambda: self.chosen.emit(proposal.number))
        return chip


def _columns(options: tuple[str, ...]) -> int:
    """So many columns that the options fill their rows and none is wider than there is room."""
    count = len(options)
    for columns in (count, -(-count // 2), 2):
        widest = [max(map(_letters, options[at::columns])) + 3 for at in range(columns)]
        if sum(widest) <= _WIDEST_ROW:
            return columns
    return 1


def _letters(text: str) -> int:
    """How wide it is: a letter of East Asia has the room of two."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _segment(text: str, parent: QWidget) -> QToolButton:
    button = QToolButton(parent)
    button.setText(literal(text))
    button.setAccessibleName(text)
    button.setCheckable(True)
    button.setProperty("segment", True)
    button.setProperty("tight", True)
    button.setFont(scaled_font(parent.font(), 0.92))
    button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return button


def _dot(colour: QColor, ratio: float) -> QIcon:
    """A disc in a person's colour."""
    drawn = QPixmap(QSize(_DOT_PX, _DOT_PX) * ratio)
    drawn.setDevicePixelRatio(ratio)
    drawn.fill(Qt.GlobalColor.transparent)
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawEllipse(1, 1, _DOT_PX - 2, _DOT_PX - 2)
    painter.end()
    return QIcon(drawn)
