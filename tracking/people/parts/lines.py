"""The two horizontal lines that cut a person into head, torso and hip-leg."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

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

    Args:
        mask: (height, width) non-zero where the person is seen.
        picture: (height, width, 3) any colours in which distances mean something.
        box: (4,) left, top, width, height in px of the whole person; it may reach out of the
            picture or of what is seen.

    Returns:
        Boundaries between rows: a row v belongs to the head where v < lines[0].
    """
    left, top, width, height = (float(value) for value in box)
    rows = _RowColours(mask, picture, (left, top, width, height))
    lines = np.array([top + height * share for share in START])
    for k in (0, 1):
        lines[k] = rows.climb(k, lines, height)
    return lines


class _RowColours:
    """Sums of colour over the rows of a person, and the climb of a line over them."""

    def __init__(
        self,
        mask: NDArray[np.uint8] | NDArray[np.bool_],
        picture: NDArray[np.uint8],
        box: tuple[float, float, float, float],
    ) -> None:
        left, top, width, height = box
        self.top = int(np.clip(np.floor(top), 0, mask.shape[0]))
        self.bottom = int(np.clip(np.ceil(top + height), self.top, mask.shape[0]))
        across = slice(*np.clip((int(left), int(np.ceil(left + width))), 0, mask.shape[1]))
        own = (mask[self.top : self.bottom, across] > 0).astype(np.float32)
        colours = picture[self.top : self.bottom, across].astype(np.float32)
        self._count = _summed(own.sum(axis=1)[:, None])
        self._colour = _summed(np.einsum("vu,vuc->vc", own, colours))

    def climb(self, k: int, lines: Floats, height: float) -> float:
        """Where line k comes to rest, the other one standing still."""
        start = lines[k]
        reach = max(1.0, _FARTHEST[k] * height)
        step = max(1, round(_LOOK_AHEAD * height))
        place = round(float(start))
        best = self._difference(k, lines, place)
        while True:
            around = [v for v in range(place - step, place + step + 1) if v != place]
            found = [self._difference(k, lines, v) for v in around]
            if not found or max(found) <= best:
                return float(place)
            best = max(found)
            place = around[found.index(best)]
            if abs(place - start) > reach:
                return float(start)

    def _difference(self, k: int, lines: Floats, place: int) -> float:
        """Distance of the mean colours above and below, -1 where a side shows nothing."""
        edges = [self.top, *lines, self.bottom]
        edges[k + 1] = place
        above = self._mean(edges[k], place)
        below = self._mean(place, edges[k + 2])
        if above is None or below is None:
            return -1.0
        return float(np.linalg.norm(above - below))

    def _mean(self, first: float, stop: float) -> Floats | None:
        low, high = (
            int(np.clip(round(float(v)), self.top, self.bottom)) - self.top for v in (first, stop)
        )
        count = float(self._count[high, 0] - self._count[low, 0])
        if high <= low or count <= 0:
            return None
        return np.asarray((self._colour[high] - self._colour[low]) / count, np.float64)


def _summed(rows: NDArray[np.float32]) -> Floats:
    """Running sums with a row of zeros before the first."""
    total = np.cumsum(rows, axis=0, dtype=np.float64)
    return np.concatenate((np.zeros((1, rows.shape[1])), total))
