"""Where people's names stand in a picture: beside their boxes, and on nobody's head."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from app.core.drawing.name_places import Name, place_names
from app.core.drawing.name_plates import PAD_PX, draw_plate, plate_sizes, plate_text
from app.core.drawing.rectangles import Flags, Floats, beyond, coords, covers, lie_on
from app.core.drawing.viewport import Viewport
from app.core.scenes import PersonMark

_GAP_PX = 3.0
_HEAD = 0.2
"""Of a box, from its upper edge down."""
_SMALL_PAD_PX = 5.0
_SHORTENED = 2
"""Texts of a name that is short: itself and the number; a long one is shortened between."""
_EDGE_PX = 2.0
"""So near the picture's upper edge a box has no head in it."""


@dataclass(frozen=True, slots=True, eq=False)
class BoxNameInput:
    """All that decides where names stand, but for the cursor.

    Attributes:
        area: where names may stand. taken: what they must not lie on. font: of the names, all in
            widget units. small: plates of a small picture, with less around their words.
    """

    people: Sequence[PersonMark]
    viewport: Viewport
    area: QRectF
    taken: Sequence[QRectF]
    font: QFont
    small: bool = False

    def is_as(self, other: BoxNameInput | None) -> bool:
        """Whether names stand where they stood; people are the very same or others."""
        if other is None or self.people is not other.people or self.taken != other.taken:
            return False
        where = self.viewport, self.area, self.font, self.small
        return where == (other.viewport, other.area, other.font, other.small)


@dataclass(frozen=True, slots=True)
class _Person:
    """Somebody who is to be named: by `texts`, the longest first, of `sizes`."""

    mark: PersonMark
    box: Floats
    texts: tuple[str, ...]
    sizes: Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True, eq=False)
class _Crowd:
    """Who is to be named, who is selected first, and where each name could stand.

    Attributes:
        sides: (n, sizes, sides, 4), see `_sides`. shut, crowded: (n, sizes, sides), see `_barred`.
    """

    people: tuple[_Person, ...] = ()
    sides: Floats = field(default_factory=lambda: np.zeros((0, 2, 8, 4)))
    shut: Flags = field(default_factory=lambda: np.zeros((0, 2, 8), bool))
    crowded: Flags = field(default_factory=lambda: np.zeros((0, 2, 8), bool))


@dataclass(frozen=True, slots=True)
class _Plate:
    mark: PersonMark
    text: str
    rect: QRectF


class BoxNamePainter:
    """Draws names where they hide no head and no other name, or else not at all.

    Above the box, or beside or below it, if possible where nobody else is; a long name is shortened
    to its number before it is left out. Who is selected or under the cursor is always named: the
    others make way for them. Names are placed anew only where anything is another.
    """

    def __init__(self) -> None:
        self._boxed: BoxNameInput | None = None
        self._crowd = _Crowd()
        self._sides: dict[int, int] = {}
        self._usual: list[_Plate] = []
        self._plates: list[_Plate] = []
        self._forced = 0

    @property
    def named(self) -> frozenset[int]:
        """The tracks that have a plate while the cursor forces nobody else's."""
        return frozenset(one.mark.track for one in self._usual)

    @property
    def forced(self) -> int:
        """The track that has a plate only because the cursor is there; 0: none."""
        return self._forced

    @property
    def plates(self) -> list[tuple[int, QRectF]]:
        """Whose names are shown, and where, the topmost first."""
        return [(one.mark.track, one.rect) for one in self._plates]

    def draw(self, painter: QPainter, boxed: BoxNameInput, over: int = 0) -> list[QRectF]:
        """Draw the plates of those in sight, and tell where they stand.

        Args:
            over: the track under the cursor.
        """
        if not boxed.is_as(self._boxed):
            self._boxed, self._crowd = boxed, _crowd(boxed)
            self._usual, self._sides = self._placed(boxed)
            self._plates, self._forced = self._usual, 0
        self._point_at(over, boxed)
        painter.setFont(boxed.font)
        for one in reversed(self._plates):
            draw_plate(painter, one.rect, one.text, QColor(*one.mark.colour), one.mark.selected)
        return [one.rect for one in self._plates]

    def _point_at(self, track: int, boxed: BoxNameInput) -> None:
        """Whoever is under the cursor and has no name usually goes first; else all is as usual."""
        unnamed = {one.mark.track for one in self._crowd.people} - self.named
        forced = track if track in unnamed else 0
        if forced != self._forced:
            self._forced = forced
            self._plates = self._placed(boxed, forced)[0] if forced else self._usual

    def _placed(self, boxed: BoxNameInput, over: int = 0) -> tuple[list[_Plate], dict[int, int]]:
        """Plates of those who have one, and on which side; earlier people have the right of way."""
        crowd, kept = self._crowd, dict(self._sides)
        order = sorted(
            range(len(crowd.people)), key=lambda number: crowd.people[number].mark.track != over
        )
        names = [self._name(number, over) for number in order]
        plates = []
        for number, stands in zip(order, place_names(names, boxed.area, boxed.taken), strict=True):
            if stands is not None:
                one = crowd.people[number]
                plates.append(_Plate(one.mark, one.texts[stands.size], stands.rect))
                kept[one.mark.track] = stands.side
        return plates, kept

    def _name(self, number: int, over: int) -> Name:
        crowd, one = self._crowd, self._crowd.people[number]
        sizes = slice(len(one.texts))
        shut, crowded = crowd.shut[number, sizes], crowd.crowded[number, sizes]
        if len(one.texts) > _SHORTENED:  # whole it stands only where it hides nobody
            shut = np.concatenate((shut[:1] | crowded[:1], shut[1:]))
        return Name(
            crowd.sides[number, sizes],
            shut,
            crowded,
            usual=self._sides.get(one.mark.track, 0),
            must=one.mark.selected or one.mark.track == over,
        )


def _crowd(boxed: BoxNameInput) -> _Crowd:
    """Those in sight, who is selected first."""
    metrics, view = QFontMetricsF(boxed.font), boxed.viewport
    seen = [one for one in boxed.people if view.rect(QRectF(*one.box)).intersects(boxed.area)]
    seen.sort(key=lambda one: not one.selected)
    people = tuple(_person(one, view, metrics, boxed.small) for one in seen)
    if not people:
        return _Crowd()
    sides = _sides(people)
    return _Crowd(people, sides, *_barred(people, sides, boxed.area, coords(boxed.taken)))


def _barred(
    people: Sequence[_Person], sides: Floats, area: QRectF, taken: Floats
) -> tuple[Flags, Flags]:
    """(n, sizes, sides) where a name would hide a head or leave the area, and where others."""
    bodies = np.array([one.box for one in people])
    heads = bodies.copy()
    heads[:, 3] = bodies[:, 1] + _HEAD * (bodies[:, 3] - bodies[:, 1])
    heads = heads[bodies[:, 1] > area.top() + _EDGE_PX]
    shut = beyond(sides, area) | covers(sides, np.concatenate((taken, heads)))
    lies, own = lie_on(sides, bodies), np.arange(len(bodies))
    lies[own, ..., own] = False
    return shut, np.asarray(lies.any(axis=-1))


def _person(mark: PersonMark, viewport: Viewport, metrics: QFontMetricsF, small: bool) -> _Person:
    box = viewport.rect(QRectF(*mark.box))
    whole = plate_text(metrics, mark.label, alone=True)
    texts = tuple(dict.fromkeys((whole, plate_text(metrics, mark.label), str(mark.track))))
    pad = _SMALL_PAD_PX if small else PAD_PX
    sizes = plate_sizes(metrics, texts, pad)
    return _Person(mark, np.array(box.getCoords()), texts, sizes)


def _sides(people: Sequence[_Person]) -> Floats:
    """(n, sizes, 8, 4) left, top, right, bottom of plates, best sides first, the last in the box.

    Who has fewer sizes than others has the first ones again.
    """
    left, top, right, bottom = np.array([one.box for one in people]).T[:, :, None]
    most = max(len(one.sizes) for one in people)
    sizes = np.array([(most * tuple(one.sizes))[:most] for one in people])
    width, height = sizes[..., 0], sizes[..., 1]
    above, below, inside = top - _GAP_PX - height, bottom + _GAP_PX, bottom - height
    before, behind, flush = left - _GAP_PX - width, right + _GAP_PX, right - width + 1
    middle, beside = (left + right - width) / 2, top + np.zeros_like(width)
    start, foot = left - 1 + np.zeros_like(width), below + np.zeros_like(width)
    behind = behind + np.zeros_like(width)
    x = np.stack((start, flush, behind, before, middle, behind, before, middle), axis=-1)
    y = np.stack((above, above, beside, beside, foot, inside, inside, inside), axis=-1)
    return np.stack((x, y, x + width[..., None], y + height[..., None]), axis=-1)
