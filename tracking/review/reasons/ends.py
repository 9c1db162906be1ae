"""Tracks that end or begin in the middle of the floor."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.review.core.appearance import unlikeness
from tracking.review.core.evidence import Rows
from tracking.review.core.findings import FlaggedPlaces, join_findings, of_pairs, of_tracks, ramp
from tracking.review.core.material import Material

_LONGEST_S = 6.0
_OVERLAP_S = 0.5
_REACH_M, _REACH_M_PER_S, _FARTHEST_M = 1.0, 0.8, 3.5
_ALIKE, _UNLIKE = 0.5, 4.0
_LEAD_S = 0.5
"""How long a walk is led on as it was."""
_ENDS_OF_FOOTAGE_S = 0.5
_ALONE = 0.5
"""Strength where nobody is near who could have to do with it."""


def lost_and_found(material: Material) -> FlaggedPlaces:
    """Where a track ends in the middle of the floor and another begins near, soon after.

    The frame is that of the beginning: there the person is seen under the wrong name.
    """
    begins, ends = _middle_of_floor(material)
    lost, found = _candidates(material, ends, begins)
    evidence = material.evidence
    gap_s = (evidence.frame[found] - evidence.frame[lost]) / evidence.fps
    led = evidence.place[lost] + _way(material, lost) * np.clip(gap_s, 0.0, _LEAD_S)[:, None]
    apart = np.hypot(*(evidence.place[found] - led).T)
    reach = np.minimum(_REACH_M + _REACH_M_PER_S * np.maximum(gap_s, 0.0), _FARTHEST_M)
    looks = material.looks
    unlike = unlikeness(
        looks.before(evidence.track[lost], evidence.frame[lost] + 1),
        looks.after(evidence.track[found], evidence.frame[found]),
    )
    near = ramp(apart / reach, 1.0, 0.0)
    alike = np.where(np.isfinite(unlike), ramp(unlike, _UNLIKE, _ALIKE), 0.5)
    strength = np.where(near > 0, 0.2 * near + 0.8 * near * alike, 0.0)
    return of_pairs(
        *("lost", evidence.track[lost], evidence.track[found], evidence.frame[found]),
        strength,
        gap_s,
    )


def endings(material: Material) -> FlaggedPlaces:
    """Where a track ends in the middle of the floor: whoever is near may have taken it over."""
    return _beside("ended", material, _middle_of_floor(material)[1])


def beginnings(material: Material) -> FlaggedPlaces:
    """Where a track begins in the middle of the floor: whoever is near may have left it."""
    return _beside("begun", material, _middle_of_floor(material)[0])


def _beside(kind: str, material: Material, rows: Rows) -> FlaggedPlaces:
    """The rows' tracks, with whoever is near."""
    evidence = material.evidence
    other, track, frame = material.nearest[rows], evidence.track[rows], evidence.frame[rows]
    distance_m = material.near.nearest_m[rows]
    strength = np.where(other > 0, 1.0, _ALONE)
    alone, near = np.flatnonzero(other == 0), np.flatnonzero(other > 0)
    return join_findings(
        (
            of_pairs(kind, track[near], other[near], frame[near], strength[near], distance_m[near]),
            of_tracks(kind, track[alone], frame[alone], strength[alone], distance_m[alone]),
        )
    )


def _middle_of_floor(material: Material) -> tuple[Rows, Rows]:
    """First and last seen rows of tracks that begin and that end in the middle of the floor."""
    evidence = material.evidence
    slack = evidence.frames_of(_ENDS_OF_FOOTAGE_S)
    begins, ends = material.first, material.last
    begun = int(evidence.frame.min(initial=0))
    begins = begins[evidence.frame[begins] > begun + slack]
    ends = ends[evidence.frame[ends] < evidence.stop - 1 - slack]
    return begins[_inside(material, begins)], ends[_inside(material, ends)]


def _inside(material: Material, rows: Rows) -> Flags:
    """(k,) whether nothing near explains that a track ends: no border, no occluder."""
    return ~material.at_border(rows) & ~material.at_occluder(rows)


def _candidates(material: Material, ends: Rows, begins: Rows) -> tuple[Rows, Rows]:
    """All pairs of an end and a beginning soon after it, as rows."""
    evidence = material.evidence
    begins = begins[np.argsort(evidence.frame[begins], kind="stable")]
    frames = evidence.frame[begins]
    overlap, longest = (evidence.frames_of(s) for s in (_OVERLAP_S, _LONGEST_S))
    low = np.searchsorted(frames, evidence.frame[ends] - overlap)
    high = np.searchsorted(frames, evidence.frame[ends] + longest)
    count = np.maximum(high - low, 0)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    lost, found = np.repeat(ends, count), begins[np.repeat(low, count) + within]
    other = evidence.track[lost] != evidence.track[found]
    return lost[other], found[other]


def _way(material: Material, rows: Rows) -> Floats:
    """(k, 2) m/s walked in the last moment before each row."""
    evidence = material.evidence
    back = evidence.frames_of(_LEAD_S)
    before = evidence.row_from(evidence.track[rows], np.maximum(evidence.frame[rows] - back, 0))
    frames = np.maximum(evidence.frame[rows] - evidence.frame[before], 1)
    way = evidence.place[rows] - evidence.place[before]
    return np.asarray(np.nan_to_num(way / frames[:, None] * evidence.fps))
