"""The floor from above: particles, measured positions, people, where they walk."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QPainter, QPixmap
from PySide6.QtWidgets import QWidget

from app.core.drawing.compare_marks import draw_other_places
from app.core.drawing.label_marks import (
    draw_outline_names,
    draw_outlines,
    place_outline_names,
)
from app.core.drawing.legend import draw_legend
from app.core.drawing.name_plates import draw_message
from app.core.drawing.particles import darkened, draw_particles
from app.core.drawing.people_marks import draw_fading_trail, draw_preview
from app.core.drawing.surfaces import FloorSurface
from app.core.drawing.truth_marks import draw_truth_places
from app.core.i18n import tr
from app.core.look.theme import Theme, scaled_font
from app.core.projection.extent import unite
from app.core.scenes import FloorPerson, OverheadScene
from app.features.pictures.floor import (
    draw_camera,
    draw_field_of_view,
    draw_grid,
    draw_scale_bar,
    inner_corner,
)
from app.features.pictures.floor_legend import FloorLegend
from app.features.pictures.floor_name_painter import FloorNameInput, FloorNamePainter
from app.features.pictures.floor_people import draw_floor_ghost, draw_floor_person
from app.features.pictures.flow_map import FlowMapPainter
from app.features.pictures.measurement_marks import draw_measured

_PICK_REACH_PX = 22.0
_PERSON_RADIUS_M = 0.22
_PARTICLE_RADIUS_M = 0.014
_LEGEND_PX = 12.0  # between two of them
_GRIP_PX = 3.0  # around a person's ring


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
        self._flow_drawing = FlowMapPainter(self)
        self._held: FloorPerson | None = None
        self._held_off = QPointF()
        self._dragged = False
        self._naming = FloorNamePainter()
        self._legend = FloorLegend()
        self._floor_key: tuple[object, ...] = ()
        self._floor_drawn = QPixmap()
        self._explained = True
        self.setContentsMargins(12, 12, 12, 12)
        self.setAccessibleName(tr("Overhead view"))

    def show_scene(self, scene: OverheadScene) -> None:
        """Draw another frame."""
        before = self.content()
        self._scene = scene
        if self._fitted and self.content() != before:
            self.fit()
        self.update()

    def show_person(self, track: int) -> None:
        """Have a person seen who may stand outside of a zoomed view."""
        people = self._scene.people if self._scene is not None else ()
        place = next((one.position for one in people if one.track == track), None)
        if place is not None:
            around = QRectF(0, 0, 2 * _PERSON_RADIUS_M, 2 * _PERSON_RADIUS_M)
            around.moveCenter(QPointF(*place))
            self.bring_into_view(around)

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
        if self._scene is None or self._scene.message:
            return QRectF()
        left, bottom, right, top = unite(self._scene.bounds, self._truth.bounds)
        return QRectF(left, bottom, right - left, top - bottom)

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
        return person if apart <= self._radius() + _GRIP_PX else None

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
        named = next((track for track, plate in self._naming.plates if plate.contains(at)), 0)
        if named:  # what lies on top of people
            return next((one for one in self._scene.people if one.track == named), None)
        reach = max(_PICK_REACH_PX, self._radius() + 4)
        near = [
            (QLineF(self.viewport.point(*person.position), at).length(), person)
            for person in self._scene.people
        ]
        hits = [hit for hit in near if hit[0] <= reach]
        return min(hits, key=lambda hit: hit[0])[1] if hits else None

    def _radius(self) -> float:
        return min(max(_PERSON_RADIUS_M * self.viewport.scale, 6.0), 40.0)

    def paint(self, painter: QPainter, theme: Theme) -> None:
        """Floor, trails, particles, measured positions, people, plates; in this order."""
        area, scene = QRectF(self.rect()), self._scene
        if scene is None or scene.message:
            text = scene.message if scene is not None else ""
            draw_message(painter, area, text, theme)
            return
        painter.drawPixmap(0, 0, self._floor(scene, theme))
        foot = inner_corner(scaled_font(self.font(), 0.85), area)
        if self._flow is not None:  # which has a legend of its own: the other stands upon it
            top = self._flow_drawing.paint(painter, self._flow, self.viewport, theme)
            foot.setY(top - _LEGEND_PX)
        painter.setFont(scaled_font(self.font(), 0.92))
        outlines = self._labels.outlines
        draw_outlines(painter, outlines, self.viewport, theme)
        labels = place_outline_names(QFontMetricsF(painter.font()), outlines, self.viewport, area)
        draw_other_places(painter, self._others, self.viewport, theme, area)
        self._draw_trails(painter, scene, theme)
        self._draw_particles(painter, scene, theme)
        for person in scene.ghosts:
            draw_floor_ghost(painter, person, self.viewport, self._radius(), theme)
        for person in scene.people:
            draw_floor_person(painter, person, self.viewport, self._radius(), theme)
        draw_measured(painter, self.viewport.to_widget(scene.measured), theme)
        draw_truth_places(painter, self._truth, self.viewport, theme)
        draw_preview(painter, scene.preview, self.viewport, theme.track)
        draw_outline_names(painter, labels, theme)
        self._naming.draw(painter, self._floored(scene), theme)
        painter.setFont(scaled_font(self.font(), 0.85))
        told = draw_legend(painter, self._truth.legend, foot, theme)
        if self._explained and self._flow is None:
            above = foot - QPointF(0, told + _LEGEND_PX) if told else foot
            self._legend.draw(painter, scene, above, area, self._taken(scene), theme)
        unit = tr("m, roughly") if scene.rough else tr("m")
        draw_scale_bar(painter, area, self.viewport, theme, unit)

    def _taken(self, scene: OverheadScene) -> list[QRectF]:
        """Where people and their names are drawn."""
        side = 2 * self._radius()
        places = [self.viewport.point(*person.position) for person in scene.people]
        rings = [QRectF(at.x() - side / 2, at.y() - side / 2, side, side) for at in places]
        return rings + [plate for _, plate in self._naming.plates]

    def _floor(self, scene: OverheadScene, theme: Theme) -> QPixmap:
        """What does not move, drawn again only where the view or the look is another."""
        ratio = self.devicePixelRatioF()
        seen = scene.field_of_view.tobytes()
        key = (self.viewport, self.size().toTuple(), ratio, theme.name, seen, self.font().key())
        if key != self._floor_key:
            self._floor_key = key
            self._floor_drawn = QPixmap(self.size() * ratio)
            self._floor_drawn.setDevicePixelRatio(ratio)
            self._floor_drawn.fill(theme.sunken)
            painter = QPainter(self._floor_drawn)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setFont(scaled_font(self.font(), 0.85))
            draw_grid(painter, QRectF(self.rect()), self.viewport, theme)
            draw_field_of_view(painter, scene.field_of_view, self.viewport, theme)
            draw_camera(painter, scene.camera, self.viewport, theme, scene.looks_down)
            painter.end()
        return self._floor_drawn

    def _floored(self, scene: OverheadScene) -> FloorNameInput:
        area, font = QRectF(self.rect()), self.font()
        return FloorNameInput(scene, self._truth, self.viewport, self._radius(), area, font)

    def _draw_trails(self, painter: QPainter, scene: OverheadScene, theme: Theme) -> None:
        for person in scene.people:
            points = self.viewport.to_widget(person.trail)
            width = 3.0 if person.selected else 2.0
            draw_fading_trail(painter, points, theme.track(person.colour), width)

    def _draw_particles(self, painter: QPainter, scene: OverheadScene, theme: Theme) -> None:
        if not len(scene.particles):
            return
        ratio, colours = self.devicePixelRatioF(), scene.particle_colours
        radius_px = min(max(_PARTICLE_RADIUS_M * self.viewport.scale, 1.3), 2.6)
        draw_particles(
            painter,
            self.viewport.to_widget(scene.particles) * ratio,
            colours if theme.is_dark else darkened(colours),
            scene.particle_weights,
            (round(self.width() * ratio), round(self.height() * ratio)),
            radius_px * ratio,
            ratio,
        )
