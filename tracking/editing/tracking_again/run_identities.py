"""Who of the corrected tracks the people of a run are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from tracking.editing.tracking_again.counterparts import mates, same_keys
from tracking.editing.tracking_again.protection import Protection
from tracking.tracks import Columns, pairs_of, row_keys

Integers = NDArray[np.integer]
Indices = NDArray[np.int64]

_SURE = 20.0
"""A frame that stays as it is tells so many times more who somebody is than one that is asked."""
_ASSERTED = 3
"""Protected frames in a row in which somebody must stand on a track to be that person."""
_NEVER = -1


@dataclass(frozen=True, slots=True, eq=False)
class IdentityMap:
    """How a run's people are called in the corrected table.

    Attributes:
        track: (n,) of each of the run's rows its corrected id.
        fresh: the ids among them that nobody bears in the table.
    """

    track: NDArray[np.int32]
    fresh: NDArray[np.int64]


def map_identities(
    corrected: Columns,
    found: Columns,
    frames: tuple[int, int],
    known_tracks: int,
    highest_track: int,
    protection: Protection,
) -> IdentityMap:
    """The corrected ids of a run's rows.

    Ids that the run went on with stay. Everybody else is whoever of the remaining tracks they
    stand on in most frames, each track given once; frames before the range and protected ones
    tell more. Where somebody stands on protected rows of another id, these are right, and from
    there on they are that person. Who is nobody known gets an id above the highest.

    Args:
        corrected, found: rows of the table and of the run, from a little before the range on.
        frames: the range, half-open. known_tracks: of the run. highest_track: of the table.
    """
    people, number = np.unique(found["track"], return_inverse=True)
    kept = people <= known_tracks
    own = np.where(kept[number], same_keys(found, corrected), -1)
    mate = mates(found, corrected, own)[0]
    # One more at the end, which those who stand on nobody (-1) look up.
    theirs = np.append(corrected["track"], 0)[mate].astype(np.int64)
    sure = np.append(protection.covers(corrected["track"], corrected["frame"]), False)[mate]
    weight = np.where(sure | (found["frame"] < frames[0]), _SURE, 1.0)
    free = (theirs > 0) & ~kept[number] & ~np.isin(theirs, people[kept])
    matched = _assigned(number[free], theirs[free], weight[free], len(people))
    told = _told(number, found["frame"], np.where(sure, theirs, 0))
    # Whom the run did not go on with is from the first whoever they turn out to be.
    first = told[np.unique(number[told], return_index=True)[1]]
    matched[number[first]] = theirs[first]
    base = np.where(kept, people, matched)
    base, top = _with_fresh(base, people, known_tracks, highest_track)
    track, since = _asserted(number, found["frame"], base[number], theirs, told)
    track = _apart(track, since, number, found["frame"], top)
    fresh = np.setdiff1d(track, np.union1d(corrected["track"], people[kept]))
    return IdentityMap(track.astype(np.int32), fresh)


def _assigned(
    person: Indices, track: Integers, weight: NDArray[np.float64], people: int
) -> Indices:
    """(people,) the track of each by the largest total weight, no track twice; 0 for nobody."""
    given = np.zeros(people, np.int64)
    if not len(person):
        return given
    tracks, column = np.unique(track, return_inverse=True)
    shape = (people, len(tracks))
    counts = coo_array((weight, (person, column)), shape).tocsr()
    linked = coo_array((np.ones(len(person)), (person, people + column)), (sum(shape),) * 2)
    group = connected_components(linked, directed=False)[1]
    members = np.argsort(group, kind="stable")
    for rows in np.split(members, np.flatnonzero(np.diff(group[members])) + 1):
        mine, theirs = rows[rows < people], rows[rows >= people] - people
        if len(mine) and len(theirs):
            block = counts[mine][:, theirs].toarray()
            one, other = linear_sum_assignment(block, maximize=True)
            real = block[one, other] > 0
            given[mine[one[real]]] = tracks[theirs[other[real]]]
    return given


def _with_fresh(
    base: Indices, people: Integers, known_tracks: int, highest_track: int
) -> tuple[Indices, int]:
    """The ids with new ones for who has none, and the highest of all.

    A run that went on from the corrected tracks numbered its new people already; they keep these
    numbers where nobody bears them.
    """
    nobody = base == 0
    own = nobody & (known_tracks > 0) & (people > max(known_tracks, highest_track))
    base = np.where(own, people, base)
    top = max(highest_track, int(base.max(initial=0)))
    rest = np.flatnonzero(nobody & ~own)
    base[rest] = top + 1 + np.arange(len(rest))
    return base, top + len(rest)


def _told(number: Indices, frame: Integers, asserted: Indices) -> Indices:
    """The rows that say who somebody is, by person and frame: on protected rows, several in a row.

    Args:
        number: (n,) the run's person of each row. asserted: (n,) the id of the protected row it
            stands on, 0 for none.
    """
    rows = np.flatnonzero(asserted)
    rows = rows[np.lexsort((frame[rows], number[rows]))]
    begins = (np.diff(number[rows]) != 0) | (np.diff(asserted[rows]) != 0)
    run = np.concatenate((np.zeros(min(len(rows), 1), np.int64), np.cumsum(begins)))
    long = np.bincount(run, minlength=1)[run] >= _ASSERTED
    return np.asarray(rows[long])


def _asserted(
    number: Indices, frame: Integers, base: Indices, theirs: Indices, told: Indices
) -> tuple[Indices, Indices]:
    """The ids where protected rows have the last word, and the frame since when each holds.

    Args:
        number: (n,) the run's person of each row. base: (n,) its id so far. theirs: (n,) the id
            of the corrected row it stands on. told: the rows of `_told`.
    """
    track, since = base.copy(), np.full(len(base), _NEVER)
    if not len(told):
        return track, since
    order = np.lexsort((frame, number))
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order))
    source = np.full(len(order), _NEVER)
    source[place[told]] = place[told]
    source = np.maximum.accumulate(source)
    row = order[source]
    holds = (source >= 0) & (number[row] == number[order])
    track[order[holds]] = theirs[row[holds]]
    since[order[holds]] = frame[row[holds]]
    return track, since


def _apart(track: Indices, since: Indices, number: Indices, frame: Integers, top: int) -> Indices:
    """The ids with nobody twice in a frame.

    Whose id was asserted later keeps it; the other one is somebody new from there on.
    """
    while len(rows := _borne_by_several(track, number)):
        order = rows[np.lexsort((number[rows], -since[rows], frame[rows], track[rows]))]
        same = (np.diff(track[order]) == 0) & (np.diff(frame[order]) == 0)
        if not same.any():
            break
        loser = order[1:][same]
        first = loser[np.argmin(frame[loser])]
        rest = (number == number[first]) & (track == track[first]) & (frame >= frame[first])
        top += 1
        track = np.where(rest & (since <= since[first]), top, track)
    return track


def _borne_by_several(track: Indices, number: Indices) -> Indices:
    """The rows whose id more than one of the run's people bear."""
    pairs = np.unique(row_keys(track, number))
    ids, count = np.unique(pairs_of(pairs)[0], return_counts=True)
    several = ids[count > 1]
    return np.flatnonzero(np.isin(track, several)) if len(several) else several
