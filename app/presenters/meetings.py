"""Who is there at the same time, and who comes near whom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns

_NEAR_M = 5.0
"""Who comes no nearer is not near at all."""
FAR = 0.3
"""How near people are who are not near at all, but there at the same time."""
_USUAL_HEIGHT_M = 1.7
_LOOKS = 300
"""In so many frames, evenly spread, it is looked who is near whom."""
_SMALL_IDS = 1_000_000
"""Up to here ids are places in an array."""

Near = dict[tuple[int, int], float]


@dataclass(frozen=True, slots=True)
class Meetings:
    """Who is there when, and near whom.

    Attributes:
        stays: first frame, last frame and id of each track, in this order.
        nearness: of two ids, the smaller one first, where they are near: up to 1, in one place.
    """

    stays: tuple[tuple[int, int, int], ...] = ()
    nearness: Mapping[tuple[int, int], float] = field(default_factory=dict)

    def near(self, one: int, other: int) -> float:
        """How near two come to each other who are there together: 0.3 to 1."""
        return self.nearness.get((min(one, other), max(one, other)), FAR)


def meetings_of(rows: Columns) -> Meetings:
    """Meetings in rows that stand by frame; places are sampled."""
    frame, track = rows["frame"], rows["track"]
    if not len(frame):
        return Meetings()
    nearness: Near = {}
    for look in np.unique(np.linspace(0, len(frame) - 1, _LOOKS).astype(int)).tolist():
        start, stop = np.searchsorted(frame, (frame[look], frame[look] + 1))
        part = {name: rows[name][start:stop] for name in ("track", *_PLACE)}
        for (one, other), much in _pairs(part).items():
            nearness[one, other] = max(nearness.get((one, other), 0.0), much)
    return Meetings(_stays(frame, track), nearness)


def closeness(rows: Columns) -> dict[int, dict[int, float]]:
    """For each track of one frame's rows how near all others are; see `Meetings.near`."""
    here = Meetings((), _pairs(rows))
    ids = rows["track"].tolist()
    return {one: {other: here.near(one, other) for other in ids if other != one} for one in ids}


_PLACE = ("x", "y", "left", "top", "width", "height")


def _pairs(rows: Columns) -> Near:
    """Those of one frame who are near each other, and how near."""
    places, ids = _places(rows), rows["track"]
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    first, second = np.nonzero(np.triu(np.nan_to_num(apart, nan=np.inf) < _NEAR_M, 1))
    low, high = np.minimum(ids[first], ids[second]), np.maximum(ids[first], ids[second])
    much = FAR + (1.0 - FAR) * np.square(1.0 - apart[first, second] / _NEAR_M)
    pairs = zip(low.tolist(), high.tolist(), strict=True)
    return dict(zip(pairs, much.tolist(), strict=True))


def _places(rows: Columns) -> NDArray[np.float64]:
    """(n, 2) m on the floor; where that is not known in the picture, bodies of usual height."""
    floor = np.column_stack((rows["x"], rows["y"])).astype(float)
    if np.isfinite(floor).all(axis=1).any() or not len(floor):
        return floor
    height = np.nanmedian(rows["height"]) if np.isfinite(rows["height"]).any() else np.nan
    middle = rows["left"] + rows["width"] / 2, rows["top"] + rows["height"] / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.column_stack(middle).astype(float) * _USUAL_HEIGHT_M / height


def _stays(frame: NDArray[np.int32], track: NDArray[np.int32]) -> tuple[tuple[int, int, int], ...]:
    ids = np.arange(int(track.max()) + 1) if track.max() < _SMALL_IDS else np.unique(track)
    at = track if len(ids) and ids[-1] + 1 == len(ids) else np.searchsorted(ids, track)
    first, last = np.full(len(ids), -1), np.full(len(ids), -1)
    first[at[::-1]], last[at] = frame[::-1], frame  # what is written last stays
    known = np.flatnonzero(last >= 0)
    stays = zip(first[known].tolist(), last[known].tolist(), ids[known].tolist(), strict=True)
    return tuple(sorted(stays))
