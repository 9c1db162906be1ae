"""What the picture and the floor have in common: zoom, pan, fit, pick."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QEnterEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QApplication, QToolTip, QWidget

from app.core.drawing.viewport import Viewport
from app.core.look.theme import Theme, current_theme
from app.core.widgets.abstract import AbstractQt

_ZOOM_PER_NOTCH = 1.2
_NOTCH = 120.0
_AS_FITTED = 0.01
"""Share of the scale: zoomed in and out again a view is as good as fitted."""


class Canvas(QWidget, metaclass=AbstractQt):
    """A zoomable drawing of some content.

    The wheel zooms at the cursor, dragging (any place, left or middle button) pans a zoomed view,
    a double click or the key 0 fits, + and - zoom. A click without a drag is given to
    :meth:`clicked_at`; a drag that begins at something that can be moved goes to :meth:`drag_to`.

    Attributes:
        pointed_at: where the mouse is over the widget; None: it is elsewhere.

    Signals:
        menu_asked(int, QPoint): a right click on a track (0: on none), or the menu key (-1: on who
            is selected); where on the screen.
    """

    menu_asked = Signal(int, QPoint)

    def __init__(self, upward: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._viewport = Viewport(upward=upward)
        self._seen_in = QRectF()  # where content was fitted to as the viewport was made
        self._fitted = True
        self._stepped_close = False
        self._before = QRectF()  # what was in sight until then; empty: all
        self._pressed_at: QPoint | None = None
        self._panning = False
        self._holding = False
        self.pointed_at: QPointF | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(160, 96)

    # what a canvas of a kind defines

    @abstractmethod
    def content(self) -> QRectF:
        """The content worth showing, in its own units; empty where there is none."""

    def reach(self) -> QRectF:
        """All of the content, as far as it can be moved to; more than what is worth showing."""
        return self.content()

    @abstractmethod
    def paint(self, painter: QPainter, theme: Theme) -> None:
        """Draw everything but the ground."""

    @abstractmethod
    def clicked_at(self, at: QPointF, extend: bool) -> None:
        """A click without a drag; `extend`: with Shift."""

    @abstractmethod
    def track_at(self, at: QPointF) -> int:
        """The track at a place of the widget; 0 where there is none."""

    @abstractmethod
    def grabs(self, at: QPointF) -> bool:
        """Whether a drag from here moves something rather than the whole content; holds it then."""

    @abstractmethod
    def drag_to(self, at: QPointF) -> None:
        """What is held was dragged to a place of the widget."""

    @abstractmethod
    def drop(self) -> None:
        """What was dragged is let go where it is."""

    @abstractmethod
    def cursor_at(self, at: QPointF) -> Qt.CursorShape:
        """The shape of the cursor while no button is pressed."""

    @abstractmethod
    def name_at(self, at: QPointF) -> str:
        """What the tooltip says at a place of the widget; empty: none."""

    # what they share

    @property
    def viewport(self) -> Viewport:
        """Where content is drawn now."""
        return self._viewport

    @property
    def zoomed_to(self) -> Viewport | None:
        """The view that the user chose; None: the whole content is shown."""
        return None if self._fitted else self._viewport

    def look_at(self, viewport: Viewport) -> None:
        """Show a view that was chosen before."""
        self._look(viewport)

    def fit(self) -> None:
        """Show the whole content, and keep doing so when the widget is resized."""
        self._fitted, self._seen_in = True, self._area()
        self._stepped_close = False
        content = self.content()
        if not content.isEmpty():
            self._viewport = Viewport.fitting(content, self._area(), self._viewport.upward)
        self.update()

    def show_close(self, content: QRectF) -> None:
        """Show a part of the content as large as fits, with as much again around it."""
        around = content.adjusted(
            -content.width(), -content.height() / 2, content.width(), content.height() / 2
        )
        if not self.content().isEmpty() and not around.isEmpty():
            self._look(Viewport.fitting(around, QRectF(self.rect()), self._viewport.upward))

    def step_close(self, content: QRectF) -> None:
        """Show a part of the content as large as fits until `step_back`, or the user looks on."""
        if self.content().isEmpty() or content.isEmpty():
            return
        if not self._stepped_close:
            self._before = QRectF() if self._fitted else self._in_sight()
        self._look(Viewport.fitting(content, self._area(), self._viewport.upward))
        self._stepped_close = True

    def step_back(self) -> None:
        """Show what was in sight before `step_close`, unless the user has moved the view since."""
        if not self._stepped_close:
            return
        self._stepped_close = False
        if self._before.isEmpty():
            self.fit()
        else:
            self._look(Viewport.fitting(self._before, self._area(), self._viewport.upward))

    @property
    def is_close(self) -> bool:
        """Whether a part is shown until `step_back`."""
        return self._stepped_close

    def _in_sight(self) -> QRectF:
        """The part of the content that fills the widget."""
        area = self._area()
        one, other = (self._viewport.to_content(at) for at in (area.topLeft(), area.bottomRight()))
        return QRectF(one, other).normalized()

    def bring_into_view(self, content: QRectF) -> None:
        """Shift a zoomed view so that a part of the content that is not seen whole is."""
        content = content.intersected(self.reach())  # beyond it there is nothing to see
        if content.isEmpty() or (self._fitted and self.content().contains(content)):
            return
        place, area = self._viewport.rect(content), QRectF(self.rect())
        if place.width() > area.width() or place.height() > area.height():
            self.show_close(content)
        elif not area.contains(place):
            self._look(self._viewport.moved(area.center() - place.center()))

    def _area(self) -> QRectF:
        """Where on the widget the content is fitted to."""
        return QRectF(self.rect()).marginsRemoved(self.contentsMargins().toMarginsF())

    def _look(self, viewport: Viewport) -> None:
        """Show a view that the user chose, which shows no ground in place of content."""
        self._fitted, self._seen_in = False, self._area()
        self._viewport = viewport.kept_inside(self.reach(), self._seen_in)
        self.update()

    def zoom(self, factor: float, at: QPointF | None = None) -> None:
        """Enlarge around a point of the widget, its middle where none is given."""
        content = self.content()
        if content.isEmpty():
            return
        self._stepped_close = False
        scale = self._viewport.scale * factor
        whole = Viewport.fitting(content, self._area()).scale
        if abs(scale / whole - 1.0) < _AS_FITTED:
            self.fit()
            return
        widest = 0.1 * min(self.width() / content.width(), self.height() / content.height())
        if widest <= scale <= 400 * widest * 10:
            self._look(self._viewport.zoomed(at or QRectF(self.rect()).center(), factor))

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Large enough to work in."""
        return QSize(560, 420)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Keep the content fitted, or as many times larger than that, its middle in the middle."""
        super().resizeEvent(event)
        if self._fitted:
            self.fit()
        elif not self.content().isEmpty():
            before, now = self._seen_in, self._area()
            fitted, fits = (Viewport.fitting(self.content(), area).scale for area in (before, now))
            moved = self._viewport.moved(now.center() - before.center())
            self._look(moved.zoomed(now.center(), fits / fitted))

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
        """Remember where: a click, the start of a pan, or of something being moved."""
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._pressed_at = event.position().toPoint()
            self._panning = event.button() is Qt.MouseButton.MiddleButton
            self._holding = not self._panning and self.grabs(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Pan, or move what is held, once the mouse has really moved."""
        self.pointed_at = event.position()
        at = event.position().toPoint()
        if self._pressed_at is None:
            self.setCursor(self.cursor_at(event.position()))
            return
        moved = at - self._pressed_at
        if not self._panning and moved.manhattanLength() < QApplication.startDragDistance():
            return
        self._panning = True
        if self._holding:
            self.drag_to(event.position())
            return
        if self._fitted:  # all of it is in sight: a slip of the mouse is no choice of a view
            return
        self._stepped_close = False
        self._look(self._viewport.moved(QPointF(moved)))
        self._pressed_at = at
        self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """A press that moved nothing was a click."""
        if event.button() is Qt.MouseButton.RightButton:
            return
        if self._pressed_at is not None and not self._panning:
            extend = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self.clicked_at(event.position(), extend)
        elif self._panning and self._holding:
            self.drop()
        self._pressed_at = None
        self._panning = self._holding = False
        self.setCursor(self.cursor_at(event.position()))

    def enterEvent(self, event: QEnterEvent) -> None:  # noqa: N802
        """The mouse points here, perhaps without having moved."""
        super().enterEvent(event)
        self.pointed_at = event.position()

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802
        """The mouse points elsewhere."""
        super().leaveEvent(event)
        self.pointed_at = None

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:  # noqa: N802
        """Ask for what can be done to who is under the cursor, or selected."""
        by_key = event.reason() is QContextMenuEvent.Reason.Keyboard
        track = -1 if by_key else self.track_at(QPointF(event.pos()))
        self.menu_asked.emit(track, event.globalPos())
        event.accept()

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
