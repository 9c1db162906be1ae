"""Where the panels stand: at the right, below the floor, or in windows of their own."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from functools import partial

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QCloseEvent, QKeyEvent
from PySide6.QtWidgets import QMenu, QSplitter, QToolButton, QVBoxLayout, QWidget

from app.core.i18n import N_, tr
from app.core.look.icons import IconButton
from app.core.widgets.parts import Panel
from app.core.widgets.user_settings import UserSettings
from app.shell.below_floor import BelowFloor
from app.shell.screen_fit import keep_on_screen

_AROUND_PX = 13
"""Around an icon in a button; Qt adds room for an arrow where there is a menu."""


class Dock(Enum):
    """A place for panels, with what the menu of a panel calls it."""

    SIDE = N_("At the right")
    BELOW = N_("Below the floor")
    WINDOW = N_("In a window of its own")


class PanelWindow(QWidget):
    """A window that holds one panel; closing it puts the panel back where it was.

    Signals: `left()`: it was closed.
    """

    left = Signal()

    def __init__(self, panel: Panel, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Tool)
        self.setWindowTitle(panel.accessibleName())
        self.inside = QVBoxLayout(self)
        self.inside.setContentsMargins(0, 0, 0, 0)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """What the panel makes nothing of is for the window that it belongs to."""
        window = self.parentWidget()
        if window is not None:
            QCoreApplication.sendEvent(window, event)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        """The panel goes back."""
        event.ignore()
        self.left.emit()


class PanelDocks(QObject):
    """Moves panels between their places, and opens and closes those that no feature does.

    A panel is open while it is not hidden, wherever it stands.

    Signals:
        changed(): a panel was moved, opened or closed.
        close_asked(str): the panel of this id is to be closed.
    """

    changed = Signal()
    close_asked = Signal(str)

    def __init__(
        self,
        panels: Mapping[str, tuple[Panel, Dock]],
        side: QSplitter,
        below: BelowFloor,
        parent: QWidget,
    ) -> None:
        """panels: by id, in their order, each with the place where it stands at first."""
        super().__init__(parent)
        self.panels = {name: panel for name, (panel, _) in panels.items()}
        self._first = {name: dock for name, (_, dock) in panels.items()}
        self._docked: dict[str, Dock] = {}
        self._stands: dict[str, Dock] = {}
        self._windows: dict[str, PanelWindow] = {}
        self._side, self._below, self._page = side, below, parent
        parent.installEventFilter(self)
        for name, panel in self.panels.items():
            panel.installEventFilter(self)
            _add_menu(panel, partial(self._fill_menu, name))
            self._put(name, self._first[name])

    def stands(self, name: str) -> Dock:
        """Where a panel is now."""
        return self._stands[name]

    def is_open(self, name: str) -> bool:
        """Whether a panel is open."""
        return not self.panels[name].isHidden()

    def set_open(self, name: str, is_open: bool) -> None:
        """Open or close a panel."""
        self.panels[name].setVisible(is_open)

    def move(self, name: str, dock: Dock) -> None:
        """Put a panel elsewhere."""
        if self._stands[name] is not dock:
            self._put(name, dock)
            self.changed.emit()

    def return_docked(self, name: str) -> None:
        """Put a panel back into the window, where it stood last."""
        self.move(name, self._docked[name])

    def with_keyboard(self, focused: QWidget | None) -> str:
        """The panel that has the keyboard; "" for none."""
        inside = (
            name
            for name, panel in self.panels.items()
            if focused is not None and (panel is focused or panel.isAncestorOf(focused))
        )
        return next(inside, "")

    def at(self, dock: Dock) -> tuple[Panel, ...]:
        """The panels that stand in a place, in their order."""
        return tuple(panel for name, panel in self.panels.items() if self._stands[name] is dock)

    def any_open(self, dock: Dock) -> bool:
        """Whether a panel is open in a place."""
        return any(not panel.isHidden() for panel in self.at(dock))

    @property
    def _always_there(self) -> tuple[str, ...]:
        """Panels that no recording opens and closes."""
        return tuple(name for name, dock in self._first.items() if dock is Dock.SIDE)

    def reset(self) -> None:
        """Put every panel where it stood at first."""
        for name, dock in self._first.items():
            self.move(name, dock)

    def remember(self, remembered: UserSettings) -> None:
        """Keep where the panels stand."""
        for name, dock in self._stands.items():
            remembered.set_text(f"panels/{name}", dock.name)
        for name in self._always_there:
            remembered.set_text(f"panels/{name} closed", "" if self.is_open(name) else "closed")
        for name, window in self._windows.items():
            remembered.set_state(f"panels/{name} window", window.saveGeometry())

    def restore(self, remembered: UserSettings) -> None:
        """Put the panels where they stood, and leave those closed that were."""
        for name in self._always_there:
            self.set_open(name, not remembered.text(f"panels/{name} closed"))
        for name in self.panels:
            kept = remembered.text(f"panels/{name}")
            if kept in Dock.__members__:
                self.move(name, Dock[kept])
            geometry = remembered.state(f"panels/{name} window")
            if geometry is not None and name in self._windows:
                self._windows[name].restoreGeometry(geometry)
                keep_on_screen(self._windows[name])

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """A window is there while its panel is open, and the page that the panels belong to."""
        kinds = (QEvent.Type.ShowToParent, QEvent.Type.HideToParent)
        if watched is self._page:
            if event.type() in (QEvent.Type.Show, QEvent.Type.HideToParent):
                for name in self._windows:
                    self._show_window(name)
        elif event.type() in kinds:
            name = next((name for name, panel in self.panels.items() if panel is watched), "")
            if name in self._windows:
                self._show_window(name)
            if name:
                self.changed.emit()
        return super().eventFilter(watched, event)

    def _show_window(self, name: str) -> None:
        """Show or hide it; one shown before the window it belongs to would lie behind that."""
        self._windows[name].setVisible(self.is_open(name) and self._page.isVisible())

    def _put(self, name: str, dock: Dock) -> None:
        panel, was_open = self.panels[name], self.is_open(name)
        self._take_out(name)
        self._stands[name] = dock
        if dock is Dock.WINDOW:
            self._windows[name] = window = PanelWindow(panel, self._side.window())
            window.left.connect(partial(self.return_docked, name))
            window.inside.addWidget(panel)
            window.resize(window.sizeHint().expandedTo(panel.minimumSizeHint()))
        else:
            self._docked[name] = dock
        if dock is Dock.SIDE:
            order = [one for one in self.panels if self._stands.get(one) is Dock.SIDE]
            self._side.insertWidget(order.index(name), panel)
        panel.setVisible(was_open)
        if dock is Dock.BELOW:
            self._below.add(panel)
        if dock is Dock.WINDOW:
            self._show_window(name)

    def _take_out(self, name: str) -> None:
        if self._stands.get(name) is Dock.BELOW:
            self._below.remove(self.panels[name])
        if name in self._windows:
            window = self._windows.pop(name)
            self.panels[name].setParent(self._side)
            window.hide()
            window.deleteLater()

    def _fill_menu(self, name: str, menu: QMenu) -> None:
        menu.clear()
        group = QActionGroup(menu)
        for dock in Dock:
            action = QAction(tr(dock.value), menu)
            action.setCheckable(True)
            action.setChecked(self._stands[name] is dock)
            action.triggered.connect(lambda _=False, dock=dock: self.move(name, dock))
            group.addAction(action)
            menu.addAction(action)
        menu.addSeparator()
        menu.addAction(tr("Close")).triggered.connect(lambda: self.close_asked.emit(name))


def _add_menu(panel: Panel, fill: partial[None]) -> None:
    """A button at the panel's head that says where it may stand."""
    button = IconButton("more", tr("Move or close this panel"), parent=panel)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    menu = QMenu(button)
    menu.aboutToShow.connect(partial(fill, menu))
    button.setMenu(menu)
    button.setProperty("plain", True)
    button.setMaximumWidth(button.iconSize().width() + _AROUND_PX)
    panel.set_menu(button)
