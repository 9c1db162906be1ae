"""CLEAR MOT: what follows from who is matched with what."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.clear import Clear
from tracking.scoring.comparison import Comparison
from tracking.scoring.conventions import Conventions
from tracking.scoring.id_index import grouped
from tracking.scoring.pairs import Candidates

_MOSTLY_TRACKED, _MOSTLY_LOST = 0.8, 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Successions:
    """Each match but a person's first, with the one before, ordered by person, then frame.

    Attributes:
        before, after: (k,) which two of the matches.
        switched: (k,) they bear different tracks.
        interrupted: (k,) frames without a match lie between them: frames with rows on both
            sides; as py-motmetrics has it frames in which the person stands.
    """

    before: Integers
    after: Integers
    switched: Flags
    interrupted: Flags


def successions(
    comparison: Comparison,
    matched: Candidates,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> Successions:
    """How each person's matches follow one another."""
    person = comparison.person[matched.rows.truth]
    order = grouped(person, comparison.people)
    same = np.diff(person[order]) == 0
    before, after = order[:-1][same], order[1:][same]
    track = comparison.identity[matched.rows.result]
    if conventions is Conventions.MOTMETRICS:
        time = comparison.frames_lived()[matched.rows.truth]
    else:
        time = matched.frame
    return Successions(
        before=before,
        after=after,
        switched=np.asarray(track[before] != track[after]),
        interrupted=np.asarray(time[after] - time[before] > 1),
    )


def clear(
    comparison: Comparison,
    matched: Candidates,
    frames: int = 0,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> Clear:
    """The measures of the matched pairs; `frames` is the length of the recording."""
    follow = successions(comparison, matched, conventions)
    mostly, lost = mostly_tracked_and_lost(share_tracked(comparison, matched), conventions)
    one_sided = comparison.one_sided and conventions is Conventions.TRACKEVAL
    return Clear(
        matches=len(matched),
        misses=len(comparison.truth) - len(matched),
        false_positives=len(comparison.result) - len(matched),
        id_switches=int(follow.switched.sum()),
        fragmentations=int(follow.interrupted.sum()),
        mostly_tracked=int(mostly.sum()),
        partly_tracked=comparison.people - int(mostly.sum()) - int(lost.sum()),
        mostly_lost=int(lost.sum()),
        # TrackEval counts no frames of a sequence with nothing to compare.
        frames=0 if one_sided else frames,
        similarity=float(matched.similarity.sum()),
        one_sided=one_sided,
        conventions=conventions,
    )


def mostly_tracked_and_lost(share: Floats, conventions: Conventions) -> tuple[Flags, Flags]:
    """(people,) who is found in most frames, and who in hardly any."""
    if conventions is Conventions.MOTMETRICS:
        return np.asarray(share >= _MOSTLY_TRACKED), np.asarray(share < _MOSTLY_LOST)
    return np.asarray(share > _MOSTLY_TRACKED), np.asarray(share < _MOSTLY_LOST)


def share_tracked(comparison: Comparison, matched: Candidates) -> Floats:
    """(people,) share of each person's frames in which it is matched."""
    person = comparison.person[matched.rows.truth]
    matches = np.bincount(person, minlength=comparison.people)
    return np.asarray(matches / comparison.frames_of_people())
