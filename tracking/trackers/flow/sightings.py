"""People looked for in foreground that nobody explains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.silhouettes import (
    Mask,
    Spots,
    add_to_cover,
    draw_cover,
    may_stand,
    score_spots,
    spots_at,
)

Floats = NDArray[np.float64]

_ALONG_SHARE, _ACROSS_M = 0.06, 0.18
"""Between the places of the grid."""
_NEAREST_M, _FARTHEST_M = 0.3, 14.0
_MOST_A_FRAME = 4
_OWN_WEIGHT = 0.2
_SAME_M = 0.45
"""As far a sighting may be from that of the frame before."""


@dataclass(frozen=True, slots=True, eq=False)
class Sightings:
    """Places at which somebody was seen who is not followed yet.

    Attributes:
        place: (k, 2) m. first: (k, 2) m where each was seen first. age_s: (k,) since then.
    """

    place: Floats
    first: Floats
    age_s: Floats

    def __len__(self) -> int:
        """How many there are."""
        return len(self.place)

    @classmethod
    def none(cls) -> Sightings:
        """No sightings."""
        return cls(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0))

    def update(self, place: Floats, elapsed_s: float) -> Sightings:
        """Those of the next frame, each as old as the one it continues."""
        first, age_s = place.copy(), np.zeros(len(place))
        left = np.ones(len(self), bool)
        for row, spot in enumerate(place):
            away = np.where(left, np.hypot(*(self.place - spot).T), np.inf)
            if len(away) and away.min() < _SAME_M:
                old = int(away.argmin())
                left[old] = False
                first[row], age_s[row] = self.first[old], self.age_s[old] + elapsed_s
        return Sightings(place, first, age_s)


class FloorGrid:
    """Places all over the floor in sight, with the pixels at which bodies there would be seen."""

    def __init__(self, floor: Floor) -> None:
        self._floor = floor
        self.place = _in_sight(floor)
        self._spots: Spots = spots_at(self.place, floor)

    def find_people(
        self, followed: Floats, mask: Mask, least: tuple[float, float, float], apart_m: float
    ) -> Floats:
        """(k, 2) m places of people who are not followed, the best first.

        One is taken after the other, as each explains foreground that then proves nobody else.

        Args:
            followed: (m, 2) m where people are known to be.
            least: score, seen and own of a `Fit` that convince.
            apart_m: from the people followed and from each other.
        """
        cover = draw_cover(followed, self._floor)
        rows = np.flatnonzero(may_stand(self._spots, mask, cover))
        rows = rows[self._free(rows, followed, apart_m)]
        found: list[Floats] = []
        while len(rows) and len(found) < _MOST_A_FRAME:
            fit = score_spots(self._spots.select(rows), mask, cover)
            good = (fit.score >= least[0]) & (fit.seen >= least[1]) & (fit.own >= least[2])
            if not good.any():
                break
            best = np.where(good, fit.score + _OWN_WEIGHT * fit.own, -1.0).argmax()
            found.append(self.place[rows[best]])
            rows = rows[good]  # others explain more, never less
            rows = rows[self._free(rows, found[-1][None], apart_m)]
            cover = add_to_cover(cover, found[-1], self._floor)
        return np.array(found).reshape(-1, 2)

    def _free(self, rows: NDArray[np.intp], people: Floats, apart_m: float) -> NDArray[np.bool_]:
        """Which places, by number, are far enough from all these people (m, 2)."""
        away = self.place[rows][:, None] - people
        return np.asarray((np.hypot(away[..., 0], away[..., 1]) > apart_m).all(axis=1), np.bool_)


def _in_sight(floor: Floor) -> Floats:
    """(k, 2) m places, evenly along and across the sight, whose chest or head is in the picture."""
    steps = int(np.log(_FARTHEST_M / _NEAREST_M) / _ALONG_SHARE)
    far = _NEAREST_M * np.exp(np.arange(steps) * _ALONG_SHARE)
    half = np.arange(-60, 61) * _ACROSS_M
    ring = []
    for reach in far:
        angle = half / reach
        angle = angle[np.abs(angle) < np.pi]
        ring.append(np.column_stack((np.sin(angle), np.cos(angle))) * reach)
    place = np.concatenate(ring)
    size = np.array(floor.view.camera.size)
    inside = np.zeros(len(place), bool)
    for height_m in (1.2, 1.6):
        pixel = floor.pixels(place, np.array(height_m))
        inside |= ((pixel >= 0) & (pixel < size)).all(axis=1)
    return place[inside]
