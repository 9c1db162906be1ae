"""The column of panels at the right, which scrolls on a low screen."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget


class PanelColumn(QScrollArea):
    """As wide as the panels need beside its scroll bar, also once they show more than at first.

    Args:
        panels: what is shown. least_px: the width it has where they need less.
    """

    def __init__(self, panels: QWidget, least_px: int, parent: QWidget) -> None:
        super().__init__(parent)
        self._panels, self._least_px = panels, least_px
        self.setWidget(panels)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # a click on a row leaves the keyboard there
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        panels.installEventFilter(self)

    def minimumSizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """As wide as the panels need; as low as there is room."""
        bar_px = self.verticalScrollBar().sizeHint().width()
        return QSize(max(self._panels.minimumSizeHint().width() + bar_px, self._least_px), 1)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """The panels need another width by now."""
        if watched is self._panels and event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)
