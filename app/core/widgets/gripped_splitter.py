"""A splitter whose border can be seen, and be taken hold of with the mouse."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QEnterEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSplitter, QSplitterHandle, QWidget

from app.core.look.theme import current_theme

_THICKNESS = 7
_DOTS, _APART, _RADIUS = 5, 7.0, 1.25


class GrippedSplitter(QSplitter):
    """A splitter with a bar of some thickness between its parts, and a grip in its middle."""

    def __init__(self, orientation: Qt.Orientation, what: str, parent: QWidget) -> None:
        """what: to be told of the bar under the mouse, e.g. "Drag to make the timeline higher"."""
        super().__init__(orientation, parent)
        self._what = what
        self.setHandleWidth(_THICKNESS)

    def restoreState(self, state: QByteArray | bytes | bytearray | memoryview) -> bool:  # noqa: N802
        """As Qt's, but for the thickness, which a state kept by an older program has as well."""
        restored = super().restoreState(state)
        self.setHandleWidth(_THICKNESS)
        return restored

    def createHandle(self) -> QSplitterHandle:  # noqa: N802 - Qt's name
        """A bar with a grip."""
        return _Grip(self.orientation(), self, self._what)


class _Grip(QSplitterHandle):
    """Dots in the middle of the bar; the bar lights up under the mouse."""

    def __init__(self, orientation: Qt.Orientation, splitter: QSplitter, what: str) -> None:
        super().__init__(orientation, splitter)
        self._hovered = False
        self.setToolTip(what)
        self.setAccessibleName(what)

    def enterEvent(self, event: QEnterEvent) -> None:  # noqa: N802 - Qt's name
        """The mouse may take hold of it."""
        self._hovered = True
        self.update()
        super().enterEvent(event)

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802
        """No longer."""
        self._hovered = False
        self.update()
        super().leaveEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """The bar, a line at both of its edges, and the dots."""
        theme, painter = current_theme(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect())
        lies = self.orientation() is Qt.Orientation.Vertical  # the parts stand one below the other
        painter.fillRect(area, theme.accent_fill if self._hovered else theme.window)
        edges = (
            (QRectF(0, 0, area.width(), 1), QRectF(0, area.height() - 1, area.width(), 1))
            if lies
            else (QRectF(0, 0, 1, area.height()), QRectF(area.width() - 1, 0, 1, area.height()))
        )
        for edge in edges:
            painter.fillRect(edge, theme.line)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.accent_text if self._hovered else theme.text_muted)
        for dot in range(_DOTS):
            along = (dot - (_DOTS - 1) / 2) * _APART
            middle = area.center() + (QPointF(along, 0) if lies else QPointF(0, along))
            painter.drawEllipse(middle, _RADIUS, _RADIUS)
        painter.end()
