"""Who is tracked rightly, part by part, by the measure of [ZhaoLee2009] section 5.2.

A part is right while less than half of its rectangle holds something else: what lies outside of
the box of that very part of that very person counts as something else, be it another part,
another person or the floor. The paper says "regions of other objects" and judges by eye; exact
truth leaves no room, so ours is the stricter reading. Two things the paper leaves open:

- a rectangle that covers less than a twentieth of the part is wrong: a dot inside holds nothing
  else; the inner rectangle of a part seen exactly covers a tenth to a third of its box;
- a person's first frame is the first in which all of the person is in the picture, at least seven
  tenths seen, and a track stands on the person. That track is followed whatever its rectangles do;
  another id on the same person is worth nothing. Who has no track within a second counts as wrong
  from the first frame on, and a track that ends is wrong from there on.

Frames in which somebody is not wholly in the picture end the judging.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.scoring.parts.rectangles import Bools, overlaps
from tracking.scoring.parts.rows import PartTruth, TrackedParts, Whole
from tracking.tracks.on_part import foreign_share, lies_on

LEAST_SEEN = 0.7
LATEST_START_S = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """One person from its first frame on; m frames.

    Attributes:
        person: true id.
        track: id of the track that was followed; 0: none.
        first_frame: number of the first frame judged.
        parts: (m, 3) whether head, torso and hip-leg are right.
        person_right: (m,) whether the person's rectangle is.
        foreign: (m, 3) share of each part's rectangle outside of the part; NaN without one.
    """

    person: int
    track: int
    first_frame: int
    parts: Bools
    person_right: Bools
    foreign: Floats


def judge(truth: PartTruth, tracked: TrackedParts, fps: float) -> list[Judged]:
    """Everybody who is ever wholly in the picture and well seen, in the order of their ids.

    Args:
        truth, tracked: of the same frames. fps: of the recording.
    """
    people, whole = truth.people, truth.whole
    order = np.lexsort((truth.frame, truth.person))
    ids, starts = np.unique(truth.person[order], return_index=True)
    patience = round(LATEST_START_S * fps) + 1
    judged = []
    for person, rows in zip(ids.tolist(), np.split(order, starts[1:]), strict=False):
        begins = np.flatnonzero(whole[rows] & (truth.visibility[rows] >= LEAST_SEEN))
        if not len(begins):
            continue
        seen = rows[begins[0] :]
        seen = seen[: _unbroken(truth.frame[seen], whole[seen])]
        track, waited = _beginning(tracked, truth.frame, people, seen[:patience])
        judged.append(_judged(person, track, seen[waited:], truth, tracked))
    return judged


def _unbroken(frame: Whole, whole: Bools) -> int:
    """How many rows there are until the first frame in which the person is not whole."""
    stays = whole & (frame - frame[0] == np.arange(len(frame)))
    return len(frame) if stays.all() else int(np.argmin(stays))


def _beginning(tracked: TrackedParts, frame: Whole, people: Floats, seen: Whole) -> tuple[int, int]:
    """The track that stands on a person earliest, best if several do, and in which row; or 0, 0.

    A track stands on whomever it overlaps most: behind each other, people share rectangles.

    Args:
        frame, people: of all rows of the truth. seen: the person's rows, by frame.
    """
    for waited, row in enumerate(seen.tolist()):
        first, end = np.searchsorted(frame, (frame[row], frame[row] + 1))
        theirs = slice(*np.searchsorted(tracked.frame, (frame[row], frame[row] + 1)))
        shared = overlaps(tracked.person[theirs, None], people[None, first:end])
        own = shared[:, row - first]
        fits = (own == shared.max(axis=1)) & lies_on(tracked.person[theirs], people[row])
        if fits.any():
            return int(tracked.track[theirs][np.argmax(np.where(fits, own, -1.0))]), waited
    return 0, 0


def _judged(
    person: int, track: int, seen: Whole, truth: PartTruth, tracked: TrackedParts
) -> Judged:
    """The person in the rows `seen` of the truth, which are of consecutive frames."""
    first = int(truth.frame[seen[0]])
    parts, whole = np.full((len(seen), 3, 4), np.nan), np.full((len(seen), 4), np.nan)
    inside = slice(*np.searchsorted(tracked.frame, (first, first + len(seen))))
    own = np.flatnonzero(tracked.track[inside] == track) + inside.start
    at = tracked.frame[own] - first
    parts[at], whole[at] = tracked.parts[own], tracked.person[own]
    true = truth.parts[seen]
    return Judged(
        person,
        track,
        first,
        lies_on(parts, true),
        lies_on(whole, truth.people[seen]),
        foreign_share(parts, true),
    )
