"""Where people's names stand on the floor: beside their rings, and on nobody's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QRectF

from app.core.drawing.rectangles import Flags, Floats, as_rect, beyond, covers, first_free, within

DOT_PX = 3.0
_GAP_PX, _FAR_PX = 3.0, 18.0
_SIDES = ((1, -1), (1, 1), (-1, -1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1))
"""Right or left and below or above; the first that is free is taken, first near, then farther."""
_WAYS = np.array(_SIDES, np.float64)
NEAR = len(_SIDES)
"""Sides from this number on are so far away that a line must tell whose name it is."""


Owner = int | str
"""A track, or the label of somebody of a truth."""


@dataclass(frozen=True, slots=True)
class WantedName:
    """A name that is to stand beside a ring.

    Attributes:
        owner: see `Owner`. at: the ring's middle on the widget. sizes: width and height of the
            whole name, then of shorter ones. must: it stands somewhere in any case.
    """

    owner: Owner
    at: tuple[float, float]
    sizes: Sequence[tuple[float, float]]
    must: bool = False


@dataclass(frozen=True, slots=True)
class Stands:
    """Where a name stands: which of its sizes, on which side of its ring."""

    owner: Owner
    rect: QRectF
    size: int
    side: int


def discs(middles: Floats, reach: float = DOT_PX) -> Floats:
    """(n, 3) middles (n, 2) and their reach: what `place_names` leaves to be seen."""
    return np.column_stack((middles, np.full(len(middles), reach)))


def place_names(
    names: Sequence[WantedName],
    seen: Floats,
    radius: float,
    area: QRectF,
    before: Mapping[Owner, int],
) -> list[Stands]:
    """Names where they hide nothing that is `seen` and no other name; else they are left out.

    Args:
        names: earlier ones have the right of way. seen: see `discs`. radius: of all rings.
        before: the side on which a name stood last; it stays there while that is free.
    """
    if not names:
        return []
    sides = np.stack([_sides(names, number, radius) for number in range(_most_sizes(names))], 1)
    barred = beyond(sides, area) | _touches(sides, seen)
    placed: list[Stands] = []
    plates = np.zeros((len(names), 4))
    for name, own, shut in zip(names, sides, barred, strict=True):
        one = _free(name, own, shut, plates[: len(placed)], before.get(name.owner, 0))
        if one is None and name.must:
            one = _anywhere(name, own, area)
        if one is not None:
            plates[len(placed)] = np.array(one.rect.getCoords())
            placed.append(one)
    return placed


def _most_sizes(names: Sequence[WantedName]) -> int:
    return max(len(one.sizes) for one in names)


def _free(
    name: WantedName, sides: Floats, barred: Flags, plates: Floats, usual: int
) -> Stands | None:
    """The first free side, of the longest name that has one."""
    count = len(name.sizes)
    found = first_free(barred[:count] | covers(sides[:count], plates), usual)
    if found is None:
        return None
    size, side = found
    return Stands(name.owner, as_rect(sides[size, side]), size, side)


def _anywhere(name: WantedName, sides: Floats, area: QRectF) -> Stands:
    """The shortest name where it would stand if it were alone."""
    number = len(name.sizes) - 1
    return Stands(name.owner, within(as_rect(sides[number, 0]), area), number, 0)


def _sides(names: Sequence[WantedName], number: int, radius: float) -> Floats:
    """(n, k, 4) left, top, right, bottom of plates on each side of their rings, near ones first."""
    sizes = [one.sizes[min(number, len(one.sizes) - 1)] for one in names]
    half = np.array(sizes)[:, None] / 2
    near = _WAYS * (radius + _GAP_PX + half)
    near[:, :4, 1] -= _WAYS[:4, 1] * _GAP_PX  # at a corner the ring itself leaves room
    off = np.concatenate((near, near + _WAYS * _FAR_PX), axis=1)
    middles = np.array([one.at for one in names])[:, None] + off
    return np.concatenate((middles - half, middles + half), axis=2)


def _touches(sides: Floats, seen: Floats) -> Flags:
    """(n, sizes, k) whether rectangles (n, sizes, k, 4) lie over any disc (m, 3).

    Only discs that any place of a name could reach are looked at: of a crowd few.
    """
    found = np.zeros(sides.shape[:3], bool)
    if not len(seen):
        return found
    low, high = sides[..., :2].min(axis=(1, 2)), sides[..., 2:].max(axis=(1, 2))
    middles, reach = seen[:, :2], seen[:, 2:]
    near = (middles + reach >= low[:, None]) & (middles - reach <= high[:, None])
    name, disc = np.nonzero(near.all(axis=2))
    there = middles[disc][:, None, None]
    off = np.clip(there, sides[name][..., :2], sides[name][..., 2:]) - there
    hit = (off * off).sum(axis=3) < reach[disc][:, None] ** 2
    np.logical_or.at(found, name, hit)
    return found
