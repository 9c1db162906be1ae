"""Who is who overhead: names of people and of a truth, none on another, placed once a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from app.core.drawing.name_places import Stands
from app.core.drawing.name_plates import draw_leader, draw_note, draw_plate, plate_sizes, plate_text
from app.core.drawing.truth_marks import CROSS_PX, MISS_PX
from app.core.drawing.viewport import Points, Viewport
from app.core.look.theme import Theme, faded, scaled_font
from app.core.scenes import FloorPerson, OverheadScene
from app.core.scenes.ground_truth import FlooredTruth, TruthPlace
from app.features.pictures.floor_names import NEAR, Owner, WantedName, discs, place_floor_names

_EDGE_PX = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class FloorNameInput:
    """All that decides where names stand.

    Attributes:
        radius: of people's rings. area: of the view. font: of the view, all in widget units.
    """

    scene: OverheadScene
    truth: FlooredTruth
    viewport: Viewport
    radius: float
    area: QRectF
    font: QFont

    def is_as(self, other: FloorNameInput | None) -> bool:
        """Whether names stand where they stood; scenes are the very same or others."""
        if other is None or self.scene is not other.scene or self.truth is not other.truth:
            return False
        where = self.viewport, self.radius, self.area, self.font
        return where == (other.viewport, other.radius, other.area, other.font)


class FloorNamePainter:
    """Draws names where they hide nobody.

    First who is selected and who is missed, who are always named; then other people, then others
    of the truth, as far as there is room.
    """

    def __init__(self) -> None:
        self._floored: FloorNameInput | None = None
        self._sides: dict[Owner, int] = {}
        self._placed: dict[Owner, Stands] = {}
        self._texts: dict[Owner, tuple[str, ...]] = {}

    @property
    def plates(self) -> tuple[tuple[int, QRectF], ...]:
        """The tracks named, and where."""
        named = self._placed.items()
        return tuple((owner, one.rect) for owner, one in named if isinstance(owner, int))

    @property
    def truth_plates(self) -> tuple[tuple[str, QRectF], ...]:
        """The labels of the truth, and where."""
        named = self._placed.items()
        return tuple((owner, one.rect) for owner, one in named if isinstance(owner, str))

    def draw(self, painter: QPainter, floored: FloorNameInput, theme: Theme) -> None:
        """Draw the names; they are placed anew only where anything is another."""
        if not floored.is_as(self._floored):
            self._floored = floored
            self._place(floored)
        people = {one.track: one for one in floored.scene.people}
        truth = {one.label: one for one in floored.truth.people}
        for owner, name in reversed(self._placed.items()):
            text = self._texts[owner][name.size]
            if isinstance(owner, int):
                painter.setFont(_bold(floored.font))
                _draw_person(painter, people[owner], name, text, floored, theme)
            else:
                painter.setFont(_plain(floored.font))
                _draw_truth(painter, truth[owner], name, text, floored, theme)

    def _place(self, floored: FloorNameInput) -> None:
        people, truth, view = floored.scene.people, floored.truth.people, floored.viewport
        rings = view.to_widget(_matrix([one.position for one in people]))
        crosses = view.to_widget(_matrix([one.trail[-1] for one in truth]))
        bold, plain = QFontMetricsF(_bold(floored.font)), QFontMetricsF(_plain(floored.font))
        self._texts = {one.track: _texts(bold, one) for one in people}
        own = [
            WantedName(one.track, at, plate_sizes(bold, self._texts[one.track]), one.selected)
            for one, at in zip(people, _pairs(rings), strict=True)
        ]
        self._texts |= {one.label: (one.label,) for one in truth}
        true = [
            WantedName(one.label, at, plate_sizes(plain, (one.label,)), one.wrong is not None)
            for one, at in zip(truth, _pairs(crosses), strict=True)
        ]
        wanted = [one for one in (*own, *true) if floored.area.contains(QPointF(*one.at))]
        wanted.sort(key=lambda one: not one.must)
        seen = np.concatenate(
            (
                discs(rings, floored.radius),
                discs(view.to_widget(floored.scene.measured)),
                *(discs(at[None], _reach(one)) for one, at in zip(truth, crosses, strict=True)),
            )
        )
        shown = floored.area.adjusted(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)
        self._placed = place_floor_names(wanted, seen, floored.radius, shown, self._sides)
        self._sides = {owner: one.side for owner, one in self._placed.items()}


def _draw_person(
    painter: QPainter,
    person: FloorPerson,
    name: Stands,
    text: str,
    floored: FloorNameInput,
    theme: Theme,
) -> None:
    colour = theme.track(person.colour)
    at = floored.viewport.point(*person.position)
    _draw_leader(painter, at, name, floored.radius, colour)
    draw_plate(painter, name.rect, text, colour, person.selected)


def _draw_truth(
    painter: QPainter,
    person: TruthPlace,
    name: Stands,
    text: str,
    floored: FloorNameInput,
    theme: Theme,
) -> None:
    at = floored.viewport.point(*person.trail[-1])
    _draw_leader(painter, at, name, CROSS_PX, faded(theme.text, 0.75))
    draw_note(painter, name.rect, text, theme)


def _draw_leader(
    painter: QPainter, at: QPointF, name: Stands, radius: float, colour: QColor
) -> None:
    if name.side >= NEAR:
        draw_leader(painter, at, name.rect, radius, colour)


def _reach(person: TruthPlace) -> float:
    """Of the cross, or of the sign around it."""
    return CROSS_PX if person.wrong is None else MISS_PX


def _bold(font: QFont) -> QFont:
    return scaled_font(font, 0.92, bold=True)


def _plain(font: QFont) -> QFont:
    return scaled_font(font, 0.92)


def _matrix(places: Sequence[Sequence[float] | Points]) -> Points:
    return np.array(places, np.float64).reshape(-1, 2)


def _pairs(points: Points) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in points]


def _texts(metrics: QFontMetricsF, person: FloorPerson) -> tuple[str, ...]:
    """What a plate says, and what it says where that has no room."""
    whole, number = plate_text(metrics, person.label), str(person.track)
    return (whole,) if whole == number else (whole, number)
