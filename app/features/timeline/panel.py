"""Lanes of people, lanes of errors and overview put together."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Signal
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from app.core.scenes import TimelineScene
from app.features.timeline.error_lanes import ErrorLanesView
from app.features.timeline.overview import OverviewStrip
from app.features.timeline.tracks_area import TracksArea


class TimelineView(QFrame):
    """Draws a :class:`TimelineScene`; only what changed is drawn anew.

    Signals:
        frame_sought(int): a click or drag on ruler, lanes or overview.
        track_picked(int): a click on a lane, 0 beside all. track_added(int): with Shift.
        menu_asked(int, QPoint): a right click on a lane, or the menu key.
        cut_moved(int): the cut of a previewed edit was dragged to a frame.
    """

    frame_sought = Signal(int)
    track_picked = Signal(int)
    track_added = Signal(int)
    menu_asked = Signal(int, QPoint)
    cut_moved = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.area = TracksArea(self)
        self.errors = ErrorLanesView(self)
        self.overview = OverviewStrip(self)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(0)
        rows.addWidget(self.area, 1)
        rows.addWidget(self.errors)
        rows.addWidget(self.overview)
        self.area.stretch.changed.connect(self.overview.show_window)
        self.area.stretch.changed.connect(self.errors.show_axis)
        self.area.frame_sought.connect(self.frame_sought)
        self.area.track_picked.connect(self.track_picked)
        self.area.track_added.connect(self.track_added)
        self.area.menu_asked.connect(self.menu_asked)
        self.area.cut_moved.connect(self.cut_moved)
        self.overview.frame_sought.connect(self.frame_sought)
        self.overview.window_sought.connect(self.area.stretch.centre)
        self.overview.zoomed.connect(self.area.stretch.zoom)
        self._selected: tuple[int, ...] = ()

    def show_scene(self, scene: TimelineScene) -> None:
        """Draw another frame; newly selected tracks are scrolled to, all of them if they fit."""
        self.area.show_scene(scene)
        self.overview.show_scene(scene)
        self.errors.show_playhead(scene.frame)
        selected = tuple(lane.track for lane in scene.lanes if lane.selected)
        if selected != self._selected:
            self._selected = selected
            self.area.reveal(selected)
