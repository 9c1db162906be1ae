"""Mouse and keys on the lanes: seek, pick, pan, zoom, move a cut."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent

if TYPE_CHECKING:
    from app.features.timeline.tracks_area import TracksArea

_NOTCH = 120.0
_ZOOM_PER_NOTCH = 1.25
_PAN_PER_NOTCH = 0.1  # of the frames shown
_LANES_PER_NOTCH = 3
_CUT_REACH_PX = 5


class Gestures:
    """What the mouse does to one area of lanes.

    The left button seeks and picks, with Shift it picks one more; the middle one, or the left one
    with Ctrl, drags the lanes along. The wheel zooms; over the names or with Shift it scrolls the
    lanes, with Ctrl it pans.
    """

    def __init__(self, area: TracksArea) -> None:
        self._area = area
        self._doing = ""
        self._last = QPointF()

    @property
    def dragging(self) -> bool:
        """Whether a button is held: nothing moves away under the mouse then."""
        return bool(self._doing)

    def turn_wheel(self, event: QWheelEvent) -> None:
        """Zoom in time; over the names or with Shift scroll the lanes; sideways or Ctrl pan."""
        area, steps = self._area, event.angleDelta()
        held, key = event.modifiers(), Qt.KeyboardModifier
        over_names = event.position().x() < area.axis.left
        notches = (steps.y() or steps.x()) / _NOTCH
        if over_names or held & key.ShiftModifier:
            area.lanes.scroll(-notches * _LANES_PER_NOTCH)
        elif held & key.ControlModifier or abs(steps.x()) > abs(steps.y()):
            area.stretch.pan(-notches * _PAN_PER_NOTCH)
        else:
            area.stretch.show(area.axis.zoomed(event.position().x(), _ZOOM_PER_NOTCH**notches))
        event.accept()

    def press(self, event: QMouseEvent) -> None:
        """Start to seek, to move the cut or to pan; a lane is picked at once."""
        area, at, button = self._area, event.position(), event.button()
        self._last = at
        left = button is Qt.MouseButton.LeftButton
        with_ctrl = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if button is Qt.MouseButton.MiddleButton or (left and with_ctrl):
            self._doing = "pan"
            area.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif left and self._is_on_cut(at):
            self._doing = "cut"
        elif left:
            self._pick(event)

    def _pick(self, event: QMouseEvent) -> None:
        area, at = self._area, event.position()
        if at.y() > area.ruler_height:
            lane = area.lane_at(at)
            if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
                if lane is not None:
                    area.track_added.emit(lane.track)
                return
            area.track_picked.emit(lane.track if lane is not None else 0)
        if at.x() >= area.axis.left:
            self._doing = "seek"
            area.frame_sought.emit(area.axis.frame_at(at.x()))

    def move(self, event: QMouseEvent) -> None:
        """Go on with what the press began."""
        area, at = self._area, event.position()
        if self._doing == "seek":
            area.frame_sought.emit(area.axis.frame_at(at.x()))
        elif self._doing == "cut":
            area.cut_moved.emit(area.axis.frame_at(at.x() + area.axis.px_per_frame / 2))
        elif self._doing == "pan":
            moved, self._last = at - self._last, at
            area.stretch.show(area.axis.moved(-moved.x() / area.axis.px_per_frame))
            area.scroll_bar.setValue(round(area.scroll_bar.value() - moved.y()))
        else:
            shape = Qt.CursorShape
            area.setCursor(shape.SplitHCursor if self._is_on_cut(at) else shape.ArrowCursor)

    def release(self) -> None:
        """Done."""
        if self._doing == "pan":
            self._area.setCursor(Qt.CursorShape.ArrowCursor)
        self._doing = ""

    def double_click(self, event: QMouseEvent) -> None:
        """On the ruler the whole recording; on a lane the whole track, and then a second of it."""
        area, at = self._area, event.position()
        if at.y() <= area.ruler_height:
            area.stretch.show_all()
        else:
            area.stretch.show_track_or_second(area.lane_at(at), area.axis.frame_at(at.x()))

    def _is_on_cut(self, at: QPointF) -> bool:
        area, cut = self._area, self._area.cut
        if cut is None or at.y() <= area.ruler_height:
            return False
        return abs(at.x() - area.axis.x_of(cut)) <= _CUT_REACH_PX
