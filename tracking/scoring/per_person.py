"""How well each person of the truth was followed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Integers
from tracking.scoring.clear_counts import successions
from tracking.scoring.examination import Examination, examine
from tracking.scoring.id_index import grouped
from tracking.scoring.identity import naming
from tracking.scoring.papers import PositionError, detected_and_kept
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True)
class Followed:
    """What became of one person's identity.

    Attributes:
        id_switches, fragmentations: as `score` counts them.
        named: the track it is named after for IDF1; None for none.
        identity_matches: frames explained by that track.
        detected, kept: see `People`.
    """

    id_switches: int
    fragmentations: int
    named: int | None
    identity_matches: int
    detected: bool
    kept: bool


@dataclass(frozen=True, slots=True, eq=False)
class PersonScore:
    """One person of the truth.

    Attributes:
        person: id in the truth.
        start, end: half-open range of frames from its first to its last.
        frames: in how many of them it stands. matches: in how many it is matched.
        similarity: mean over its matches; NaN without any.
        tracks: ids it was matched to, in the order of their first matches.
        position_error: on the floor.
        followed: switches and the like.
    """

    person: int
    start: int
    end: int
    frames: int
    matches: int
    similarity: float
    tracks: tuple[int, ...]
    position_error: PositionError
    followed: Followed

    @property
    def misses(self) -> int:
        """Frames in which it stands and is not matched."""
        return self.frames - self.matches

    @property
    def share_matched(self) -> float:
        """Of its frames."""
        return self.matches / self.frames


def per_person(
    truth: ScoringTable, result: ScoringTable, match: Match | None = None
) -> tuple[PersonScore, ...]:
    """How well each person was followed, in the order of their ids.

    Args:
        truth, result, match: as for `score`.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    return per_person_of(examine(truth, result, match))


def per_person_of(examination: Examination) -> tuple[PersonScore, ...]:
    """How well each person was followed in what was compared."""
    comparison, matched = examination.comparison, examination.matched
    follow = successions(comparison, matched, examination.conventions)
    person = comparison.person[matched.rows.truth]
    switched = np.bincount(person[follow.after[follow.switched]], minlength=comparison.people)
    parted = np.bincount(person[follow.after[follow.interrupted]], minlength=comparison.people)
    detected, kept = detected_and_kept(comparison, matched)
    named, explained = naming(comparison, examination.admitted)
    ids = np.unique(comparison.result.track)
    found = [
        Followed(
            id_switches=int(switched[number]),
            fragmentations=int(parted[number]),
            named=int(ids[named[number]]) if named[number] >= 0 else None,
            identity_matches=int(explained[number]),
            detected=bool(detected[number]),
            kept=bool(kept[number]),
        )
        for number in range(comparison.people)
    ]
    return _joined(examination, found)


def _joined(examination: Examination, found: list[Followed]) -> tuple[PersonScore, ...]:
    """With what each person's own rows and matches say."""
    comparison, matched = examination.comparison, examination.matched
    rows = _groups(comparison.person, comparison.people)
    matches = _groups(comparison.person[matched.rows.truth], comparison.people)
    distances_m = examination.distances_m
    track = comparison.result.track[matched.rows.result]
    return tuple(
        PersonScore(
            person=int(comparison.truth.track[own[0]]),
            start=int(comparison.truth.frame[own[0]]),
            end=int(comparison.truth.frame[own[-1]]) + 1,
            frames=len(own),
            matches=len(its),
            similarity=float(matched.similarity[its].mean()) if len(its) else np.nan,
            tracks=tuple(dict.fromkeys(track[its].tolist())),
            position_error=PositionError.of(distances_m[its]),
            followed=followed,
        )
        for own, its, followed in zip(rows, matches, found, strict=True)
    )


def _groups(group: Integers, groups: int) -> list[Integers]:
    """For each group the rows that are of it, in order."""
    if not groups:
        return []
    return np.split(grouped(group, groups), np.cumsum(np.bincount(group, minlength=groups))[:-1])
