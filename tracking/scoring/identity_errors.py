"""Every place where identities go wrong, one by one: what a reviewer would have to find."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Integers
from tracking.scoring.clear_matches import clear_matches
from tracking.scoring.comparison import compare
from tracking.scoring.similarity import BoxMatch, Match
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True, order=True)
class IdentityError:
    """One wrong handover.

    Attributes:
        frame: the first one after it.
        tracks: of the result: of a person that changes its track the old and the new one, of a
            track that goes to somebody else that track.
        people: of the truth, likewise.
    """

    frame: int
    tracks: tuple[int, ...]
    people: tuple[int, ...]


def identity_errors(
    truth: ScoringTable, result: ScoringTable, match: Match | None = None
) -> tuple[IdentityError, ...]:
    """Frames where a person's matched track changes, and where a track goes to another person.

    Rows are matched as for `MOTA`: last frame's partners stay together while they match. A swap
    of two tracks is therefore four errors, two people and two tracks of one frame.

    Args:
        truth, result, match: as for `score`.

    Returns:
        The errors by frame.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    comparison = compare(truth, result, match or BoxMatch())
    matched = clear_matches(comparison)
    frame = comparison.truth.frame[matched.rows.truth]
    person = comparison.truth.track[matched.rows.truth]
    track = comparison.result.track[matched.rows.result]
    changed = _changes(person, track, frame)
    taken = _changes(track, person, frame)
    errors = [
        IdentityError(at, (before, after), (who,)) for at, who, before, after in changed.tolist()
    ]
    errors += [
        IdentityError(at, (who,), (before, after)) for at, who, before, after in taken.tolist()
    ]
    return tuple(sorted(errors))


def _changes(owner: Integers, partner: Integers, frame: Integers) -> Integers:
    """(k, 4) frame, owner, partner before and after, of each change of an owner's partner."""
    order = np.lexsort((frame, owner))
    owner, partner, frame = owner[order], partner[order], frame[order]
    at = 1 + np.flatnonzero((owner[1:] == owner[:-1]) & (partner[1:] != partner[:-1]))
    return np.stack((frame[at], owner[at], partner[at - 1], partner[at]), axis=1)
