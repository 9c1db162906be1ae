"""Panels that share a place: one at a time, so that each has room, and so has what is beside."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import (
    QFrame,
    QScrollArea,
    QStackedWidget,
    QStyle,
    QTabBar,
    QVBoxLayout,
    QWidget,
)

_MOST_LETTERS, _MOST_LINES = 29, 14
"""The least size of a panel is never more; what is larger can be scrolled there."""


class _Page(QScrollArea):
    """A panel that scrolls in a small window, and never makes it larger."""

    def __init__(self, panel: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self.panel = panel
        self.setWidget(panel)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        panel.installEventFilter(self)

    def minimumSizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """The panel's, but no larger than a small window has room for."""
        letters = self.fontMetrics()
        most = QSize(
            _MOST_LETTERS * letters.averageCharWidth(), _MOST_LINES * letters.lineSpacing()
        )
        return self.needed.boundedTo(most) + QSize(self._bar_px, 0)

    @property
    def needed(self) -> QSize:
        """The least size in which the panel need not be scrolled."""
        return self.panel.minimumSizeHint().expandedTo(self.panel.minimumSize())

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """The panel's, beside a scroll bar: what is too high is not also too wide."""
        return self.panel.sizeHint() + QSize(self._bar_px, 0)

    @property
    def _bar_px(self) -> int:
        """How wide a scroll bar is."""
        return self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollBarExtent, None, self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """The panel needs another size by now."""
        if watched is self.panel and event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)


class BelowFloor(QWidget):
    """Shows the panel that was opened last, and tabs where more than one is open.

    Panels open and close themselves, by being shown and hidden; the place is hidden while none is
    open.
    """

    def __init__(self, name: str, panels: Sequence[QWidget], parent: QWidget | None = None) -> None:
        """name: of its tabs, as screen readers say it."""
        super().__init__(parent)
        self._pages: dict[QWidget, _Page] = {}
        self._open: list[QWidget] = []
        self._tabs = QTabBar(self)
        self._tabs.setDrawBase(False)
        self._tabs.setExpanding(False)
        self._tabs.setAccessibleName(name)
        self._tabs.currentChanged.connect(self._show_tab)
        self._stack = QStackedWidget(self)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._tabs)
        column.addWidget(self._stack, 1)
        self._tabs.hide()
        self.hide()
        for panel in panels:
            self.add(panel)

    def add(self, panel: QWidget) -> None:
        """One more panel stands here; it is shown if it is open."""
        is_open = not panel.isHidden()
        page = self._pages[panel] = _Page(panel, self)
        self._stack.addWidget(page)
        panel.setVisible(is_open)
        panel.installEventFilter(self)
        if is_open and panel not in self._open:
            self._begin(panel)

    def remove(self, panel: QWidget) -> None:
        """A panel stands here no longer; whoever takes it gives it another parent."""
        panel.removeEventFilter(self)
        if panel in self._open:
            self._end(panel)
        page = self._pages.pop(panel)
        page.takeWidget()
        self._stack.removeWidget(page)
        page.deleteLater()

    def holds_open(self, panel: QWidget) -> bool:
        """Whether a panel is open here, also behind another one."""
        return panel in self._open

    def bring_forward(self, panel: QWidget) -> None:
        """Show a panel that is open here."""
        if panel in self._open:
            self._tabs.setCurrentIndex(self._open.index(panel))

    @property
    def needed_px(self) -> int:
        """The width that the panel shown would like to have; 0 while none is open."""
        page = self._stack.currentWidget()
        return page.sizeHint().width() if self._open and isinstance(page, _Page) else 0

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow panels that open and close."""
        if isinstance(watched, QWidget) and watched in self._pages:
            if event.type() is QEvent.Type.ShowToParent and watched not in self._open:
                self._begin(watched)
            elif event.type() is QEvent.Type.HideToParent and watched in self._open:
                self._end(watched)
        return super().eventFilter(watched, event)

    def _begin(self, panel: QWidget) -> None:
        self._open.append(panel)
        self._tabs.addTab(panel.accessibleName())
        self._tabs.setCurrentIndex(len(self._open) - 1)
        self._lay_out()

    def _end(self, panel: QWidget) -> None:
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
            self._stack.setCurrentWidget(self._pages[self._open[at]])
