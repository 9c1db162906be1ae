"""Where people's names stand on the floor: beside their rings, and on nobody's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF

Floats = NDArray[np.float64]
_GAP_PX, _FAR_PX = 3.0, 18.0
_SIDES = ((1, -1), (1, 1), (-1, -1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1))
"""Right or left and below or above; the first that is free is taken, first near, then farther."""
NEAR = len(_SIDES)
"""Sides from this number on are so far away that a line must tell whose name it is."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """A name that is to stand beside a ring.

    Attributes:
        at: the ring's middle on the widget. sizes: width and height of the whole name, then of
            shorter ones. must: it stands somewhere in any case.
    """

    track: int
    at: tuple[float, float]
    sizes: Sequence[tuple[float, float]]
    must: bool = False


@dataclass(frozen=True, slots=True)
class Stands:
    """Where a name stands: which of its sizes, on which side of its ring."""

    track: int
    rect: QRectF
    size: int
    side: int


def place_names(
    names: Sequence[Wanted],
    rings: Floats,
    radius: float,
    dots: Floats,
    area: QRectF,
    before: Mapping[int, int],
) -> list[Stands]:
    """Names where they hide no ring, no dot and no other name; left out where there is no place.

    Args:
        names: earlier ones have the right of way. rings, dots: (n, 2) what must stay visible.
        before: the side on which a track's name stood last; it stays there while that is free.
    """
    hidden = np.concatenate((rings, dots)) if len(dots) else rings
    reach = np.concatenate((np.full(len(rings), radius), np.full(len(dots), _GAP_PX)))
    placed: list[Stands] = []
    for name in names:
        one = _free(name, placed, (hidden, reach), radius, area, before.get(name.track, 0))
        if one is not None:
            placed.append(one)
    return placed


def _free(
    name: Wanted,
    placed: Sequence[Stands],
    seen: tuple[Floats, Floats],
    radius: float,
    area: QRectF,
    usual: int,
) -> Stands | None:
    """The first free side, of the longest name that has one."""
    inside = np.array((area.left(), area.top(), area.right(), area.bottom()))
    plates = np.array([one.rect.getCoords() for one in placed]).reshape(-1, 4)
    for number, size in enumerate(name.sizes):
        sides = _sides(np.array(name.at), size, radius)
        out = ((sides[:, :2] < inside[:2]) | (sides[:, 2:] > inside[2:])).any(axis=1)
        hides = out | _covers(sides, plates) | _touches(sides, *seen)
        order = [usual, *range(len(sides))]
        side = next((one for one in order if not hides[one]), None)
        if side is not None:
            return Stands(name.track, _rect(sides[side]), number, side)
    if not name.must:
        return None
    width, height = name.sizes[-1]
    left, top = sides[0, :2]
    left = min(max(left, area.left()), area.right() - width)
    top = min(max(top, area.top()), area.bottom() - height)
    return Stands(name.track, QRectF(left, top, width, height), len(name.sizes) - 1, 0)


def _sides(at: Floats, size: tuple[float, float], radius: float) -> Floats:
    """(n, 4) left, top, right, bottom of a plate on each side of a ring, near ones first."""
    half = np.array(size) / 2
    ways = np.array(_SIDES, np.float64)
    near = ways * (radius + _GAP_PX + half)
    near[:4, 1] -= ways[:4, 1] * _GAP_PX  # at a corner the ring itself leaves room
    far = near + ways * _FAR_PX
    middles = at + np.concatenate((near, far))
    return np.column_stack((middles - half, middles + half))


def _covers(rects: Floats, others: Floats) -> NDArray[np.bool_]:
    """(n,) whether each rectangle (n, 4) lies over any of the others (m, 4)."""
    apart = np.any(rects[:, None, :2] >= others[None, :, 2:], axis=2)
    apart |= np.any(rects[:, None, 2:] <= others[None, :, :2], axis=2)
    return np.asarray(np.any(~apart, axis=1))


def _touches(rects: Floats, middles: Floats, reach: Floats) -> NDArray[np.bool_]:
    """(n,) whether each rectangle (n, 4) lies over any disc: middles (m, 2), reach (m,)."""
    nearest = np.clip(middles[None], rects[:, None, :2], rects[:, None, 2:])
    apart = np.hypot(*np.moveaxis(nearest - middles[None], 2, 0))
    return np.asarray(np.any(apart < reach[None], axis=1))


def _rect(sides: Floats) -> QRectF:
    left, top, right, bottom = sides.tolist()
    return QRectF(left, top, right - left, bottom - top)
