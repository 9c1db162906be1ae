"""The column of panels at the right, which scrolls on a low screen."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
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
        self.setMinimumHeight(1)
        panels.installEventFilter(self)
        self._fit_width()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """The panels need another width by now."""
        if watched is self._panels and event.type() == QEvent.Type.LayoutRequest:
            self._fit_width()
        return super().eventFilter(watched, event)

    def _fit_width(self) -> None:
        needed = (
            self._panels.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width()
        )
        self.setMinimumWidth(max(needed, self._least_px))
