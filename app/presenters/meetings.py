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

Near = dict[int, dict[int, float]]


@dataclass(frozen=True, slots=True)
class Meetings:
    """Who is there when, and near whom.

    Attributes:
        stays: first frame, last frame and id of each track, in this order.
        nearness: of an id those who come near, and how near: up to 1, in one place.
    """

    stays: tuple[tuple[int, int, int], ...] = ()
    nearness: Mapping[int, Mapping[int, float]] = field(default_factory=dict)

    def near_of(self, track: int) -> Mapping[int, float]:
        """Who comes near, and how near: from `FAR` to 1."""
        return self.nearness.get(track, {})


def meetings_of(rows: Columns) -> Meetings:
    """Meetings in rows that stand by frame; places are sampled."""
    frame, track = rows["frame"], rows["track"]
    if not len(frame):
        return Meetings()
    nearness: Near = {}
    for look in np.unique(np.linspace(0, len(frame) - 1, _LOOKS).astype(int)).tolist():
        start, stop = np.searchsorted(frame, (frame[look], frame[look] + 1))
        part = {name: rows[name][start:stop] for name in ("track", *_PLACE)}
        for one, near in _nearness(part).items():
            mine = nearness.setdefault(one, {})
            for other, much in near.items():
                mine[other] = max(mine.get(other, 0.0), much)
    return Meetings(_stays(frame, track), nearness)


def closeness(rows: Columns) -> Near:
    """For each track of one frame's rows how near all others are, from `FAR` to 1."""
    ids, near = rows["track"].tolist(), _nearness(rows)
    return {
        one: {**{other: FAR for other in ids if other != one}, **near.get(one, {})} for one in ids
    }


_PLACE = ("x", "y", "left", "top", "width", "height")


def _nearness(rows: Columns) -> Near:
    """Those of one frame who are near each other, and how near."""
    places, ids = _places(rows), rows["track"].tolist()
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    np.fill_diagonal(apart, np.inf)
    with np.errstate(invalid="ignore"):
        first, second = np.nonzero(apart < _NEAR_M)
    much = FAR + (1.0 - FAR) * np.square(1.0 - apart[first, second] / _NEAR_M)
    near: Near = {}
    for a, b, how in zip(first.tolist(), second.tolist(), much.tolist(), strict=True):
        near.setdefault(ids[a], {})[ids[b]] = how
    return near


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
