"""How a result fares near the camera and far from it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats, Integers
from tracking.errors import SettingsError
from tracking.scoring.clear_counts import successions
from tracking.scoring.conventions import Conventions
from tracking.scoring.examination import Examination
from tracking.scoring.identity import naming
from tracking.scoring.papers import PositionError


@dataclass(frozen=True, slots=True, eq=False)
class DistanceScore:
    """The rows within one range of distances from the camera, along the floor.

    Attributes:
        from_m, to_m: half-open range; NaN for the rows whose place is unknown.
        matches, misses, false_positives, id_switches, fragmentations: as `score` counts them;
            those of all ranges add up to those of the whole.
        identity_matches: rows explained by the track their person is named after for IDF1.
        position_error: on the floor.
        conventions: whose definitions are in force.
    """

    from_m: float
    to_m: float
    matches: int
    misses: int
    false_positives: int
    id_switches: int
    fragmentations: int
    identity_matches: int
    position_error: PositionError
    conventions: Conventions = Conventions.TRACKEVAL

    @property
    def reported_matches(self) -> int:
        """Matches as the conventions report them; see `Conventions.reported_matches`."""
        return self.conventions.reported_matches(self.matches, self.id_switches)

    @property
    def truth_rows(self) -> int:
        """Rows of people."""
        return self.matches + self.misses

    @property
    def result_rows(self) -> int:
        """Rows of tracks: on people in the range, and false ones in it."""
        return self.matches + self.false_positives

    @property
    def mota(self) -> float:
        """NaN where nobody stands."""
        right = self.matches - self.false_positives - self.id_switches
        return right / self.truth_rows if self.truth_rows else math.nan

    @property
    def recall(self) -> float:
        """Share of the people's rows that are matched; NaN without any."""
        return self.matches / self.truth_rows if self.truth_rows else math.nan

    @property
    def precision(self) -> float:
        """Share of the tracks' rows that are matched; NaN without any."""
        return self.matches / self.result_rows if self.result_rows else math.nan

    @property
    def idf1(self) -> float:
        """Under the naming of the whole recording; NaN without rows."""
        rows = self.truth_rows + self.result_rows
        return 2.0 * self.identity_matches / rows if rows else math.nan


def per_distance_of(
    examination: Examination, camera_m: tuple[float, float], edges_m: Sequence[float]
) -> tuple[DistanceScore, ...]:
    """The score of each range of distances, the nearest first.

    Rows are matched over the whole recording, as for `score`; then each person's row counts where
    the truth has the person, with its match, and each false positive where the track is. Rows
    without a place come last, where there are any.

    Args:
        camera_m: where the camera stands on the floor, x and y.
        edges_m: growing from 0: `[0, 5, 10]` are the ranges 0 to 5, 5 to 10, and 10 and more.

    Raises:
        SettingsError: the edges do not grow from 0 on.
    """
    check_distances(edges_m)
    edges = np.asarray(edges_m, np.float64)
    counted = _Counted(examination, edges, np.asarray(camera_m, np.float64))
    ranges = zip(edges.tolist(), [*edges[1:].tolist(), math.inf], strict=True)
    scores = [counted.score(number, *each) for number, each in enumerate(ranges)]
    unknown = counted.score(len(edges), math.nan, math.nan)
    return (*scores, unknown) if unknown.truth_rows + unknown.result_rows else tuple(scores)


def check_distances(edges_m: Sequence[float]) -> None:
    """Refuse edges that do not grow from 0 on; raises SettingsError."""
    edges = np.asarray(edges_m, np.float64)
    grow = np.isfinite(edges).all() and np.all(np.diff(edges) > 0)
    if not len(edges) or edges[0] != 0 or not grow:
        raise SettingsError("distances must grow from 0 on; 0, 5, 10 m are three ranges")


class _Counted:
    """Every row with the number of its range."""

    def __init__(self, examination: Examination, edges: Floats, camera_m: Floats) -> None:
        comparison, matched = examination.comparison, examination.matched
        truth = _range_of(comparison.truth.position, camera_m, edges)
        result = _range_of(comparison.result.position, camera_m, edges)
        follow = successions(comparison, matched, examination.conventions)
        of_match = truth[matched.rows.truth]
        self._matches, self._distances_m = of_match, examination.distances_m
        self._misses = np.delete(truth, matched.rows.truth)
        self._false_positives = np.delete(result, matched.rows.result)
        self._switches = of_match[follow.after[follow.switched]]
        self._fragmentations = of_match[follow.after[follow.interrupted]]
        self._named = truth[_named_rows(examination)]
        self._conventions = examination.conventions

    def score(self, number: int, from_m: float, to_m: float) -> DistanceScore:
        return DistanceScore(
            from_m,
            to_m,
            _count(self._matches, number),
            _count(self._misses, number),
            _count(self._false_positives, number),
            _count(self._switches, number),
            _count(self._fragmentations, number),
            _count(self._named, number),
            PositionError.of(self._distances_m[self._matches == number]),
            self._conventions,
        )


def _count(ranges: Integers, number: int) -> int:
    return int(np.count_nonzero(ranges == number))


def _range_of(position: Floats, camera_m: Floats, edges: Floats) -> Integers:
    """(n,) number of each row's range; the one after the last where its place is unknown."""
    away_m = np.hypot(*(position - camera_m).T)
    number = np.searchsorted(edges, away_m, "right") - 1
    return np.where(np.isnan(away_m), len(edges), number)


def _named_rows(examination: Examination) -> Integers:
    """(k,) rows of people that the track they are named after explains."""
    comparison, admitted = examination.comparison, examination.admitted
    named, _ = naming(comparison, admitted)
    person, identity = np.divmod(comparison.couple, max(1, comparison.identities))
    explained = np.flatnonzero(admitted & (named[person] == identity))
    return comparison.pairs.rows.truth[explained]
