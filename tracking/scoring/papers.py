"""The papers' own measures: people kept under one id, and how far off they stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.comparison import Comparison
from tracking.scoring.pairs import Candidates

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


@dataclass(frozen=True, slots=True, eq=False)
class PositionError:
    """Distance on the floor between matched rows, in metres; its numbers are NaN without any.

    Attributes:
        distances_m: (k,) of the pairs in which both have a position.
    """

    distances_m: Floats

    @classmethod
    def of(cls, distances_m: Floats) -> PositionError:
        """Of distances among which NaN stands for unknown."""
        return cls(distances_m[~np.isnan(distances_m)])

    @property
    def mean(self) -> float:
        """Arithmetic mean."""
        return float(self.distances_m.mean()) if len(self.distances_m) else np.nan

    @property
    def std(self) -> float:
        """Standard deviation of the pairs themselves (not of a sample)."""
        return float(self.distances_m.std()) if len(self.distances_m) else np.nan

    @property
    def median(self) -> float:
        """Half are no larger."""
        return float(np.median(self.distances_m)) if len(self.distances_m) else np.nan

    @property
    def p95(self) -> float:
        """95 % are no larger."""
        return float(np.percentile(self.distances_m, 95)) if len(self.distances_m) else np.nan


def people(comparison: Comparison, matched: Candidates) -> People:
    """Count the people who are detected and those who are kept."""
    detected, kept = detected_and_kept(comparison, matched)
    return People(detected=int(detected.sum()), kept=int(kept.sum()))


def detected_and_kept(comparison: Comparison, matched: Candidates) -> tuple[Flags, Flags]:
    """(people,) who is detected, and who of them is kept; see `People`."""
    person = comparison.person[matched.rows.truth]
    matches = np.bincount(person, minlength=comparison.people)
    detected = matches >= DETECTED_AFTER
    long_enough = 2 * matches >= _frames_from_first_match(comparison, matched)
    return detected, detected & long_enough & _one_id_of_its_own(comparison, matched)


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
    before = comparison.frames_lived()
    first = np.zeros(comparison.people, np.int64)
    rows = matched.rows.truth[::-1]
    first[comparison.person[rows]] = before[rows]
    return np.asarray(comparison.frames_of_people() - first)
