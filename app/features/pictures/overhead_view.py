"""The floor from above: particles, measured positions, people, where they walk."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QWidget

from app.core.drawing.name_plates import draw_message
from app.core.drawing.surfaces import FloorSurface
from app.core.i18n import tr
from app.core.look.theme import Theme
from app.core.scenes import FloorPerson, OverheadScene
from app.core.scenes.floor_marks import FloorMarks
from app.core.widgets.spoken_description import SpokenDescription, told_lines, told_people
from app.features.pictures.floor_painter import (
    FloorInput,
    FloorPainter,
    around_person,
    floor_content,
    floor_whole,
    person_radius,
)

_PICK_REACH_PX = 22.0
_GRIP_PX = 3.0  # around a person's ring


def _told_place(person: FloorPerson) -> str:
    x, y = person.position
    return tr("{name} at {x:.1f}, {y:.1f} m", name=person.label, x=x, y=y)


class OverheadView(FloorSurface):
    """Draws an :class:`OverheadScene`; forward is up.

    Signals:
        person_grabbed(int), person_dragged(float, float), person_dropped(): somebody is taken hold
            of, is now at x, y in metres, is let go.
    """

    person_grabbed = Signal(int)
    person_dragged = Signal(float, float)
    person_dropped = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: OverheadScene | None = None
        self._held: FloorPerson | None = None
        self._held_off = QPointF()
        self._dragged = False
        self._painter = FloorPainter()
        self._explained = True
        self.setContentsMargins(12, 12, 12, 12)
        self.setAccessibleName(tr("Overhead view"))
        self._spoken = SpokenDescription(self, self._words)

    def show_scene(self, scene: OverheadScene) -> None:
        """Draw another frame."""
        before = self.content()
        self._scene = scene
        if self._fitted and self.content() != before:
            self.fit()
        self._spoken.changed()
        self.update()

    def _words(self) -> str:
        """The frame, who stands where, who of them is selected."""
        scene = self._scene
        if scene is None or scene.message:
            return scene.message if scene is not None else ""
        people = [_told_place(one) for one in scene.people]
        selected = [one.label for one in scene.people if one.selected]
        frame = tr("Frame {frame}", frame=scene.frame)
        return told_lines(frame, *told_people(people, selected))

    def show_person(self, track: int) -> None:
        """Have a person seen who may stand outside of a zoomed view."""
        people = self._scene.people if self._scene is not None else ()
        place = next((one.position for one in people if one.track == track), None)
        if place is not None:
            self.bring_into_view(around_person(*place))

    @property
    def shows_floor(self) -> bool:
        """Whether there is a floor to see, and room to see it."""
        known = self._scene is not None and not self._scene.message
        return known and not self.size().isEmpty()

    def show_legend(self, explained: bool) -> None:
        """Explain what stands for what, in a corner, or do not."""
        if explained is not self._explained:
            self._explained = explained
            self.update()

    def content(self) -> QRectF:
        """The bounds of the scene and of the truth over it, in metres."""
        return floor_content(self._scene, self._truth)

    def reach(self) -> QRectF:
        """Everybody's places, also those that are far from all others."""
        return floor_whole(self._scene, self._truth)

    def clicked_at(self, at: QPointF, extend: bool) -> None:
        """Report who and where."""
        if self.content().isEmpty():
            return
        (self.track_added if extend else self.track_picked).emit(self.track_at(at))
        place = self.viewport.to_content(at)
        self.floor_clicked.emit(place.x(), place.y())

    def track_at(self, at: QPointF) -> int:
        """The person near."""
        person = self._person_at(at)
        return person.track if person is not None else 0

    def grabs(self, at: QPointF) -> bool:
        """A person whose ring is under the cursor."""
        self._held, self._dragged = self._movable_at(at), False
        if self._held is not None:
            self._held_off = self.viewport.point(*self._held.position) - at
        return self._held is not None

    def _movable_at(self, at: QPointF) -> FloorPerson | None:
        person = self._person_at(at) if self._scene is not None and self._scene.movable else None
        if person is None:
            return None
        apart = QLineF(self.viewport.point(*person.position), at).length()
        return person if apart <= person_radius(self.viewport) + _GRIP_PX else None

    def drag_to(self, at: QPointF) -> None:
        """Tell where the person stands by now."""
        if self._held is None:
            return
        if not self._dragged:
            self._dragged = True
            self.person_grabbed.emit(self._held.track)
        place = self.viewport.to_content(at + self._held_off)
        self.person_dragged.emit(place.x(), place.y())

    def drop(self) -> None:
        """Tell that the person stays."""
        self._held = None
        self.person_dropped.emit()

    def cursor_at(self, at: QPointF) -> Qt.CursorShape:
        """Arrows over who can be moved, a hand near people."""
        if self._movable_at(at) is not None:
            return Qt.CursorShape.SizeAllCursor
        over = self._person_at(at) is not None
        return Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor

    def name_at(self, at: QPointF) -> str:
        """The person near the cursor and where they stand."""
        person = self._person_at(at)
        if person is None:
            return ""
        text = tr("{0} at {1:.1f}, {2:.1f} m, {3:.1f} m/s")
        return text.format(person.label, *person.position, float(np.hypot(*person.velocity)))

    def _person_at(self, at: QPointF) -> FloorPerson | None:
        if self._scene is None or self._scene.message:
            return None
        named = next(
            (track for track, plate in self._painter.naming.plates if plate.contains(at)), 0
        )
        if named:  # what lies on top of people
            return next((one for one in self._scene.people if one.track == named), None)
        reach = max(_PICK_REACH_PX, person_radius(self.viewport) + 4)
        near = [
            (QLineF(self.viewport.point(*person.position), at).length(), person)
            for person in self._scene.people
        ]
        hits = [hit for hit in near if hit[0] <= reach]
        return min(hits, key=lambda hit: hit[0])[1] if hits else None

    def paint(self, painter: QPainter, theme: Theme) -> None:
        """The floor and everybody on it."""
        given = self.given(self.devicePixelRatioF())
        if given is not None:
            self._painter.paint(painter, given, theme)
            return
        text = self._scene.message if self._scene is not None else ""
        draw_message(painter, QRectF(self.rect()), text, theme)

    def given(self, ratio: float, kept: bool = True) -> FloorInput | None:
        """All that decides how the floor looks now; None where there is none to see.

        ratio: pixels in one unit of the view. kept: see `FloorInput`.
        """
        if self._scene is None or self._scene.message:
            return None
        marks = FloorMarks(self._labels, self._others, self._truth, self._flow)
        size, font = self.size(), self.font()
        return FloorInput(
            self._scene, marks, self.viewport, size, ratio, font, self._explained, kept
        )
