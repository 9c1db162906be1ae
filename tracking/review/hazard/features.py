"""What tells of each row how likely its track goes wrong there: numbers, a column each."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.core.appearance import EVERY_S, swap_gain_of_appearance, unlikeness
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.material import Material
from tracking.review.reasons.jumps import steps_off
from tracking.review.reasons.turns import gains, leads, meetings, miss

Column = NDArray[np.float32]
Columns = dict[str, Column]

_LONG_S = 5.0
"""Beyond it, how far the ends of a track are says no more."""
_NOT_NOTICED = 2.0
"""Margin of a row where nothing had to be chosen."""
_AROUND_S = 0.1
"""What happens in a frame is noticed in those beside it as well."""
_MANY_PAIRS = 10
"""Pairs of people near each other from which on it counts as crowded."""
_APART_S = (-0.5, -0.25, -0.15, 0.15, 0.25, 0.5)
_OF_THE_OTHER = ("unseen_1s", "visibility", "missed", "age_s")
"""What is told of the nearest other one as well."""
FEATURES = (
    *("jump", "jump_0.3s", "missed", "missed_0.15s", "turn", "exchange", "colour", "height"),
    *("unseen_0.5s", "unseen_1s", "seen_again", "visibility", "margin", "margin_0.4s"),
    *("spread", "age_s", "born_s", "speed", "parting", "crowding"),
    *(f"apart_{seconds:+}s" for seconds in _APART_S),
    *(f"other_{name}" for name in _OF_THE_OTHER),
)
"""Names, in the order of the columns."""
NOTICED = ("exchange", "colour", "height", "margin", "margin_0.4s", "spread")
"""Those that need what a run noticed."""


def features(material: Material) -> NDArray[np.float32]:
    """(n, features) of every row of the evidence; NaN where nothing is known.

    Distances in m, times in s, speeds in m/s, margins in units of the association's cost.
    """
    columns: Columns = {}
    for part in (_walks, _pairs, _looks, _sight, _ends):
        columns |= part(material)
    columns |= _others(material, columns)
    return np.stack([columns[name] for name in FEATURES]).T  # each column in one piece


def _walks(material: Material) -> Columns:
    """How the track itself goes on."""
    evidence = material.evidence
    off = _single(np.concatenate((np.zeros(min(len(evidence), 1)), steps_off(evidence))))
    missed = _single(miss(*leads(evidence)))
    return {
        "jump": _greatest(evidence, off, _AROUND_S),
        "jump_0.3s": _greatest(evidence, off, 0.3),
        "missed": missed,
        "missed_0.15s": _greatest(evidence, missed, 0.15),
    }


def _pairs(material: Material) -> Columns:
    """What tells that somebody was changed with: the strongest of all it may have been."""
    evidence, near = material.evidence, material.near
    turned = meetings(material)
    turn = _strongest(evidence, turned, gains(evidence, *turned))
    first, second = near.first, near.second
    looked = np.flatnonzero(evidence.frame[first] % evidence.frames_of(EVERY_S) == 0)
    first, second = first[looked], second[looked]
    track, other, frame = evidence.track[first], evidence.track[second], evidence.frame[first]
    better = swap_gain_of_appearance(material.looks, track, other, frame)
    exchange = _strongest(evidence, (first, second), better)
    return {
        "turn": _greatest(evidence, turn, _AROUND_S),
        "exchange": _greatest(evidence, exchange, _AROUND_S),
    }


def _looks(material: Material) -> Columns:
    """How the track's looks change, and by how much the tracker chose."""
    evidence = material.evidence
    before = material.looks.before(evidence.track, evidence.frame)
    after = material.looks.after(evidence.track, evidence.frame)
    margin = np.nan_to_num(evidence.margin, nan=_NOT_NOTICED).clip(0.0, _NOT_NOTICED)
    return {
        "colour": _single(unlikeness(before[1:], after[1:])),
        "height": _single(np.abs(before[0] - after[0])),
        "margin": -_greatest(evidence, -margin, _AROUND_S),
        "margin_0.4s": -_greatest(evidence, -margin, 0.4),
        "spread": evidence.spread_m,
    }


def _sight(material: Material) -> Columns:
    """How long somebody is out of sight, and for how long seen again."""
    evidence = material.evidence
    first, last = _ends_of_tracks(material)
    unseen = np.concatenate(([0], np.cumsum(evidence.predicted)))
    row = np.arange(len(evidence))

    def share(start_s: float, end_s: float) -> Column:
        low = np.clip(row + round(start_s * evidence.fps), first, last + 1)
        high = np.clip(row + round(end_s * evidence.fps), first, last + 1)
        return _single((unseen[high] - unseen[low]) / np.maximum(high - low, 1))

    return {
        "unseen_0.5s": share(-0.5, 0.0),
        "unseen_1s": share(-1.0, 0.0),
        "seen_again": share(0.05, 0.55),
        "visibility": _single(evidence.visibility),
    }


def _ends(material: Material) -> Columns:
    """How long ago the track began, and how long ago where people do not come from."""
    evidence = material.evidence
    first, _ = _ends_of_tracks(material)
    age_s = np.minimum((evidence.frame - evidence.frame[first]) / evidence.fps, _LONG_S)
    explained = material.at_border(first) | (evidence.frame[first] < evidence.frames_of(0.5))
    return {"age_s": _single(age_s), "born_s": _single(np.where(explained, _LONG_S, age_s))}


def _others(material: Material, known: Columns) -> Columns:
    """How far the nearest other one is, was and will be, and what is known of it."""
    evidence = material.evidence
    nearest = _nearest_rows(material)
    somebody = nearest >= 0
    velocity = _velocity(evidence)
    parting = np.where(somebody, np.hypot(*(velocity - velocity[nearest]).T), np.nan)
    found = {
        "speed": _single(np.hypot(*velocity.T)),
        "parting": _single(parting),
        "crowding": _single(_crowd_density(material, evidence.frame)),
    }
    for seconds in _APART_S:
        then = evidence.later(np.arange(len(evidence)), round(seconds * evidence.fps))
        distance_m = np.where(then >= 0, material.near.nearest_m[then], np.nan)
        found[f"apart_{seconds:+}s"] = _single(distance_m)
    for name in _OF_THE_OTHER:
        found[f"other_{name}"] = np.where(somebody, known[name][nearest], np.float32(np.nan))
    return found


def _single(values: NDArray[np.floating]) -> Column:
    return values.astype(np.float32)


def _greatest(evidence: Evidence, values: Column, around_s: float) -> Column:
    """(n,) the greatest value of each track within so many seconds; what is unknown left out."""
    found = values.copy()
    for before, after, together in _shifted(evidence, round(around_s * evidence.fps)):
        found[before] = np.fmax(found[before], np.where(together, values[after], np.nan))
        found[after] = np.fmax(found[after], np.where(together, values[before], np.nan))
    return found


def _shifted(evidence: Evidence, most: int) -> Iterator[tuple[slice, slice, NDArray[np.bool_]]]:
    """Rows and those 1 to `most` further on, with whether these are so many frames later."""
    for step in range(1, min(most, len(evidence) - 1) + 1):
        before, after = slice(None, -step), slice(step, None)
        yield before, after, evidence.key[after] == evidence.key[before] + step


def _strongest(evidence: Evidence, sides: tuple[Rows, Rows], values: Floats) -> Column:
    """(n,) of each row the greatest value of the pairs it is in; NaN for none."""
    known = np.isfinite(values)
    strongest = np.full(len(evidence), -np.inf)
    for rows in sides:
        np.maximum.at(strongest, rows[known], values[known])
    return _single(np.where(np.isfinite(strongest), strongest, np.nan))


def _ends_of_tracks(material: Material) -> tuple[Rows, Rows]:
    """(n,), (n,) first and last row of each row's track."""
    number = np.searchsorted(material.last, np.arange(len(material.evidence)))
    return material.first[number], material.last[number]


def _nearest_rows(material: Material) -> Rows:
    """(n,) the row of the nearest other one in the frame; -1 where nobody is within reach."""
    near = material.near
    one = np.concatenate((near.first, near.second))
    other = np.concatenate((near.second, near.first))
    order = np.argsort(-np.tile(near.distance_m, 2), kind="stable")
    found = np.full(len(material.evidence), -1)
    found[one[order]] = other[order]
    return found


def _velocity(evidence: Evidence) -> Floats:
    """(n, 2) m/s over 0.3 s around each row, or as much of it as there is."""
    row, step = np.arange(len(evidence)), round(0.15 * evidence.fps)
    before, after = evidence.later(row, -step), evidence.later(row, step)
    before, after = np.where(before >= 0, before, row), np.where(after >= 0, after, row)
    return (evidence.place[after] - evidence.place[before]) / (2 * step) * evidence.fps


def _crowd_density(material: Material, frame: Rows) -> Floats:
    """(k,) 0 to 1, from the pairs of people within reach of each other in each frame.

    Where it is crowded, tracks are wrong more often.
    """
    evidence = material.evidence
    pairs = np.bincount(evidence.frame[material.near.first], minlength=evidence.stop + 1)
    return np.asarray(np.minimum(pairs[np.minimum(frame, evidence.stop)] / _MANY_PAIRS, 1.0))
