"""Which part of the window has the keyboard, shown while it is walked to by keys."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QApplication, QWidget

from app.core.look.theme import current_theme

_WIDTH_PX = 3


class PaneRing(QWidget):
    """A ring over a part of the window; it goes once the keyboard is elsewhere."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._parent = parent
        self._pane: QWidget | None = None
        self._around: list[QWidget] = []
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)
        self.hide()

    @property
    def pane(self) -> QWidget | None:
        """What it lies around; None while it is not shown."""
        return self._pane

    def show_around(self, pane: QWidget) -> None:
        """Lie around a part, which has the keyboard."""
        self._leave()
        self._pane = pane
        if pane.window() is not self._parent.window() or not self._parent.isAncestorOf(pane):
            self._parent = pane.window()
            self.setParent(self._parent)
        step: QWidget | None = pane
        while step is not None and step is not self._parent:
            step.installEventFilter(self)
            self._around.append(step)
            step = step.parentWidget()
        self._fit()
        self.show()
        self.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Stay around the part wherever it, or what it lies in, is moved."""
        if watched in self._around and event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self._fit()
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Nothing but the ring."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(current_theme().accent, _WIDTH_PX))
        half = _WIDTH_PX // 2 + 1
        painter.drawRoundedRect(self.rect().adjusted(half, half, -half, -half), 4, 4)
        painter.end()

    def _fit(self) -> None:
        if self._pane is not None:
            seen = self._pane.visibleRegion().boundingRect() & self._pane.rect()
            corner = self._pane.mapTo(self._parent, seen.topLeft())
            self.setGeometry(QRect(corner, seen.size()) & self._parent.rect())

    def _follow(self, _: QWidget | None, now: QWidget | None) -> None:
        pane = self._pane
        if pane is not None and not (now is pane or (now is not None and pane.isAncestorOf(now))):
            self._leave()

    def _leave(self) -> None:
        for widget in self._around:
            widget.removeEventFilter(self)
        self._around = []
        self._pane = None
        self.hide()
