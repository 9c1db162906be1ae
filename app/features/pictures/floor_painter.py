"""The floor with everybody on it, drawn on a widget or on a picture of its own.

Nothing here asks a widget: pictures are painted on any thread.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF
from PySide6.QtGui import QFont, QFontMetricsF, QImage, QPainter

from app.core.drawing.compare_marks import draw_other_places
from app.core.drawing.label_marks import (
    draw_outline_names,
    draw_outlines,
    place_outline_names,
)
from app.core.drawing.legend import draw_legend
from app.core.drawing.particles import darkened, draw_particles
from app.core.drawing.people_marks import draw_fading_trail, draw_preview
from app.core.drawing.truth_marks import draw_truth_places
from app.core.drawing.viewport import Viewport
from app.core.i18n import tr
from app.core.look.theme import Theme, scaled_font
from app.core.projection.extent import Bounds, unite
from app.core.scenes import OverheadScene
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.ground_truth import FlooredTruth
from app.features.pictures.floor import (
    draw_camera,
    draw_field_of_view,
    draw_grid,
    draw_scale_bar,
    inner_corner,
    scale_bar_plate,
)
from app.features.pictures.floor_legend import FloorLegend
from app.features.pictures.floor_name_painter import FloorNameInput, FloorNamePainter
from app.features.pictures.floor_people import draw_floor_ghost, draw_floor_person
from app.features.pictures.flow_map import FlowMapPainter
from app.features.pictures.measurement_marks import draw_measured

_PERSON_RADIUS_M = 0.22
_PARTICLE_RADIUS_M = 0.014
_LEGEND_PX = 12.0  # between two of them


@dataclass(frozen=True, slots=True, eq=False)
class FloorInput:
    """All that decides how the floor looks.

    Attributes:
        viewport: where the floor is drawn. size, ratio: of the view, in its units, and how many
            pixels one of them has. font: of the view.
        explained: whether the signs are told in a corner.
        kept: whether what does not move is drawn once into a picture, for the frames to come; else
            all of it is drawn as lines.
    """

    scene: OverheadScene
    marks: FloorMarks
    viewport: Viewport
    size: QSize
    ratio: float
    font: QFont
    explained: bool = True
    kept: bool = True

    @property
    def area(self) -> QRectF:
        """Of the view."""
        return QRectF(QPointF(), QSizeF(self.size))

    @property
    def radius(self) -> float:
        """Of a person's ring."""
        return person_radius(self.viewport)


def person_radius(viewport: Viewport) -> float:
    """Of a person's ring, in units of the view."""
    return min(max(_PERSON_RADIUS_M * viewport.scale, 6.0), 40.0)


def around_person(x: float, y: float) -> QRectF:
    """Where a person stands on the floor, m."""
    side = 2 * _PERSON_RADIUS_M
    return QRectF(x - side / 2, y - side / 2, side, side)


def floor_content(scene: OverheadScene | None, truth: FlooredTruth) -> QRectF:
    """The bounds of a scene and of the truth over it, in metres; empty without a floor."""
    if scene is None or scene.message:
        return QRectF()
    return _rectangle(unite(scene.bounds, truth.bounds))


def floor_whole(scene: OverheadScene | None, truth: FlooredTruth) -> QRectF:
    """The same with every place that is known, however far, in metres."""
    if scene is None or scene.message:
        return QRectF()
    return _rectangle(unite(unite(scene.bounds, scene.all_bounds), truth.bounds))


def _rectangle(bounds: Bounds) -> QRectF:
    left, bottom, right, top = bounds
    return QRectF(left, bottom, right - left, top - bottom)


class FloorPainter:
    """Draws floors; names stay where they stood from one frame to the next.

    Attributes:
        naming: draws the names, and knows where they stand.
    """

    def __init__(self) -> None:
        self.naming = FloorNamePainter()
        self._flow, self._legend = FlowMapPainter(), FloorLegend()
        self._floor_key: tuple[object, ...] = ()
        self._floor_drawn = QImage()

    def paint(self, painter: QPainter, given: FloorInput, theme: Theme) -> None:
        """Floor, trails, particles, measured positions, people, plates; in this order."""
        scene, marks, view, area = given.scene, given.marks, given.viewport, given.area
        self._paint_floor(painter, given, theme)
        foot = inner_corner(scaled_font(given.font, 0.85), area)
        if marks.flow is not None:  # which has a legend of its own: the other stands upon it
            over = given.size, given.ratio, given.font
            foot.setY(self._flow.paint(painter, marks.flow, view, over, theme) - _LEGEND_PX)
        painter.setFont(scaled_font(given.font, 0.92))
        outlines = marks.labels.outlines
        draw_outlines(painter, outlines, view, theme)
        bar = scale_bar_plate(QFontMetricsF(scaled_font(given.font, 0.85)), area, view)
        labels = place_outline_names(QFontMetricsF(painter.font()), outlines, view, area, [bar])
        draw_other_places(painter, marks.others, view, theme, area)
        _draw_people(painter, given, theme)
        draw_truth_places(painter, marks.truth, view, theme)
        draw_preview(painter, scene.preview, view, theme.track)
        draw_outline_names(painter, labels, theme)
        named = FloorNameInput(scene, marks.truth, view, given.radius, area, given.font)
        self.naming.draw(painter, named, theme)
        self._draw_legends(painter, given, foot, theme)
        unit = tr("m, roughly") if scene.rough else tr("m")
        draw_scale_bar(painter, area, view, theme, unit)

    def _draw_legends(
        self, painter: QPainter, given: FloorInput, foot: QPointF, theme: Theme
    ) -> None:
        painter.setFont(scaled_font(given.font, 0.85))
        told = draw_legend(painter, given.marks.truth.legend, foot, theme)
        if given.explained and given.marks.flow is None:
            above = foot - QPointF(0, told + _LEGEND_PX) if told else foot
            taken = self._taken(given)
            self._legend.draw(painter, given.scene, above, given.area, taken, theme)

    def _taken(self, given: FloorInput) -> list[QRectF]:
        """Where people and their names are drawn."""
        side = 2 * given.radius
        places = [given.viewport.point(*person.position) for person in given.scene.people]
        rings = [QRectF(at.x() - side / 2, at.y() - side / 2, side, side) for at in places]
        return rings + [plate for _, plate in self.naming.plates]

    def _paint_floor(self, painter: QPainter, given: FloorInput, theme: Theme) -> None:
        """What does not move, drawn again only where the view or the look is another."""
        if not given.kept:
            _draw_floor(painter, given, theme)
            return
        seen = given.scene.field_of_view.tobytes()
        where = given.viewport, given.size.toTuple(), given.ratio
        key = (*where, theme.name, seen, given.font.key())
        if key != self._floor_key:
            self._floor_key = key
            self._floor_drawn = blank_image(given.size, given.ratio)
            still = QPainter(self._floor_drawn)
            still.setRenderHint(QPainter.RenderHint.Antialiasing)
            _draw_floor(still, given, theme)
            still.end()
        painter.drawImage(0, 0, self._floor_drawn)


def blank_image(size: QSize, ratio: float = 1.0) -> QImage:
    """A transparent picture of a size in units of which each has so many pixels."""
    image = QImage(size * ratio, QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(ratio)
    image.fill(0)
    return image


def _draw_floor(painter: QPainter, given: FloorInput, theme: Theme) -> None:
    scene, view = given.scene, given.viewport
    painter.fillRect(given.area, theme.sunken)
    painter.setFont(scaled_font(given.font, 0.85))
    draw_grid(painter, given.area, view, theme)
    draw_field_of_view(painter, scene.field_of_view, view, theme)
    draw_camera(painter, scene.camera, view, theme, scene.looks_down)


def _draw_people(painter: QPainter, given: FloorInput, theme: Theme) -> None:
    """Trails, particles, people, what was measured."""
    scene, view = given.scene, given.viewport
    for person in scene.people:
        width = 3.0 if person.selected else 2.0
        points = view.to_widget(person.trail)
        draw_fading_trail(painter, points, theme.track(person.colour), width)
    _draw_particles(painter, given, theme)
    for person in scene.ghosts:
        draw_floor_ghost(painter, person, view, given.radius, theme)
    for person in scene.people:
        draw_floor_person(painter, person, view, given.radius, theme)
    draw_measured(painter, view.to_widget(scene.measured), theme)


def _draw_particles(painter: QPainter, given: FloorInput, theme: Theme) -> None:
    scene, ratio = given.scene, given.ratio
    if not len(scene.particles):
        return
    radius_px = min(max(_PARTICLE_RADIUS_M * given.viewport.scale, 1.3), 2.6)
    draw_particles(
        painter,
        given.viewport.to_widget(scene.particles) * ratio,
        scene.particle_colours if theme.is_dark else darkened(scene.particle_colours),
        scene.particle_weights,
        (round(given.size.width() * ratio), round(given.size.height() * ratio)),
        radius_px * ratio,
        ratio,
    )
