"""Planners of edits that change who a row belongs to. They only look; nothing changes here."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tracking.editing.change import Change, LabelState, State, Stretches, no_rows
from tracking.errors import EditError
from tracking.tracks import (
    LARGEST_NUMBER,
    Columns,
    Labels,
    TrackLabel,
    TrackTable,
    between,
    check_known,
    next_track,
)

Keep = Literal["first", "second"]


def plan_swap(table: TrackTable, a: int, b: int, start: int, end: int | None = None) -> Change:
    """Let two tracks change names in frames start to end; end None: from there on.

    Raises EditError for unknown or equal tracks, and where neither stands in the range.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError(f"swap of track {a} with itself; choose two different tracks")
    stop = _stop(table, start, end, a, b)
    both = [_stretch(table, track, start, stop) for track in (a, b)]
    if not any(len(part) for part in both):
        raise EditError(f"neither track {a} nor {b} stands in {_scope(start, end)}")
    before = np.concatenate(both)
    after = before.copy()
    after[:, 0] = np.where(before[:, 0] == a, b, a)
    text = f"Swap {a} and {b} {_scope(start, end)}"
    return Change("swap", text, start, State(before), State(after))


def plan_split(table: TrackTable, track: int, frame: int) -> Change:
    """Cut a track before a frame: the first half keeps its id, the second gets a new one.

    The new id is one more than the highest ever used, also by tracks that are gone.
    Raises EditError where one of the halves would be empty, or no higher id is left.
    """
    check_known(table, track)
    start, end = table.frame_range(track)
    if not start < frame < end:
        raise EditError(
            f"track {track} stands in frames {start} to {end - 1}; it cannot be split at {frame}"
        )
    new = next_track(table)
    before = _stretch(table, track, frame, end)
    text = f"Split {track} at frame {frame}; the rest is {new}"
    return Change("split", text, frame, State(before), State(_given_to(before, new)))


def plan_merge(
    table: TrackTable, a: int, b: int, keep: Keep = "first", labels: Labels | None = None
) -> Change:
    """Make one track of two: everything of b becomes a's.

    Where both stand in a frame, keep says whose row stays: a's ("first") or b's ("second"). With
    labels given, a takes over what b's label says and its own does not.
    Raises EditError for unknown or equal tracks.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError(f"merge of track {a} with itself; choose two different tracks")
    if keep not in ("first", "second"):
        raise EditError(f"merge: keep is {keep!r}; it is 'first' or 'second'")
    own, other = table.frames_of_track(a), table.frames_of_track(b)
    both = np.intersect1d(own, other, assume_unique=True)
    dropped = _rows_in(table, b if keep == "first" else a, both)
    moving = np.setdiff1d(other, both) if keep == "first" else other
    staying = own if keep == "first" else np.setdiff1d(own, both)
    before = _stretches(b, moving, staying)
    label_before, label_after = _merged_labels(labels, a, b)
    text = f"Merge {b} into {a}"
    if len(both):
        text += f"; where both stand ({len(both)} frames), {a if keep == 'first' else b} is kept"
    return Change(
        "merge",
        text,
        table.frame_range(b)[0],
        State(before, dropped, label_before),
        State(_given_to(before, a), no_rows(), label_after),
    )


def plan_reassign(
    table: TrackTable, track: int, to: int, start: int = 0, end: int | None = None
) -> Change:
    """Give a track's rows in a range of frames to another track, known or new.

    Raises EditError where the other stands in one of those frames already (merge asks whom to
    keep), and where the range is empty.
    """
    check_known(table, track)
    if track == to or not 1 <= to <= LARGEST_NUMBER:
        raise EditError(
            f"track {track} cannot be given to {to}; choose another id from 1 to {LARGEST_NUMBER}"
        )
    stop = _stop(table, start, end, track)
    moving = _within(table.frames_of_track(track), start, stop)
    if not len(moving):
        raise EditError(f"track {track} does not stand in {_scope(start, end)}")
    staying = table.frames_of_track(to)
    both = np.intersect1d(moving, staying, assume_unique=True)
    if len(both):
        raise EditError(
            f"tracks {track} and {to} both stand in frame {both[0]}; merge or swap them instead"
        )
    before = _stretches(track, moving, staying)
    text = f"Give {track} to {to} {_scope(start, end)}"
    return Change("reassign", text, int(moving[0]), State(before), State(_given_to(before, to)))


def _scope(start: int, end: int | None) -> str:
    """The frames of an edit in words, the last one named, not the one after."""
    if end is None:
        return f"from frame {start} on"
    if end == start + 1:
        return f"in frame {start}"
    return f"in frames {start} to {end - 1}"


def _stop(table: TrackTable, start: int, end: int | None, *tracks: int) -> int:
    stop = max(table.frame_range(track)[1] for track in tracks) if end is None else end
    if start < 0 or (end is not None and end <= start):
        raise EditError(f"frames {start} to {end}: the range is empty or begins before frame 0")
    return max(stop, start)


def _within(frames: NDArray[np.int32], start: int, stop: int) -> NDArray[np.int32]:
    return frames[between(frames, start, stop)]


def _stretch(table: TrackTable, track: int, start: int, stop: int) -> Stretches:
    """(1, 3) the track's rows in the range; (0, 3) where there are none."""
    there = len(_within(table.frames_of_track(track), start, stop)) > 0
    return np.array([[track, start, stop]][:there], np.int64).reshape(-1, 3)


def _stretches(track: int, moving: NDArray[np.int32], staying: NDArray[np.int32]) -> Stretches:
    """The longest stretches of moving frames with no staying frame inside; (k, 3)."""
    passed = np.searchsorted(staying, moving)
    cuts = np.flatnonzero(passed[1:] != passed[:-1]) + 1
    first = np.concatenate([[0], cuts]) if len(moving) else cuts
    last = np.concatenate([cuts, [len(moving)]])[: len(first)] - 1
    tracks = np.full(len(first), track)
    return np.column_stack([tracks, moving[first], moving[last] + 1]).astype(np.int64)


def _given_to(stretches: Stretches, track: int) -> Stretches:
    given = stretches.copy()
    given[:, 0] = track
    return given


def _rows_in(table: TrackTable, track: int, frames: NDArray[np.int32]) -> Columns:
    rows = table.of_track(track)
    chosen = np.isin(rows["frame"], frames, assume_unique=True)
    return {name: column[chosen] for name, column in rows.items()}


def _merged_labels(labels: Labels | None, a: int, b: int) -> tuple[LabelState, LabelState]:
    if labels is None or b not in labels.tracks:
        return LabelState(), LabelState()
    own, other = labels.of_track(a), labels.of_track(b)
    notes = "\n".join(text for text in (own.notes, other.notes) if text)
    joined = TrackLabel(own.name or other.name, {**other.attributes, **own.attributes}, notes)
    return LabelState({a: own, b: other}), LabelState({a: joined, b: TrackLabel()})
