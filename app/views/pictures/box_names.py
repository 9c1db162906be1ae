"""Where people's names stand in a picture: beside their boxes, and on nobody's head."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QFontMetricsF, QPainter

from app.presenters.scenes import PersonMark
from app.views.pictures.name_plates import PAD_PX, draw_plate, plate_sizes, plate_text
from app.views.pictures.rectangles import (
    Flags,
    Floats,
    as_rect,
    beyond,
    coords,
    covers,
    first_free,
    within,
)
from app.views.pictures.viewport import Viewport

_GAP_PX = 3.0
_HEAD = 0.2
"""Of a box, from its upper edge down."""
_SMALL_PAD_PX = 5.0
_EDGE_PX = 2.0
"""So near the picture's upper edge a box has no head in it."""


@dataclass(frozen=True, slots=True)
class _Person:
    """Somebody who is to be named: by `texts`, the longest first, of `sizes`."""

    mark: PersonMark
    box: Floats
    texts: tuple[str, ...]
    sizes: Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class _Plate:
    mark: PersonMark
    text: str
    rect: QRectF


class BoxNaming:
    """Draws names where they hide no head and no other name, or else not at all.

    Above the box, or beside or below it, if possible where nobody else is; a long name is shortened
    to its number before it is left out. Who is selected or under the cursor is always named: the
    others make way for them.
    """

    def __init__(self) -> None:
        self._sides: dict[int, int] = {}
        self._named: frozenset[int] = frozenset()
        self._forced = 0

    @property
    def named(self) -> frozenset[int]:
        """The tracks that have a plate wherever the cursor is."""
        return self._named

    @property
    def forced(self) -> int:
        """The track that has a plate only because the cursor is there; 0: none."""
        return self._forced

    def draw(
        self,
        painter: QPainter,
        people: Sequence[PersonMark],
        viewport: Viewport,
        area: QRectF,
        taken: Sequence[QRectF] = (),
        *,
        over: int = 0,
        small: bool = False,
    ) -> list[QRectF]:
        """Draw the plates of those in sight, and tell where they stand.

        Args:
            taken: what they must not lie on. over: the track under the cursor. small: plates of a
                small picture, with less around their words.
        """
        metrics = QFontMetricsF(painter.font())
        seen = [one for one in people if viewport.rect(QRectF(*one.box)).intersects(area)]
        wanted = [_person(one, viewport, metrics, small) for one in seen]
        plates = self._for_cursor(wanted, area, coords(taken), over)
        for one in reversed(plates):
            draw_plate(painter, one.rect, one.text, QColor(*one.mark.colour), one.mark.selected)
        return [one.rect for one in plates]

    def _for_cursor(
        self, people: list[_Person], area: QRectF, taken: Floats, over: int
    ) -> list[_Plate]:
        """As without the cursor, unless the one under it had no name: then they go first."""
        first = sorted(people, key=lambda one: not one.mark.selected)
        plates, self._sides = self._placed(first, area, taken)
        self._named = frozenset(one.mark.track for one in plates)
        self._forced = 0
        if over in {one.mark.track for one in people} - self._named:
            self._forced = over
            first.sort(key=lambda one: one.mark.track != over)
            plates, _ = self._placed(first, area, taken, over)
        return plates

    def _placed(
        self, people: Sequence[_Person], area: QRectF, taken: Floats, over: int = 0
    ) -> tuple[list[_Plate], dict[int, int]]:
        """Plates of those who have one, and on which side; earlier people have the right of way."""
        plates: list[_Plate] = []
        kept = dict(self._sides)
        if not people:
            return plates, kept
        sides = _sides(people)
        shut, crowded = _barred(people, sides, area, taken)
        places = np.zeros((len(people), 4))
        for one, own, never, rather_not in zip(people, sides, shut, crowded, strict=True):
            before = places[: len(plates)]
            closed, usual = never | covers(own, before), self._sides.get(one.mark.track, 0)
            found = _free(one, own, closed | rather_not, usual) or _free(one, own, closed, usual)
            if found is not None:
                plate, kept[one.mark.track] = found
            elif one.mark.selected or one.mark.track == over:
                plate = _Plate(one.mark, one.texts[-1], _least_bad(own[-1], before, area))
            else:
                continue
            places[len(plates)] = np.array(plate.rect.getCoords())
            plates.append(plate)
        return plates, kept


def _free(one: _Person, sides: Floats, closed: Flags, usual: int) -> tuple[_Plate, int] | None:
    """The longest name that has a free side, and which; the usual one if that is free."""
    found = first_free(closed[: len(one.texts)], usual)
    if found is None:
        return None
    size, side = found
    return _Plate(one.mark, one.texts[size], as_rect(sides[size, side])), side


def _least_bad(sides: Floats, plates: Floats, area: QRectF) -> QRectF:
    """Where a name stands that has no free side: if possible on nobody's name."""
    inside = [within(as_rect(side), area) for side in sides]
    return inside[int(np.argmin(covers(coords(inside), plates)))]


def _barred(
    people: Sequence[_Person], sides: Floats, area: QRectF, taken: Floats
) -> tuple[Flags, Flags]:
    """(n, sizes, sides) where a name would hide a head or leave the area, and where others."""
    bodies = np.array([one.box for one in people])
    heads = bodies.copy()
    heads[:, 3] = bodies[:, 1] + _HEAD * (bodies[:, 3] - bodies[:, 1])
    heads = heads[bodies[:, 1] > area.top() + _EDGE_PX]
    shut = beyond(sides, area) | covers(sides, np.concatenate((taken, heads)))
    crowded = np.zeros_like(shut)
    for number, own in enumerate(sides):
        crowded[number] = covers(own, np.delete(bodies, number, axis=0))
    return shut, crowded


def _person(mark: PersonMark, viewport: Viewport, metrics: QFontMetricsF, small: bool) -> _Person:
    box = viewport.rect(QRectF(*mark.box))
    whole, number = plate_text(metrics, mark.label), str(mark.track)
    texts = (whole,) if whole == number else (whole, number)
    pad = _SMALL_PAD_PX if small else PAD_PX
    sizes = plate_sizes(metrics, texts, pad)
    return _Person(mark, np.array(box.getCoords()), texts, sizes)


def _sides(people: Sequence[_Person]) -> Floats:
    """(n, sizes, 8, 4) left, top, right, bottom of plates, best sides first, the last in the box.

    Who has one size only has it twice.
    """
    left, top, right, bottom = np.array([one.box for one in people]).T[:, :, None]
    sizes = np.array([(one.sizes[0], one.sizes[-1]) for one in people])
    width, height = sizes[..., 0], sizes[..., 1]
    above, below, inside = top - _GAP_PX - height, bottom + _GAP_PX, bottom - height
    before, behind, flush = left - _GAP_PX - width, right + _GAP_PX, right - width + 1
    middle, beside = (left + right - width) / 2, top + np.zeros_like(width)
    start, foot = left - 1 + np.zeros_like(width), below + np.zeros_like(width)
    behind = behind + np.zeros_like(width)
    x = np.stack((start, flush, behind, before, middle, behind, before, middle), axis=-1)
    y = np.stack((above, above, beside, beside, foot, inside, inside, inside), axis=-1)
    return np.stack((x, y, x + width[..., None], y + height[..., None]), axis=-1)
