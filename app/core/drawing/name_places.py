"""Where names stand, whatever they name: on nothing that is to be seen, and on no other name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QRectF

from app.core.drawing.rectangles import (
    Flags,
    Floats,
    above,
    as_rect,
    beyond,
    coords,
    covers,
    within,
)

_GAP_PX = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Name:
    """A name and where it could stand.

    Attributes:
        sides: (sizes, sides, 4) left, top, right, bottom: of the whole name first, then of shorter
            ones; the best side first.
        shut: (sizes, sides) where it must not stand. crowded: where it stands rather not.
        usual: the side it has if that is free. must: it stands somewhere in any case.
    """

    sides: Floats
    shut: Flags
    crowded: Flags | bool = False
    usual: int = 0
    must: bool = False


@dataclass(frozen=True, slots=True)
class Stands:
    """Where a name stands: which of its sizes, on which of its sides."""

    rect: QRectF
    size: int
    side: int


def place_names(
    names: Sequence[Name], area: QRectF, taken: Sequence[QRectF] = ()
) -> list[Stands | None]:
    """A place for each name, one after the other: earlier ones have the right of way.

    A name is shortened before it is left out, which is None.

    Args:
        area: where names may stand. taken: what a name that must stand is kept off, too.
    """
    plates, count = np.zeros((len(names), 4)), 0
    placed: list[Stands | None] = []
    for name in names:
        before = plates[:count]
        closed = name.shut | covers(name.sides, before)
        one = _free(name, closed | name.crowded) or _free(name, closed)
        if one is None and name.must:
            one = _least_bad(name, before, area, taken)
        if one is not None:
            plates[count] = np.array(one.rect.getCoords())
            count += 1
        placed.append(one)
    return placed


def place_plates(
    wanted: Sequence[QRectF], area: QRectF, taken: Sequence[QRectF] = ()
) -> list[QRectF]:
    """Rectangles, moved up or down where they would overlap; earlier ones stay where they are.

    taken: where other words stand, which they keep off.

    Where the area is too full for all, the rest overlaps.
    """
    placed = place_names([column(rect, area, taken) for rect in wanted], area, taken)
    return [one.rect for one in placed if one is not None]


def column(wanted: QRectF, area: QRectF, taken: Sequence[QRectF] = ()) -> Name:
    """A name that must stand: near above or below the wanted place, rather off what is taken."""
    inside = within(wanted, area)
    step = (inside.height() + _GAP_PX) / 2
    steps = np.arange(1, math.ceil(area.height() / step) + 1) * step
    down = np.concatenate(([0.0], np.column_stack((steps, -steps)).ravel()))
    sides = coords([inside]) + down[:, None] * (0.0, 1.0, 0.0, 1.0)
    crowded = covers(sides, coords(taken))[None]
    return Name(sides[None], beyond(sides, area)[None], crowded, must=True)


def _free(name: Name, closed: Flags) -> Stands | None:
    """The longest name that has a free side; the usual side if that is free."""
    open_sizes = np.flatnonzero(~closed.all(axis=1))
    if not len(open_sizes):
        return None
    size = int(open_sizes[0])
    side = name.usual if not closed[size, name.usual] else int(np.argmin(closed[size]))
    return Stands(as_rect(name.sides[size, side]), size, side)


def _least_bad(name: Name, plates: Floats, area: QRectF, taken: Sequence[QRectF]) -> Stands:
    """The shortest name: if possible on no other name, nor on what is taken."""
    inside = [within(as_rect(side), area) for side in name.sides[-1]]
    inside += [within(above(one, taken), area) for one in inside]
    at = coords(inside)
    best = int(np.argmin(2 * covers(at, plates) + covers(at, coords(taken))))
    return Stands(inside[best], len(name.sides) - 1, best % name.sides.shape[1])
