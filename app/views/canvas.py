"""What the picture and the floor have in common: zoom, pan, fit, pick."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QApplication, QToolTip, QWidget

from app.views.theme import Theme, current_theme
from app.views.viewport import Viewport

_ZOOM_PER_NOTCH = 1.2
_NOTCH = 120.0


class Canvas(QWidget):
    """A zoomable drawing of some content.

    The wheel zooms at the cursor, dragging (any place, left or middle button) pans, a double
    click or the key 0 fits, + and - zoom. A click without a drag is given to :meth:`clicked_at`.
    """

    def __init__(self, upward: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._viewport = Viewport(upward=upward)
        self._fitted = True
        self._pressed_at: QPoint | None = None
        self._panning = False
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(160, 120)

    # what a canvas of a kind defines

    def content(self) -> QRectF:
        """The content worth showing, in its own units; empty where there is none."""
        raise NotImplementedError

    def paint(self, painter: QPainter, theme: Theme) -> None:
        """Draw everything but the ground."""
        raise NotImplementedError

    def clicked_at(self, at: QPointF) -> None:
        """A click without a drag."""
        raise NotImplementedError

    def name_at(self, at: QPointF) -> str:
        """What the tooltip says at a place of the widget; empty: none."""
        raise NotImplementedError

    # what they share

    @property
    def viewport(self) -> Viewport:
        """Where content is drawn now."""
        return self._viewport

    def fit(self) -> None:
        """Show the whole content, and keep doing so when the widget is resized."""
        self._fitted = True
        content = self.content()
        if not content.isEmpty():
            area = QRectF(self.rect()).marginsRemoved(self.contentsMargins().toMarginsF())
            self._viewport = Viewport.fitting(content, area, self._viewport.upward)
        self.update()

    def zoom(self, factor: float, at: QPointF | None = None) -> None:
        """Enlarge around a point of the widget, its middle where none is given."""
        content = self.content()
        if content.isEmpty():
            return
        scale = self._viewport.scale * factor
        widest = 0.1 * min(self.width() / content.width(), self.height() / content.height())
        if widest <= scale <= 400 * widest * 10:
            self._fitted = False
            self._viewport = self._viewport.zoomed(at or QRectF(self.rect()).center(), factor)
            self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Large enough to work in."""
        return QSize(560, 420)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Keep the content fitted, or its middle in the middle."""
        super().resizeEvent(event)
        if self._fitted:
            self.fit()
        elif event.oldSize().isValid():
            grown = event.size() - event.oldSize()
            self._viewport = self._viewport.moved(QPointF(grown.width() / 2, grown.height() / 2))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """Ground, then content."""
        theme = current_theme()
        painter = QPainter(self)
        painter.fillRect(event.rect(), theme.sunken)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.paint(painter, theme)
        painter.end()

    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802
        """Zoom at the cursor."""
        self.zoom(_ZOOM_PER_NOTCH ** (event.angleDelta().y() / _NOTCH), event.position())
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Remember where: a click or the start of a pan."""
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._pressed_at = event.position().toPoint()
            self._panning = event.button() is Qt.MouseButton.MiddleButton

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Pan once the mouse has really moved."""
        at = event.position().toPoint()
        if self._pressed_at is None:
            over = self.name_at(event.position())
            self.setCursor(
                Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor
            )
            return
        moved = at - self._pressed_at
        if self._panning or moved.manhattanLength() >= QApplication.startDragDistance():
            self._panning = True
            self._fitted = False
            self._viewport = self._viewport.moved(QPointF(moved))
            self._pressed_at = at
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """A press that did not pan was a click."""
        if self._pressed_at is not None and not self._panning:
            self.clicked_at(event.position())
        self._pressed_at = None
        self._panning = False
        self.unsetCursor()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Show everything."""
        if event.button() is Qt.MouseButton.LeftButton:
            self.fit()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Zoom without a wheel."""
        factor = {"+": _ZOOM_PER_NOTCH, "=": _ZOOM_PER_NOTCH, "-": 1 / _ZOOM_PER_NOTCH}
        if event.text() in factor:
            self.zoom(factor[event.text()])
        elif event.text() == "0":
            self.fit()
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        """Tell who is under the cursor."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            name = self.name_at(QPointF(event.pos()))
            if name:
                QToolTip.showText(event.globalPos(), name, self)
            else:
                QToolTip.hideText()
            return True
        return super().event(event)
