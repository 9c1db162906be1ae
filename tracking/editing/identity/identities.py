"""Planners of edits that change who a row belongs to. They only look; nothing changes here."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import Change, State, Stretches
from tracking.editing.core.scope import Scope, check_id, check_scope, scope_text
from tracking.errors import EditError
from tracking.tracks import TrackTable, between, check_known, next_track
from tracking.translation import msg


def plan_swap(table: TrackTable, a: int, b: int, start: int, end: int | None = None) -> Change:
    """Let two tracks change names in frames start to end; end None: from there on.

    Raises EditError for unknown or equal tracks, and where neither stands in the range.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError("swap of track {a} with itself; choose two different tracks", a=a)
    stop = _stop(table, start, end, a, b)
    both = [_stretch(table, track, start, stop) for track in (a, b)]
    if not any(len(part) for part in both):
        raise EditError(
            "neither track {a} nor {b} stands {where}; choose other frames",
            a=a,
            b=b,
            where=scope_text(start, end),
        )
    before = np.concatenate(both)
    after = before.copy()
    after[:, 0] = np.where(before[:, 0] == a, b, a)
    text = msg("Swap {a} and {b} {where}", a=a, b=b, where=scope_text(start, end))
    return Change("swap", text, start, State(before), State(after), Scope(start, end))


def plan_split(table: TrackTable, track: int, frame: int) -> Change:
    """Cut a track before a frame: the first half keeps its id, the second gets a new one.

    The new id is one more than the highest ever used, also by tracks that are gone.
    Raises EditError where one of the halves would be empty, or no higher id is left.
    """
    check_known(table, track)
    start, end = table.frame_range(track)
    if not start < frame < end:
        raise EditError(
            "track {track} stands in frames {start} to {end}; it cannot be split at {frame}",
            track=track,
            start=start,
            end=end - 1,
            frame=frame,
        )
    new = next_track(table)
    before = _stretch(table, track, frame, end)
    text = msg(
        "Split {track} at frame {frame}; the rest is {new}", track=track, frame=frame, new=new
    )
    after = State(assign_to(before, new))
    return Change("split", text, frame, State(before), after, Scope(frame))


def plan_reassign(
    table: TrackTable, track: int, to: int, start: int = 0, end: int | None = None
) -> Change:
    """Give a track's rows in a range of frames to another track, known or new.

    Raises EditError where the other stands in one of those frames already (merge asks whom to
    keep), where the range is empty, and for a new id far above the highest ever used.
    """
    check_known(table, track)
    check_id(table, to)
    if track == to:
        raise EditError("track {track} cannot be given to itself; choose another id", track=track)
    stop = _stop(table, start, end, track)
    moving = _within(table.frames_of_track(track), start, stop)
    if not len(moving):
        raise EditError(
            "track {track} does not stand {where}; choose other frames",
            track=track,
            where=scope_text(start, end),
        )
    staying = table.frames_of_track(to)
    both = np.intersect1d(moving, staying, assume_unique=True)
    if len(both):
        raise EditError(
            "tracks {track} and {to} both stand in frame {frame}; merge or swap them instead",
            track=track,
            to=to,
            frame=both[0],
        )
    before = stretches_of(track, moving, staying)
    text = msg("Give {track} to {to} {where}", track=track, to=to, where=scope_text(start, end))
    first, after = int(moving[0]), State(assign_to(before, to))
    return Change("reassign", text, first, State(before), after, Scope(start, end))


def _stop(table: TrackTable, start: int, end: int | None, *tracks: int) -> int:
    check_scope(start, end)
    stop = max(table.frame_range(track)[1] for track in tracks) if end is None else end
    return max(stop, start)


def _within(frames: NDArray[np.int32], start: int, stop: int) -> NDArray[np.int32]:
    return frames[between(frames, start, stop)]


def _stretch(table: TrackTable, track: int, start: int, stop: int) -> Stretches:
    """(1, 3) the track's rows in the range; (0, 3) where there are none."""
    there = len(_within(table.frames_of_track(track), start, stop)) > 0
    return np.array([[track, start, stop]][:there], np.int64).reshape(-1, 3)


def stretches_of(track: int, moving: NDArray[np.int32], staying: NDArray[np.int32]) -> Stretches:
    """The longest stretches of moving frames with no staying frame inside; (k, 3)."""
    passed = np.searchsorted(staying, moving)
    cuts = np.flatnonzero(passed[1:] != passed[:-1]) + 1
    first = np.concatenate([[0], cuts]) if len(moving) else cuts
    last = np.concatenate([cuts, [len(moving)]])[: len(first)] - 1
    tracks = np.full(len(first), track)
    return np.column_stack([tracks, moving[first], moving[last] + 1]).astype(np.int64)


def assign_to(stretches: Stretches, track: int) -> Stretches:
    """The stretches as another track's."""
    given = stretches.copy()
    given[:, 0] = track
    return given
