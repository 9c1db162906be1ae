"""A panel as high as its content where there is room; where there is not, it scrolls."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QSizePolicy, QVBoxLayout, QWidget

_LEAST_LINES = 8


class ScrolledPanel(QFrame):
    """A frame around `content`, which never makes the window higher than its screen."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Maximum)
        self.content = QWidget(self)
        self._area = QScrollArea(self)
        self._area.setWidget(self.content)
        self._area.setWidgetResizable(True)
        self._area.setFrameShape(QFrame.Shape.NoFrame)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        for ground in (self.content, self._area.viewport()):
            ground.setAutoFillBackground(False)  # the panel's own is seen
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addWidget(self._area)
        self.content.installEventFilter(self)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """As high as the content is at this width."""
        hint, layout = self.content.sizeHint(), self.content.layout()
        edges = self.contentsMargins()
        across, down = edges.left() + edges.right(), edges.top() + edges.bottom()
        if layout is not None and layout.hasHeightForWidth():
            hint.setHeight(layout.totalHeightForWidth(max(self.width() - across, 1)))
        return hint + QSize(across, down)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """As wide as the content; a few lines of it are seen."""
        least = _LEAST_LINES * self.fontMetrics().lineSpacing()
        width = self.content.minimumSizeHint().width()
        return QSize(width, min(least, self.sizeHint().height()))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """At another width words wrap at other places."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """The content needs another height by now."""
        if watched is self.content and event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)
