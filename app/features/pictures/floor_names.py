"""Where people's names stand on the floor: beside their rings, and on nobody's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QRectF

from app.core.drawing.name_places import Name, Stands, place_names
from app.core.drawing.rectangles import Flags, Floats, beyond

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


def discs(middles: Floats, reach: float = DOT_PX) -> Floats:
    """(n, 3) middles (n, 2) and their reach: what `place_floor_names` leaves to be seen."""
    return np.column_stack((middles, np.full(len(middles), reach)))


def place_floor_names(
    names: Sequence[WantedName],
    seen: Floats,
    radius: float,
    area: QRectF,
    before: Mapping[Owner, int],
) -> dict[Owner, Stands]:
    """Names where they hide nothing that is `seen` and no other name; else they are left out.

    Args:
        names: earlier ones have the right of way. seen: see `discs`. radius: of all rings.
        before: the side on which a name stood last; it stays there while that is free.
    """
    if not names:
        return {}
    sides = np.stack([_sides(names, number, radius) for number in range(_most_sizes(names))], 1)
    barred = beyond(sides, area) | _touches(sides, seen)
    wanted = []
    for name, own, shut in zip(names, sides, barred, strict=True):
        sizes, usual = slice(len(name.sizes)), before.get(name.owner, 0)
        wanted.append(Name(own[sizes], shut[sizes], usual=usual, must=name.must))
    placed = zip(names, place_names(wanted, area), strict=True)
    return {name.owner: stands for name, stands in placed if stands is not None}


def _most_sizes(names: Sequence[WantedName]) -> int:
    return max(len(one.sizes) for one in names)


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
