"""The buttons in the timeline's corner: closer, farther, what to fit, and which lanes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QMenu, QToolButton, QWidget

from app.core.i18n import tr
from app.core.look.icons import IconButton
from app.core.widgets.user_settings import UserSettings
from app.features.timeline.rows import Arrangement, LaneHeight, LaneOrder

_ICON_PX, _BUTTON_PX = 16, 24
_STYLE = "QToolButton { padding: 2px; } QToolButton::menu-indicator { image: none; }"
_Choice = TypeVar("_Choice")


class TimelineControls(QWidget):
    """A row of small buttons; where there is no room for all, the last ones are in the menu only.

    Signals:
        zoomed(float): closer by a factor. fit_all(), fit_selected(), fit_second(): what to show.
        arranged(object): another :class:`Arrangement` was chosen.
    """

    zoomed = Signal(float)
    fit_all = Signal()
    fit_selected = Signal()
    fit_second = Signal()
    arranged = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._arrangement = Arrangement()
        self.menu = QMenu(self)
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(6, 0, 2, 0)
        self._row.setSpacing(0)
        self._menu_button()
        self._buttons = [
            self._button(
                "zoom-out", tr("Zoom out"), "view.time_out", lambda: self.zoomed.emit(0.5)
            ),
            self._button("zoom-in", tr("Zoom in"), "view.time_in", lambda: self.zoomed.emit(2.0)),
            self._button("fit-width", tr("Whole recording"), "view.time_all", self.fit_all.emit),
            self._button(
                "fit-track", tr("Selected track"), "view.time_selected", self.fit_selected.emit
            ),
            self._button(
                "playhead",
                tr("A second around the playhead"),
                "view.time_second",
                self.fit_second.emit,
            ),
        ]
        self._row.addStretch(1)
        self._fill_menu()

    @property
    def arrangement(self) -> Arrangement:
        """What is chosen."""
        return self._arrangement

    def arrange(self, arrangement: Arrangement) -> None:
        """Choose another arrangement of lanes."""
        if arrangement != self._arrangement:
            self._arrangement = arrangement
            self._check_actions()
            self.arranged.emit(arrangement)

    def remember(self, remembered: UserSettings) -> None:
        """Keep the order and the height of lanes; which are sifted out is of the moment."""
        remembered.set_text("timeline/order", self._arrangement.order.name)
        remembered.set_text("timeline/height", self._arrangement.height.name)

    def restore(self, remembered: UserSettings) -> None:
        """Arrange lanes as they were at the last start; what is no choice any more is left."""
        order, height = remembered.text("timeline/order"), remembered.text("timeline/height")
        arrangement = self._arrangement
        if order in LaneOrder.__members__:
            arrangement = replace(arrangement, order=LaneOrder[order])
        if height in LaneHeight.__members__:
            arrangement = replace(arrangement, height=LaneHeight[height])
        self.arrange(arrangement)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Hide the buttons there is no room for."""
        super().resizeEvent(event)
        room = (self.width() - 8) // _BUTTON_PX - 1
        for at, button in enumerate(self._buttons):
            button.setVisible(at < room)

    def _menu_button(self) -> None:
        button = self._small(IconButton("lanes", tr("Lanes and zoom"), parent=self))
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setMenu(self.menu)

    def _button(self, drawing: str, name: str, command: str, act: Callable[[], None]) -> IconButton:
        button = self._small(IconButton(drawing, name, command, self))
        button.clicked.connect(act)
        self.menu.addAction(name).triggered.connect(act)
        return button

    def _small(self, button: IconButton) -> IconButton:
        button.setIconSize(QSize(_ICON_PX, _ICON_PX))
        button.setFixedSize(_BUTTON_PX, _BUTTON_PX)
        button.setStyleSheet(_STYLE)
        self._row.addWidget(button, 0, Qt.AlignmentFlag.AlignVCenter)
        return button

    def _fill_menu(self) -> None:
        self._orders = self._choices(
            tr("Order of lanes"),
            {
                LaneOrder.FIRST_FRAME: tr("By first frame"),
                LaneOrder.NUMBER: tr("By number"),
            },
            lambda chosen: replace(self._arrangement, order=chosen),
        )
        self._heights = self._choices(
            tr("Height of lanes"),
            {
                LaneHeight.LOW: tr("Low, without names"),
                LaneHeight.MIDDLE: tr("Middle"),
                LaneHeight.HIGH: tr("High"),
            },
            lambda chosen: replace(self._arrangement, height=chosen),
        )
        self.menu.addSection(tr("Lanes shown"))
        self._sifted = self.menu.addAction(tr("Only tracks in the frames shown"))
        self._sifted.setCheckable(True)
        self._sifted.toggled.connect(
            lambda on: self.arrange(replace(self._arrangement, in_view_only=on))
        )
        self._check_actions()

    def _choices(
        self, title: str, texts: dict[_Choice, str], chosen: Callable[[_Choice], Arrangement]
    ) -> dict[_Choice, QAction]:
        self.menu.addSection(title)
        group, actions = QActionGroup(self), {}
        for choice, text in texts.items():
            action = self.menu.addAction(text)
            action.setCheckable(True)
            group.addAction(action)
            action.triggered.connect(lambda _, one=choice: self.arrange(chosen(one)))
            actions[choice] = action
        return actions

    def _check_actions(self) -> None:
        self._orders[self._arrangement.order].setChecked(True)
        self._heights[self._arrangement.height].setChecked(True)
        self._sifted.setChecked(self._arrangement.in_view_only)
