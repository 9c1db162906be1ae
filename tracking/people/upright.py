"""What of the foreground is a body and what its shadow, once it is known where bodies stand."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.silhouette_split import Placed

Bools = NDArray[np.bool_]

BODY, PERHAPS, SHADOW = 255, 1, 127
"""Kinds of foreground: neither shadow nor like one, shadow if it lies on the floor, shadow."""

_HAIR, _HAIR_ACROSS = (-0.09, 0.16), 0.24
"""Dark hair over a dark wall looks like shadow, but shadows lie on floors: along and across."""
_CHEST, _CHEST_ACROSS = (0.12, 0.55), 0.4
_LEGS, _LEGS_ACROSS = (0.5, 0.94), 0.5
_LOW = 0.66
"""From here on down what looks a little like shadow, and is not over a shoe, is shadow."""
_SPECK = 2
"""So many pixels of a column may be noise."""
_LEGS_SEEN = 0.5
"""With fewer pixels of legs than this share of those like shadow, trousers look like shadow."""


def body_pixels(
    kind: NDArray[np.uint8], place: Placed, column: NDArray[np.intp], reach: NDArray[np.float64]
) -> Bools:
    """(n,) which pixels are people.

    A picture alone does not tell a shadow from dull clothes. Where bodies stand does: shadows lie
    on the floor, so what looks like shadow in the middle of a head or a chest is none, and what
    looks only a little like it beside the feet is one.

    Args:
        kind: (n,) `BODY`, `PERHAPS` or `SHADOW`.
        place: of the pixels on bodies.
        column: (n,) of the pixels, from 0.
        reach: (bodies,) of the bodies.
    """
    along, across = place.along, place.across
    shadow = kind == SHADOW
    restored = _within(along, _HAIR) & (across < _HAIR_ACROSS)
    restored |= _within(along, _CHEST) & (across < _CHEST_ACROSS)
    legs = _within(along, _LEGS) & (across < _LEGS_ACROSS)
    restored |= legs & _without_legs(legs, shadow, place, len(reach))[place.body]
    own = ~shadow | restored
    low = along > _LOW
    own &= (kind != PERHAPS) | ~low | _over(along, column, low & (kind == BODY))
    return np.asarray(own & (along < reach[place.body]), np.bool_)


def _over(along: NDArray[np.float32], column: NDArray[np.intp], body: Bools) -> Bools:
    """Which pixels have some of the body below them in their column, more than a speck."""
    body = body & (np.bincount(column[body], minlength=column.max(initial=0) + 1) > _SPECK)[column]
    lowest = np.full(int(column.max(initial=0)) + 1, -np.inf, np.float32)
    np.maximum.at(lowest, column[body], along[body])
    return np.asarray(along < lowest[column], np.bool_)


def _without_legs(legs: Bools, shadow: Bools, place: Placed, count: int) -> Bools:
    """(count,) bodies whose legs are nearly all taken for shadow."""
    like = np.bincount(place.body[legs & shadow], minlength=count)
    unlike = np.bincount(place.body[legs & ~shadow], minlength=count)
    return np.asarray(unlike < _LEGS_SEEN * like, np.bool_)


def _within(values: NDArray[np.float32], bounds: tuple[float, float]) -> Bools:
    return np.asarray((values > bounds[0]) & (values < bounds[1]), np.bool_)
