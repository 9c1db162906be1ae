"""The two horizontal lines that cut a person into head, torso and hip-leg."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

START = (0.15, 0.48)
"""Where neck and hip are before anything is seen, as shares of the person's height."""
_FARTHEST = (0.04, 0.08)
"""A line that strays farther from its start goes back to it; shares of the height."""
_LOOK_AHEAD = 0.02
"""How far up and down a line looks for a larger difference; share of the height."""


def decompose(
    mask: NDArray[np.uint8] | NDArray[np.bool_], picture: NDArray[np.uint8], box: Floats
) -> Floats:
    """(2,) rows in px of the lines under the head and under the torso.

    [ZhaoLee2009] section 4.1: the lines start at fixed shares of the height and move while the
    difference of the mean colours on both sides grows; one that strays goes back to its start.
    Where we differ: a line looks a few rows ahead, so that one noisy row does not stop it.

    Args:
        mask: (height, width) non-zero where the person is seen.
        picture: (height, width, 3) any colours in which distances mean something.
        box: (4,) left, top, width, height in px of the whole person; it may reach out of the
            picture or of what is seen.

    Returns:
        Boundaries between rows: a row v belongs to the head where v < lines[0].
    """
    left, top, width, height = (float(value) for value in box)
    first, stop = np.clip((np.floor(top), np.ceil(top + height)), 0, mask.shape[0]).astype(int)
    across = slice(*np.clip((int(left), int(np.ceil(left + width))), 0, mask.shape[1]))
    own = (mask[first:stop, across] > 0).astype(np.float32)
    colours = picture[first:stop, across].astype(np.float32)
    count = _summed(own.sum(axis=1)[:, None])
    colour = _summed(np.einsum("vu,vuc->vc", own, colours))
    lines = np.array([top + height * share for share in START])
    for k in (0, 1):
        edges = (first, *lines, stop)
        ends = np.clip(np.rint((edges[k], edges[k + 2])) - first, 0, stop - first).astype(int)
        difference = _differences(count, colour, int(ends[0]), int(ends[1]))
        lines[k] = _climbed(difference, float(lines[k]) - first, k, height) + first
    return lines


def _differences(count: Floats, colour: Floats, above: int, below: int) -> Floats:
    """(rows + 1,) how far apart the mean colours are on both sides of each boundary.

    Args:
        count, colour: running sums (rows + 1, 1) and (rows + 1, 3) of pixels and their colours.
        above, below: the outer boundaries of the two sections.

    Returns:
        -1 where a side shows nothing.
    """
    over, under = count - count[above], count[below] - count
    apart = (colour - colour[above]) / np.maximum(over, 1)
    apart -= (colour[below] - colour) / np.maximum(under, 1)
    seen = (over > 0) & (under > 0)
    return np.where(seen[:, 0], np.sqrt(np.einsum("vc,vc->v", apart, apart)), -1.0)


def _climbed(difference: Floats, start: float, k: int, height: float) -> float:
    """The boundary where line k comes to rest."""
    step = max(1, round(_LOOK_AHEAD * height))
    place = round(start)
    if not 0 <= place < len(difference):
        return start
    while True:
        low = max(place - step, 0)
        best = low + int(difference[low : place + step + 1].argmax())
        if difference[best] <= difference[place]:
            return float(place)
        place = best
        if abs(place - start) > max(1.0, _FARTHEST[k] * height):
            return start


def _summed(rows: NDArray[np.float32]) -> Floats:
    """Running sums with a row of zeros before the first."""
    total = np.cumsum(rows, axis=0, dtype=np.float64)
    return np.concatenate((np.zeros((1, rows.shape[1])), total))
