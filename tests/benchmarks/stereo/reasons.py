"""Why a person was not kept: what went wrong first, read off truth and tracks.

"Kept" is the papers' success as `tracking.scoring.papers` counts it. Everybody else is given the
first event that breaks it, in the order of time.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tests.benchmarks.stereo.loss_context import LossContext, loss_context
from tests.benchmarks.stereo.truth import Columns, Flags, Integers, Truth, visible_for
from tracking.scoring import BoxMatch, Examination, ScoringTable, examine, per_person_of

SWAPPED = "swapped"
TAKEN = "track taken over"
INHERITED = "old track"
FALSE = "false match"
DOUBLED = "second track"
RENAMED = "new id"
LOST = "lost"
NEVER = "never found"
WHAT = (SWAPPED, TAKEN, INHERITED, FALSE, DOUBLED, RENAMED, LOST, NEVER)
"""Tracks exchanged with somebody; a track went from one person to another; a newcomer was given the
track of somebody who had left or was lost; a track of somebody else counted for a moment because
boxes overlap; another track on the same person took its place; found again under a new id; not
followed for half of the time; not detected at all."""

VISIBLE_S = 1.0
"""Who is seen so long without a break should be detected."""

_BEFORE_S = 0.5  # looked back from an event for what was in the way
_EXCHANGE_S = 5.0  # within which two tracks that change places are one swap
_SAME_M = 0.8  # a second track this close was on the same person


@dataclass(frozen=True, slots=True)
class NotKept:
    """Somebody who was not kept.

    Attributes:
        person: of the truth.
        what: one of `WHAT`.
        frame: when it showed, from 0. last: the last frame in which all was well.
        other: the person whose track was mixed up with this one's; 0: nobody.
        tracks: the person's before and after; 0: none.
        context: what was in the way.
    """

    person: int
    what: str
    frame: int
    last: int
    other: int
    tracks: tuple[int, int]
    context: LossContext


@dataclass(frozen=True, slots=True, eq=False)
class Matches:
    """Matched pairs by frame: (k,) frame, person, track; `right`: whose track it is by place.

    `right` is False where the track stands nearer to somebody else than to the matched person.
    """

    frame: Integers
    person: Integers
    track: Integers
    right: Flags


@dataclass(frozen=True, slots=True)
class Stretch:
    """A person matched to one track: first and last frame, and how many of them `right`."""

    track: int
    first: int
    last: int
    matches: int
    right: int


def not_kept(truth: Truth, tracks: Columns) -> tuple[NotKept, ...]:
    """Everybody who was detected and not kept, and who was seen for a second and not detected."""
    examined = examine(truth.table, ScoringTable.from_columns(dict(tracks)), BoxMatch(0.5))
    matches = matches_of(truth, examined)
    visible = visible_for(truth, VISIBLE_S)
    found = []
    for one in per_person_of(examined):
        if one.followed.detected and not one.followed.kept:
            found.append(_reason(truth, tracks, matches, one.person))
        elif not one.followed.detected and one.person in visible:
            found.append(_never(truth, one.person))
    return tuple(found)


def matches_of(truth: Truth, examined: Examination) -> Matches:
    """What was matched, and whether it stands where the person does."""
    comparison, rows = examined.comparison, examined.matched.rows
    frame = comparison.truth.frame[rows.truth]
    person = comparison.truth.track[rows.truth]
    place = comparison.result.position[rows.result]
    right = np.ones(len(frame), bool)
    for number, (at, who) in enumerate(zip(frame.tolist(), person.tolist(), strict=True)):
        start, end = np.searchsorted(truth.frame, (at, at + 1))
        away = np.hypot(*(truth.place[start:end] - place[number]).T)
        right[number] = truth.person[start + int(np.argmin(away))] == who
    return Matches(frame, person, comparison.result.track[rows.result], right)


def _never(truth: Truth, person: int) -> NotKept:
    """Somebody nobody followed: told by the moment in which most of it is seen."""
    rows = np.flatnonzero(truth.person == person)
    frame = int(truth.frame[rows[np.argmax(truth.share[rows])]])
    around = loss_context(truth, person, frame, frame)
    return NotKept(person, NEVER, frame, frame, around.neighbour, (0, 0), around)


def _reason(truth: Truth, tracks: Columns, matches: Matches, person: int) -> NotKept:
    """The first event by which a detected person is not kept."""
    stretches = _stretches(matches, person)
    own = stretches[0]
    bearer = _bearer_before(matches, own)
    if bearer:
        theirs = (matches.track == own.track) & (matches.person == bearer)
        theirs &= matches.frame < own.first
        what = FALSE if _is_false(matches, theirs) else INHERITED
        return _told(truth, person, what, (own.first, 0), own, bearer)
    events = [*_handed_on(truth, matches, person, stretches)]
    if len(stretches) > 1:
        events.append(_changed(truth, tracks, matches, person, stretches))
    if events:
        return min(events, key=lambda event: event.frame)
    return _half_lost(truth, person, stretches[0], matches)


def _stretches(matches: Matches, person: int) -> tuple[Stretch, ...]:
    """A person's tracks, one after the other."""
    rows = np.flatnonzero(matches.person == person)
    breaks = 1 + np.flatnonzero(np.diff(matches.track[rows]))
    return tuple(
        Stretch(
            int(matches.track[own[0]]),
            int(matches.frame[own[0]]),
            int(matches.frame[own[-1]]),
            len(own),
            int(matches.right[own].sum()),
        )
        for own in np.split(rows, breaks)
    )


def _bearer_before(matches: Matches, stretch: Stretch) -> int:
    """Who was matched last to a stretch's track before it; 0: nobody."""
    before = np.flatnonzero((matches.track == stretch.track) & (matches.frame < stretch.first))
    return int(matches.person[before[-1]]) if len(before) else 0


def _changed(
    truth: Truth,
    tracks: Columns,
    matches: Matches,
    person: int,
    stretches: tuple[Stretch, ...],
) -> NotKept:
    """What the first change of a person's track was."""
    old, new = stretches[:2]
    pair = (old.last, old.track)
    if 2 * new.right < new.matches:
        owner = _owner(truth, tracks, new, person)
        return _told(truth, person, FALSE, pair, new, owner)
    before = _bearer_before(matches, new)
    after = _taker(matches, old, person, new.first + round(_EXCHANGE_S * truth.fps))
    if before and before == after:
        return _told(truth, person, SWAPPED, pair, new, before)
    if before or after:
        return _told(truth, person, TAKEN, pair, new, before or after)
    if _stood_there(truth, tracks, new, person, old.last):
        return _told(truth, person, DOUBLED, pair, new, 0)
    return _told(truth, person, RENAMED, pair, new, 0)


def _taker(matches: Matches, old: Stretch, person: int, until: int) -> int:
    """Who is matched to a track once its person no longer is; 0: nobody."""
    after = (matches.track == old.track) & (matches.frame > old.last) & (matches.frame <= until)
    rows = np.flatnonzero(after & (matches.person != person))
    return int(matches.person[rows[0]]) if len(rows) else 0


def _handed_on(
    truth: Truth, matches: Matches, person: int, stretches: tuple[Stretch, ...]
) -> Iterator[NotKept]:
    """The person's first track is with somebody else while the person does not yet go."""
    own = stretches[0]
    ends = max(stretch.last for stretch in stretches if stretch.track == own.track)
    away = (matches.track == own.track) & (matches.person != person)
    rows = np.flatnonzero(away & (matches.frame > own.first) & (matches.frame < ends))
    if not len(rows):
        return
    frame, other = int(matches.frame[rows[0]]), int(matches.person[rows[0]])
    what = FALSE if _is_false(matches, rows[matches.person[rows] == other]) else TAKEN
    last = matches.frame[(matches.person == person) & (matches.frame < frame)]
    pair = (int(last[-1]), own.track)
    yield _told(truth, person, what, pair, Stretch(own.track, frame, frame, 1, 1), other)


def _is_false(matches: Matches, rows: Integers | Flags) -> bool:
    """Whether a track mostly was not with the person it is matched to in some rows."""
    return bool(2 * matches.right[rows].sum() < matches.right[rows].size)


def _owner(truth: Truth, tracks: Columns, stretch: Stretch, person: int) -> int:
    """Who stands nearest to a track when it is first matched to somebody else."""
    own = (tracks["track"] == stretch.track) & (tracks["frame"] == stretch.first)
    place = np.array([float(tracks[name][own][0]) for name in ("x", "y")])
    start, end = np.searchsorted(truth.frame, (stretch.first, stretch.first + 1))
    rows = start + np.flatnonzero(truth.person[start:end] != person)
    if not len(rows):
        return 0
    return int(truth.person[rows[np.argmin(np.hypot(*(truth.place[rows] - place).T))]])


def _stood_there(truth: Truth, tracks: Columns, new: Stretch, person: int, frame: int) -> bool:
    """Whether the new track was on the person already while the old one was."""
    own = (tracks["track"] == new.track) & (tracks["frame"] == frame)
    rows = truth.of(person, frame, frame)
    if not own.any() or not len(rows):
        return False
    place = np.array([float(tracks[name][own][0]) for name in ("x", "y")])
    return bool(np.hypot(*(truth.place[rows[0]] - place)) <= _SAME_M)


def _half_lost(truth: Truth, person: int, only: Stretch, matches: Matches) -> NotKept:
    """Followed by one track of its own, but for less than half of its time: its longest gap."""
    counted = truth.frame[(truth.person == person) & truth.table.counted]
    own = matches.frame[matches.person == person]
    missing = counted[(counted > only.first) & ~np.isin(counted, own)]
    held = own[np.searchsorted(own, missing) - 1]
    starts, sizes = np.unique(held, return_counts=True)
    last = int(starts[np.argmax(sizes)])
    frame = int(missing[held == last][0])
    around = loss_context(truth, person, last, frame)
    return NotKept(person, LOST, frame, last, around.neighbour, (only.track, 0), around)


def _told(
    truth: Truth,
    person: int,
    what: str,
    before: tuple[int, int],
    new: Stretch,
    other: int,
) -> NotKept:
    """The event with what was in the way from half a second before all was well last."""
    last, track = before
    start = max(0, last - round(_BEFORE_S * truth.fps))
    around = loss_context(truth, person, start, new.first)
    return NotKept(person, what, new.first, last, other, (track, new.track), around)
