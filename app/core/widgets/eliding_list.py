"""A list to choose from whose chosen words end in an ellipsis where they have no room."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import (
    QComboBox,
    QSizePolicy,
    QStyle,
    QStyleOptionComboBox,
    QStylePainter,
    QWidget,
)

_LEAST_LETTERS = 10


class ElidingList(QComboBox):
    """As narrow as it is made; the tooltip says what it is for and all of what is chosen."""

    def __init__(self, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._name = name
        self.setAccessibleName(name)
        self.setToolTip(name)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setMinimumWidth(_LEAST_LETTERS * self.fontMetrics().averageCharWidth())
        self.currentTextChanged.connect(self._tell)

    def take_room(self) -> None:
        """Be as wide as its longest entry where there is room for that."""
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def _tell(self, text: str) -> None:
        self.setToolTip(f"{self._name}\n{text}" if text else self._name)

    def _option(self) -> QStyleOptionComboBox:
        """What is drawn: the words that have room."""
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        kind, part = QStyle.ComplexControl.CC_ComboBox, QStyle.SubControl.SC_ComboBoxEditField
        room = self.style().subControlRect(kind, option, part, self).width()
        letters = self.fontMetrics()
        space = letters.averageCharWidth()  # which styles keep free beside the words
        elided = Qt.TextElideMode.ElideRight
        option.currentText = letters.elidedText(self.currentText(), elided, room - space)
        return option

    def shown_text(self) -> str:
        """The words of the chosen entry as they are drawn."""
        return self._option().currentText

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        """Draw the box and the words that have room."""
        del event
        painter, option = QStylePainter(self), self._option()
        painter.drawComplexControl(QStyle.ComplexControl.CC_ComboBox, option)
        painter.drawControl(QStyle.ControlElement.CE_ComboBoxLabel, option)
