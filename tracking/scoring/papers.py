"""The papers' own measures: people kept under one id, and how far off they stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.scoring.comparison import Comparison
from tracking.scoring.matching import Candidates
from tracking.scoring.table import Flags, Integers

DETECTED_AFTER = 10
"""Frames in which a person is matched before it counts as detected."""


@dataclass(frozen=True, slots=True)
class People:
    """[Kawashita2012], [Kawashita2014]: people whose id stays the same.

    Attributes:
        detected: people matched in at least `DETECTED_AFTER` frames.
        kept: those of them whose matches all bear one id, which no other person bore before or
            between, in at least half of their frames from the first match on.
    """

    detected: int
    kept: int


@dataclass(frozen=True, slots=True)
class PositionError:
    """Distance on the floor between matched rows, in metres; NaN without any."""

    mean: float
    std: float
    median: float
    p95: float


def people(comparison: Comparison, matched: Candidates) -> People:
    """Count the people who are detected and those who are kept."""
    person = comparison.person[matched.rows.truth]
    matches = np.bincount(person, minlength=comparison.people)
    detected = matches >= DETECTED_AFTER
    long_enough = 2 * matches >= _frames_from_first_match(comparison, matched)
    kept = detected & long_enough & _one_id_of_its_own(comparison, matched)
    return People(detected=int(detected.sum()), kept=int(kept.sum()))


def _one_id_of_its_own(comparison: Comparison, matched: Candidates) -> Flags:
    """(people,) every match bears one track, borne by nobody else before the last of them."""
    person = comparison.person[matched.rows.truth]
    track = comparison.identity[matched.rows.result]
    match = np.arange(len(person))
    first = _first(person, match, comparison.people)
    last = np.zeros(comparison.people, np.int64)
    last[person] = match
    one_id = np.ones(comparison.people, bool)
    one_id[person[track != track[first[person]]]] = False
    bearer = person[_first(track, match, comparison.identities)[track]]
    foreign = person != bearer
    handed_on = _first(track[foreign], match[foreign], comparison.identities)
    own = (bearer == person) & (last[person] < handed_on[track])
    one_id[person[~own]] = False
    return one_id


def _first(group: Integers, value: Integers, groups: int) -> Integers:
    """(groups,) each group's first value; beyond any match where it has none."""
    first = np.full(groups, np.iinfo(np.int64).max)
    first[group[::-1]] = value[::-1]
    return first


def _frames_from_first_match(comparison: Comparison, matched: Candidates) -> Integers:
    """(people,) in how many frames a person stands from its first match on."""
    person = comparison.person
    order = np.argsort(person, kind="stable")
    frames = comparison.frames_of_people()
    before = np.empty(len(person), np.int64)
    before[order] = np.arange(len(person)) - np.repeat(np.cumsum(frames) - frames, frames)
    first = np.zeros(comparison.people, np.int64)
    rows = matched.rows.truth[::-1]
    first[person[rows]] = before[rows]
    return np.asarray(frames - first)


def position_error(comparison: Comparison, matched: Candidates) -> PositionError:
    """Statistics of the distance between matched rows that both have a position."""
    truth, result = comparison.truth.position, comparison.result.position
    apart = truth[matched.rows.truth] - result[matched.rows.result]
    distance_m = np.hypot(apart[:, 0], apart[:, 1])
    distance_m = distance_m[~np.isnan(distance_m)]
    if not len(distance_m):
        return PositionError(np.nan, np.nan, np.nan, np.nan)
    return PositionError(
        mean=float(distance_m.mean()),
        std=float(distance_m.std()),
        median=float(np.median(distance_m)),
        p95=float(np.percentile(distance_m, 95)),
    )
