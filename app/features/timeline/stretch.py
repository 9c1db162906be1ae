"""Which frames the timeline shows, and every way to come to others."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.core.plots.axis import TimeAxis
from app.core.scenes import Lane, TimelineScene

_PARTLY = 0.6
"""Where less of a recording was tracked, that is what one begins with."""


class TimeStretch(QObject):
    """The stretch of frames that is shown, as wide as there is room for it.

    Signals:
        changed(object): zoomed, panned or resized; the new :class:`TimeAxis`.
    """

    changed = Signal(object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.axis = TimeAxis(0.0, 1.0, 0.0, 1.0, 0)
        self._scene: TimelineScene | None = None
        self._room = (0.0, 1.0)

    def place(self, left: float, width: float) -> None:
        """Draw the same frames from `left` over another width, in widget units."""
        self._room = (left, width)
        self.show(self.axis)

    def take(self, scene: TimelineScene, *, still: bool) -> None:
        """Show the frame of another frame; all that was tracked where it is of another recording.

        still: nothing moves, as a button of the mouse is held.
        """
        before, self._scene = self._scene, scene
        if before is None or before.frame_count != scene.frame_count:
            self.show(self._first(scene))
        elif before.frame != scene.frame and not still:
            self.show(self.axis.showing(scene.frame))

    def _first(self, scene: TimelineScene) -> TimeAxis:
        """The whole recording; of one of which only a part was tracked, that part."""
        first, end = scene.tracked
        whole = self.axis.whole(scene.frame_count)
        partly = scene.lanes and 0 < end - first < _PARTLY * scene.frame_count
        return whole.fitting(first, end) if partly else whole

    def show(self, axis: TimeAxis) -> None:
        """Show other frames."""
        fitted = axis.resized(*self._room)
        if fitted != self.axis:
            self.axis = fitted
            self.changed.emit(fitted)

    def zoom(self, factor: float) -> None:
        """Closer around the playhead where it is in sight, else around the middle."""
        axis, frame = self.axis, self._scene.frame if self._scene is not None else 0
        inside = axis.start <= frame < axis.start + axis.frames
        x = axis.x_of(frame + 0.5) if inside else axis.left + axis.width / 2
        self.show(axis.zoomed(x, factor))

    def pan(self, share: float) -> None:
        """Later, or earlier, by a share of the frames shown."""
        self.show(self.axis.moved(share * self.axis.frames))

    def begin_at(self, first: int) -> None:
        """As many frames as now, from another one on."""
        if first != int(self.axis.start):
            self.show(self.axis.moved(first - self.axis.start))

    def centre(self, frame: int) -> None:
        """As many frames as now, around another one."""
        self.show(self.axis.around(frame, self.axis.frames))

    def show_all(self) -> None:
        """The whole recording."""
        if self._scene is not None:
            self.show(self.axis.whole(self._scene.frame_count))

    def show_selected(self) -> None:
        """The selected tracks from their first to their last frame."""
        lanes = self._scene.lanes if self._scene is not None else ()
        chosen = [lane.spans for lane in lanes if lane.selected and len(lane.spans)]
        if chosen:
            first = min(int(spans[0, 0]) for spans in chosen)
            self.show(self.axis.fitting(first, max(int(spans[-1, 1]) for spans in chosen)))

    def show_second(self) -> None:
        """A second around the playhead."""
        if self._scene is not None:
            self.show(self.axis.around(self._scene.frame, self._scene.fps))

    def show_track_or_second(self, lane: Lane | None, frame: int) -> None:
        """All of a track; where it is shown already, or beside the lanes, a second there."""
        if self._scene is None:
            return
        second = self.axis.around(frame, self._scene.fps)
        if lane is None or not len(lane.spans):
            self.show(second)
            return
        whole = self.axis.fitting(int(lane.spans[0, 0]), int(lane.spans[-1, 1]))
        shown = (whole.start, whole.frames) == (self.axis.start, self.axis.frames)
        self.show(second if shown else whole)
