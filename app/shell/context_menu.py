"""The menu of a right click on a person: what can be done to them, with its keys."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QPoint
from PySide6.QtWidgets import QMenu

from app.core.i18n import tr

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

Offered = str | tuple[str, str]
"""A command, a line, or a submenu of a menu."""
_LINE: Final = ""
_OF_PERSON: Final[tuple[Offered, ...]] = (
    "tracks.swap",
    "tracks.split",
    "tracks.merge",
    "tracks.reassign",
    _LINE,
    ("Correct", "Delete"),
    ("Correct", "Draw and move"),
    ("Correct", "Keyframes and gaps"),
    ("Correct", "Mark as"),
    _LINE,
    "tracks.rename",
    "tracks.attributes",
    "tracks.notes",
    _LINE,
    "tracks.to_start",
    "tracks.to_end",
)
_OF_NOBODY: Final[tuple[Offered, ...]] = (
    "tracks.new",
    _LINE,
    "tracks.range_start",
    "tracks.range_end",
    "tracks.no_range",
    _LINE,
    "edit.undo",
    "edit.redo",
)
_OF_EDIT: Final[tuple[Offered, ...]] = (
    "tracks.confirm",
    "tracks.scope",
    "tracks.way",
    _LINE,
    "tracks.none",
)


class ContextMenu(QObject):
    """Opens over the pictures, the floor and the timeline of one window."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.menu: QMenu | None = None
        view = window.workspace
        for place in (view.left, view.right, view.overhead, view.timeline):
            place.menu_asked.connect(self.open)

    def open(self, track: int, at: QPoint) -> None:
        """Select who was clicked (-1: who is selected already) and offer what can be done."""
        controller = self._window.controller
        if controller is None:
            return
        waiting = controller.document.flow is not None
        if not waiting and track >= 0 and track not in controller.document.selection.all:
            controller.editing.pick(track)
        names = _OF_PERSON if controller.document.selection else _OF_NOBODY
        self._window.bring_up_to_date()
        self._fill(_OF_EDIT if waiting else names).popup(at)

    def _fill(self, offered: tuple[Offered, ...]) -> QMenu:
        menu, menus = QMenu(self._window), self._window.menus
        menu.setAccessibleName(tr("What can be done here"))
        menu.installEventFilter(menus)
        for one in offered:
            if isinstance(one, tuple):
                # Not addMenu: that makes the menu bar's own submenu this menu's, to die with it.
                menu.addAction(menus.menus[one].menuAction())
            elif one == _LINE:
                menu.addSeparator()
            else:
                menu.addAction(menus.actions[one])
        menu.aboutToHide.connect(menu.deleteLater)
        menu.destroyed.connect(self._forget)
        self.menu = menu
        return menu

    def _forget(self) -> None:
        self.menu = None
