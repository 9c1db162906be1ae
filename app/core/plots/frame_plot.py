"""Plots over the frames that the timeline's lanes show, with the same playhead."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.core.look.theme import Theme, current_theme, scaled_font
from app.core.plots.axis import TimeAxis, ticks
from app.core.widgets.abstract import AbstractQt
from app.core.widgets.still_picture import StillPicture

_TICK_LETTERS = 11
_SMALL = 0.86
_EDGE = 12.0


class FramePlot(QWidget, metaclass=AbstractQt):
    """What stays is drawn once and kept; over it moves the playhead, and a click seeks.

    Signals:
        frame_sought(int): a click or a drag.
    """

    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown = TimeAxis(0.0, 1.0, 0.0, 1.0, 1)
        self._still = StillPicture(self)
        self._playhead = 0
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    # what a plot of a kind defines

    @property
    @abstractmethod
    def has_curves(self) -> bool:
        """Whether there is something to seek in."""

    @abstractmethod
    def names_width(self, metrics: QFontMetricsF) -> float:
        """How wide what stands at the left of the plots is."""

    @abstractmethod
    def draw_still(self, painter: QPainter, theme: Theme) -> None:
        """Draw all but the playhead; the painter has the small font."""

    # what they share

    @property
    def axis(self) -> TimeAxis:
        """Where frames are drawn."""
        metrics = QFontMetricsF(scaled_font(self.font(), _SMALL))
        left = self.names_width(metrics) + 16
        return self._shown.resized(left, self.width() - left - _EDGE)

    def show_axis(self, axis: TimeAxis) -> None:
        """Show the frames the timeline's lanes show."""
        self._shown = axis
        self.draw_anew()

    def show_playhead(self, frame: int) -> None:
        """Put the playhead into another frame."""
        self._playhead = frame
        self.update()

    def draw_anew(self) -> None:
        """The curves are others."""
        self._still.forget()
        self.update()

    def draw_times(self, painter: QPainter, foot: float, fps: float, theme: Theme) -> None:
        """Round times under the plots, on a line `foot` high."""
        axis = self.axis
        painter.setPen(theme.text_muted)
        least = _TICK_LETTERS * QFontMetricsF(painter.font()).averageCharWidth()
        for frame, text in ticks(axis, fps, least):
            at = QRectF(axis.x_of(frame) - least / 2, self.height() - foot, least, foot)
            if at.left() >= axis.left and at.right() <= self.width():
                painter.drawText(at, Qt.AlignmentFlag.AlignCenter, text)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802 - Qt's name
        """The curves from their picture, then the playhead."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.surface, lambda still: self._draw_small(still, theme))
        axis = self.axis
        x = axis.x_of(self._playhead + 0.5)
        if self.has_curves and axis.left <= x <= axis.left + axis.width:
            painter.setPen(QPen(theme.accent, 1.6))
            painter.drawLine(QLineF(x, 0, x, self.height()))
        painter.end()

    def _draw_small(self, painter: QPainter, theme: Theme) -> None:
        painter.setFont(scaled_font(self.font(), _SMALL))
        self.draw_still(painter, theme)

    # gestures

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go to the frame under the mouse."""
        self._seek(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on with the button held."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event.position())

    def _seek(self, at: QPointF) -> None:
        if self.has_curves and at.x() >= self.axis.left:
            self.frame_sought.emit(self.axis.frame_at(at.x()))

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self.draw_anew()
