"""A clear sheet over a picture or the floor on which something is drawn with the mouse."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QEnterEvent, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.core.drawing.canvas import Canvas
from app.core.i18n import tr
from app.core.look.theme import Theme, current_theme
from app.core.widgets.abstract import AbstractQt

Key = Qt.Key
_ENTER = (Key.Key_Return, Key.Key_Enter)


class Layer(QWidget, metaclass=AbstractQt):
    """Covers a canvas while something is drawn on it.

    The left button and the keys of drawing are the layer's; the wheel and the middle button go on
    to the canvas, so that zooming and panning work as ever.

    Signals:
        leave_asked(): Esc, with nothing half drawn.
    """

    leave_asked = Signal()
    keys: tuple[Qt.Key, ...] = (Key.Key_Escape,)

    def __init__(self, canvas: Canvas) -> None:
        super().__init__(canvas)
        self.canvas = canvas
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setCursor(Qt.CursorShape.CrossCursor)
        canvas.installEventFilter(self)
        self.hide()

    # what a layer of a kind defines

    @abstractmethod
    def paint(self, painter: QPainter, theme: Theme) -> None:
        """Draw what is being drawn."""

    @abstractmethod
    def key(self, key: Qt.Key) -> None:
        """One of the layer's keys was pressed."""

    # what they share

    def begin(self) -> None:
        """Cover the canvas and take the keyboard."""
        self.setAccessibleName(tr("Drawing on: {view}", view=self.canvas.accessibleName()))
        self.setGeometry(self.canvas.rect())
        self.show()
        self.raise_()
        self.setFocus()

    def place(self, at: QPointF) -> tuple[float, float]:
        """The content under a point of the widget."""
        place = self.canvas.viewport.to_content(at)
        return place.x(), place.y()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Stay as large as the canvas."""
        if event.type() == QEvent.Type.Resize and watched is self.canvas:
            self.setGeometry(self.canvas.rect())
        return super().eventFilter(watched, event)

    def event(self, event: QEvent) -> bool:
        """Keep the keys of drawing from being shortcuts of the window."""
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() in self.keys
            and not event.modifiers()
        ):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Give the layer its keys; the rest is the canvas's."""
        if event.key() in self.keys and not event.modifiers():
            self.key(Key(event.key()))
            self.update()
        else:
            event.ignore()

    def enterEvent(self, event: QEnterEvent) -> None:  # noqa: N802
        """Take the keyboard: what is pressed now is about what is under the mouse."""
        super().enterEvent(event)
        self.setFocus()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Nothing but what is being drawn."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.paint(painter, current_theme())
        painter.end()


def is_enter(key: Qt.Key) -> bool:
    """Whether a key is one of both that say "done"."""
    return key in _ENTER
