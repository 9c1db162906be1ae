"""Panels that share a place: one at a time, so that each has room, and so has what is beside."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QStackedWidget, QTabBar, QVBoxLayout, QWidget


class BelowFloor(QWidget):
    """Shows the panel that was opened last, and tabs where more than one is open.

    Panels open and close themselves, by being shown and hidden; the place is hidden while none is
    open.
    """

    def __init__(self, name: str, panels: Sequence[QWidget], parent: QWidget | None = None) -> None:
        """name: of its tabs, as screen readers say it."""
        super().__init__(parent)
        self._panels = list(panels)
        self._open: list[QWidget] = []
        self._tabs = QTabBar(self)
        self._tabs.setDrawBase(False)
        self._tabs.setExpanding(False)
        self._tabs.setAccessibleName(name)
        self._tabs.currentChanged.connect(self._show_tab)
        self._pages = QStackedWidget(self)
        for panel in self._panels:
            page = QWidget(self)
            inside = QVBoxLayout(page)
            inside.setContentsMargins(0, 0, 0, 0)
            inside.addWidget(panel)
            self._pages.addWidget(page)
            panel.installEventFilter(self)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._tabs)
        column.addWidget(self._pages, 1)
        self._tabs.hide()
        self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow panels that open and close."""
        if isinstance(watched, QWidget) and watched in self._panels:
            if event.type() is QEvent.Type.ShowToParent and watched not in self._open:
                self._add(watched)
            elif event.type() is QEvent.Type.HideToParent and watched in self._open:
                self._remove(watched)
        return super().eventFilter(watched, event)

    def _add(self, panel: QWidget) -> None:
        self._open.append(panel)
        self._tabs.addTab(panel.accessibleName())
        self._tabs.setCurrentIndex(len(self._open) - 1)
        self._lay_out()

    def _remove(self, panel: QWidget) -> None:
        at = self._open.index(panel)
        self._open.remove(panel)
        self._tabs.removeTab(at)
        self._lay_out()

    def _lay_out(self) -> None:
        self._show_tab(self._tabs.currentIndex())
        self._tabs.setVisible(len(self._open) > 1)
        self.setVisible(bool(self._open))

    def _show_tab(self, at: int) -> None:
        if 0 <= at < len(self._open):
            self._pages.setCurrentIndex(self._panels.index(self._open[at]))
