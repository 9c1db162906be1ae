"""Truth and result side by side, with the don't-cares gone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Integers
from tracking.scoring.assignment import assign
from tracking.scoring.candidates import candidates
from tracking.scoring.id_index import grouped, numbered
from tracking.scoring.pairs import EPS, Candidates, Frames
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True)
class Comparison:
    """What every measure starts from.

    Attributes:
        truth, result: the rows that count.
        person: (n,) number from 0 of a truth row's person.
        identity: (m,) number from 0 of a result row's track.
        people, identities: how many there are.
        frames: the frames with rows on both sides.
        pairs: rows of one frame that are at all alike.
        couple: (k,) which person and track each pair is of: person * identities + identity.
        threshold: pairs at least this alike may be one person.
    """

    truth: ScoringTable
    result: ScoringTable
    person: Integers
    identity: Integers
    people: int
    identities: int
    frames: Frames
    pairs: Candidates
    couple: Integers
    threshold: float

    @property
    def one_sided(self) -> bool:
        """Nothing is there to compare: the truth or the result has no rows."""
        return not len(self.truth) or not len(self.result)

    @property
    def couples(self) -> int:
        """How many couples there can be."""
        return self.people * self.identities

    def frames_of_people(self) -> Integers:
        """(people,) in how many frames each person stands."""
        return np.bincount(self.person, minlength=self.people)

    def frames_of_identities(self) -> Integers:
        """(identities,) in how many frames each track of the result stands."""
        return np.bincount(self.identity, minlength=self.identities)

    def frames_lived(self) -> Integers:
        """(n,) the how manieth frame of its person a truth row is, from 0."""
        order = grouped(self.person, self.people)
        frames = self.frames_of_people()
        lived = np.empty(len(order), np.int64)
        lived[order] = np.arange(len(order)) - np.repeat(np.cumsum(frames) - frames, frames)
        return lived


def compare(truth: ScoringTable, result: ScoringTable, match: Match) -> Comparison:
    """Put the rows that count side by side.

    A result row that is matched with a don't-care (at the threshold, among all rows of the frame)
    is dropped, then all rows that do not count are.
    """
    match.require(truth, "ground truth")
    match.require(result, "result")
    if not truth.counted.all():
        result = result.rows(_not_on_dont_cares(truth, result, match))
        truth = truth.rows(truth.counted)
    frames = Frames.shared(truth, result)
    people, person = numbered(truth.track)
    identities, identity = numbered(result.track)
    pairs = candidates(truth, result, frames, match)
    couple = person[pairs.rows.truth] * len(identities) + identity[pairs.rows.result]
    return Comparison(
        truth=truth,
        result=result,
        person=person,
        identity=identity,
        people=len(people),
        identities=len(identities),
        frames=frames,
        pairs=pairs,
        couple=couple,
        threshold=match.threshold,
    )


def _not_on_dont_cares(truth: ScoringTable, result: ScoringTable, match: Match) -> Flags:
    """(m,) False for result rows that are matched with a don't-care."""
    frames = Frames.shared(truth, result)
    pairs = candidates(truth, result, frames, match)
    pairs = pairs.some(pairs.similarity >= match.threshold - EPS)
    dont_care = ~truth.counted if truth.dont_care is None else truth.dont_care
    concerned = np.unique(pairs.frame[dont_care[pairs.rows.truth]])
    pairs = pairs.some(np.isin(pairs.frame, concerned))
    chosen = pairs.some(assign(pairs, pairs.similarity, frames))
    kept = np.ones(len(result), bool)
    kept[chosen.rows.result[dont_care[chosen.rows.truth]]] = False
    return kept
