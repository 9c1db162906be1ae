"""How far two people's tracks of one recording agree on who is who."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Integers
from tracking.scoring.assignment import assign
from tracking.scoring.comparison import Comparison, compare
from tracking.scoring.disagreements import Disagreement, stretches_of
from tracking.scoring.either import EitherMatch
from tracking.scoring.identity import identity
from tracking.scoring.kappa import cohen_kappa
from tracking.scoring.pairs import EPS
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable

_GAP_S = 0.5


@dataclass(frozen=True, slots=True)
class Agreement:
    """How far two tables agree, a and b.

    Attributes:
        idf1: IDF1 of one against the other, the same both ways. NaN where both are empty.
        kappa: Cohen's kappa of the identities, see `agreement`. NaN where both are empty.
        frames: frames in which somebody stands in either.
        rows: person-frames that were compared: matched ones once, those of one side once each.
        same: (track of a, track of b) that are one person, by the naming that agrees best.
        disagreements: by first frame.
    """

    idf1: float
    kappa: float
    frames: int
    rows: int
    same: tuple[tuple[int, int], ...]
    disagreements: tuple[Disagreement, ...]

    def as_json(self) -> dict[str, Any]:
        """The figures as `compare --json` prints them; None where one is undefined."""
        return {
            "frames": self.frames,
            "rows": self.rows,
            "IDF1": None if math.isnan(self.idf1) else self.idf1,
            "kappa": None if math.isnan(self.kappa) else self.kappa,
            "same": [list(pair) for pair in self.same],
            "disagreements": [
                {"a": one.track_a, "b": one.track_b, "start": one.start, "end": one.end}
                | {"kind": one.kind}
                for one in self.disagreements
            ],
        }


@dataclass(frozen=True, slots=True)
class Ratings:
    """What each side says of every person-frame, a row each.

    Attributes:
        frame: (n,). track_a, track_b: (n,) who it is in each; 0 for nobody.
    """

    frame: Integers
    track_a: Integers
    track_b: Integers


def agreement(
    a: ScoringTable, b: ScoringTable, match: Match | None = None, gap: int = 0
) -> Agreement:
    """Compare two tables of one recording; neither counts as the truth.

    Rows of one frame are matched one to one by the greatest total similarity among those alike
    enough. Kappa takes each side as a rater [Cohen1960]: an item is a matched pair or a row that
    one side has alone, its class the identity, and "nobody" where a side has no row. b's ids
    count as those of a they are matched with most, under the one-to-one naming of the whole
    recording that agrees in most rows; an id of b without a partner is a class of its own.

    Kappa ignores how far matched rows lie apart, in which order things happen (one swap that is
    never put right weighs as much as many short ones of the same length), frames where both see
    nobody, and that the naming was chosen to agree: over few frames it is a little flattered.

    Args:
        a, b: rows that do not count are dropped.
        match: how rows are alike; boxes at an overlap of one half or places within 0.5 m where
            it is left out.
        gap: disagreements of the same two tracks with at most so many frames between are one.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    compared = compare(a.rows(a.counted), b.rows(b.counted), match or EitherMatch())
    ratings = ratings_of(compared)
    same = _naming(ratings)
    named = _as_of_a(ratings, same)
    differ = named != ratings.track_a
    nobody = not len(ratings.frame)
    return Agreement(
        idf1=math.nan if nobody else identity(compared).idf1,
        kappa=cohen_kappa(ratings.track_a, named),
        frames=len(np.unique(ratings.frame)),
        rows=len(ratings.frame),
        same=same,
        disagreements=stretches_of(
            ratings.frame[differ], ratings.track_a[differ], ratings.track_b[differ], gap
        ),
    )


def stretch_gap(fps: float) -> int:
    """Frames between two disagreements of the same tracks that are one to a person: half a second.

    Commands, the window and projects all count disagreements with it.
    """
    return round(_GAP_S * fps)


def ratings_of(compared: Comparison) -> Ratings:
    """Every person-frame with what each side says of it: matched rows, then those of one side."""
    a, b = compared.truth, compared.result
    pairs = compared.pairs.some(compared.pairs.similarity >= compared.threshold - EPS)
    pairs = pairs.some(assign(pairs, pairs.similarity, compared.frames))
    alone_a = np.ones(len(a), bool)
    alone_a[pairs.rows.truth] = False
    alone_b = np.ones(len(b), bool)
    alone_b[pairs.rows.result] = False
    nobody_a = np.zeros(int(alone_b.sum()), np.int64)
    nobody_b = np.zeros(int(alone_a.sum()), np.int64)
    return Ratings(
        frame=np.concatenate([a.frame[pairs.rows.truth], a.frame[alone_a], b.frame[alone_b]]),
        track_a=np.concatenate([a.track[pairs.rows.truth], a.track[alone_a], nobody_a]),
        track_b=np.concatenate([b.track[pairs.rows.result], nobody_b, b.track[alone_b]]),
    )


def _naming(ratings: Ratings) -> tuple[tuple[int, int], ...]:
    """The one-to-one naming that agrees in most matched rows."""
    both = (ratings.track_a > 0) & (ratings.track_b > 0)
    of_a, row = np.unique(ratings.track_a[both], return_inverse=True)
    of_b, column = np.unique(ratings.track_b[both], return_inverse=True)
    together = np.zeros((len(of_a), len(of_b)))
    np.add.at(together, (row, column), 1)
    chosen = zip(*linear_sum_assignment(together, maximize=True), strict=True)
    return tuple((int(of_a[r]), int(of_b[c])) for r, c in chosen if together[r, c])


def _as_of_a(ratings: Ratings, same: tuple[tuple[int, int], ...]) -> Integers:
    """(n,) b's ids as those of a; ids without a partner become negative, nobody stays 0."""
    partner = {b: a for a, b in same}
    ids, number = np.unique(ratings.track_b, return_inverse=True)
    named = np.array([partner.get(one, -one) for one in ids.tolist()], np.int64)
    return named[number]
