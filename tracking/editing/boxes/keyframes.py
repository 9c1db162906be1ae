"""Keyframes: rows a person stands for, and what is interpolated between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.editing.boxes.floor_boxes import SIDES, places_of
from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.stretches import (
    compare_windows,
    interpolate_between,
    reinterpolate,
    rows_around,
    stands_fast,
    with_row,
)
from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import Scope, check_scope, frames_text, scope_text
from tracking.editing.core.selection import Rows, rows_differ, select_rows, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Box, Columns, Source, TrackTable, check_known
from tracking.translation import Message, msg


def keyframes_of(
    table: TrackTable, track: int, start: int = 0, end: int | None = None
) -> NDArray[np.int32]:
    """The frames, ascending, whose row a person drew, moved or stands for."""
    rows = table.of_track(track, start, end)
    return np.asarray(rows["frame"][rows["source"] == Source.PERSON])


def key_row_change(
    table: TrackTable,
    row: Columns,
    way: Way,
    kind_and_text: tuple[str, Message],
    *,
    join: bool = False,
) -> Change:
    """The change that puts a keyframe in, and lets what is interpolated around it follow.

    Args:
        table: as it is.
        row: one row, in place of what stands in its frame.
        way: how the neighbouring stretches are interpolated.
        kind_and_text: of the change; the frames that follow are told after the text.
        join: the gaps between it and the rows before and after it are filled, too.

    Raises:
        EditError: nothing would change.
    """
    track, frame = int(row["track"][0]), int(row["frame"][0])
    there = table.of_track(track, frame, frame + 1)
    if len(there["frame"]) and not rows_differ(there, row).any():
        raise EditError(
            "track {track} is already so in frame {frame}; nothing to change",
            track=track,
            frame=frame,
        )
    old = rows_around(table, track, frame)
    new = reinterpolate(old, with_row(old, row), way)
    scope = Scope(frame, frame + 1)
    if join:
        bridges = _bridges(new, frame, way)
        scope = _reaching(scope, bridges["frame"])
        new = stack_rows([new, bridges])
    before, after = compare_windows(old, _with_velocity(new, frame, way.fps))
    kind, text = kind_and_text
    if following := len(after["frame"]) - 1:
        text += msg("; {frames} around it interpolated", frames=frames_text(following))
    return Change(kind, text, frame, State(rows=before), State(rows=after), scope)


def plan_add_keyframe(table: TrackTable, track: int, frame: int) -> Change:
    """Stand for a row as it is: it becomes a keyframe and nothing moves.

    Raises EditError where the track has no row in the frame, or it is a keyframe.
    """
    old = standing_row(table, track, frame)
    new = select_rows(old, slice(None))
    vouch_for(new)
    if old["source"][0] == Source.PERSON:
        raise EditError(
            "frame {frame} is a keyframe of track {track} already", frame=frame, track=track
        )
    text = msg("Make frame {frame} a keyframe of {track}", frame=frame, track=track)
    scope = Scope(frame, frame + 1)
    return Change("keyframe", text, frame, State(rows=old), State(rows=new), scope)


def plan_delete_keyframe(
    table: TrackTable,
    track: int,
    frame: int,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Let a keyframe go: its frame is interpolated like those around it.

    Where nothing stands on one of its sides, its row goes, and with it the interpolated ones that
    hung between it and its other side. Raises EditError where the frame is no keyframe.
    """
    if standing_row(table, track, frame)["source"][0] != Source.PERSON:
        raise EditError(
            "frame {frame} is no keyframe of track {track}; nothing to delete",
            frame=frame,
            track=track,
        )
    old = rows_around(table, track, frame)
    text = msg("Delete the keyframe of {track} in frame {frame}", track=track, frame=frame)
    if _held_on_both_sides(old, frame):
        new = select_rows(old, slice(None))
        new["source"][new["frame"] == frame] = Source.INTERPOLATED
        new["confidence"][new["frame"] == frame] = 1.0
        new = reinterpolate(old, new, Way(how, view, fps))
    else:
        new = select_rows(old, stands_fast(old) & (old["frame"] != frame))
    before, after = compare_windows(old, new)
    gone = len(before["frame"]) - len(after["frame"])
    if gone > 1:
        text += msg(", and the {frames} interpolated from it", frames=frames_text(gone - 1))
    scope = Scope(frame, frame + 1)
    return Change("keyframe", text, frame, State(rows=before), State(rows=after), scope)


def plan_interpolate(
    table: TrackTable,
    track: int,
    start: int,
    end: int,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Interpolate a track between the keyframes in a half-open range of frames.

    The first and the last row in the range stand fast, too. What a tracker put between is
    replaced, and gaps are filled. Raises EditError where there is nothing between, or it is
    interpolated so already.
    """
    ends, between = _ends_and_between(table, track, start, end)
    frames = _frames_between(
        ends, msg("track {track} {where}", track=track, where=scope_text(start, end))
    )
    first, stop = int(ends["frame"][0]), int(ends["frame"][-1]) + 1
    way, where = Way(how, view, fps), scope_text(first, stop)
    before, after = compare_windows(between, interpolate_between(ends, frames, way, between))
    if not len(after["frame"]):
        raise EditError(
            "track {track} is interpolated so already {where}; nothing to change",
            track=track,
            where=where,
        )
    text = msg(
        "Interpolate {track} {where}, {way}between {count} keyframes",
        track=track,
        where=where,
        way=_way_text(way),
        count=len(ends["frame"]),
    )
    scope = Scope(first, stop)
    return Change("interpolate", text, first, State(rows=before), State(rows=after), scope)


def _ends_and_between(table: TrackTable, track: int, start: int, end: int) -> tuple[Rows, Rows]:
    """A track's rows in a range that stand fast, with the first and the last, and the others."""
    check_known(table, track)
    check_scope(start, end)
    old = table.of_track(track, start, end)
    fast = np.asarray(old["source"] == Source.PERSON)
    fast[:1] = fast[-1:] = True
    return select_rows(old, fast), select_rows(old, ~fast)


def _frames_between(ends: Columns, what: str) -> NDArray[np.int32]:
    """The frames between the first and the last of some rows in which none of them stands.

    what: the track and where, for messages. Raises EditError where there is no such frame.
    """
    if len(ends["frame"]) < 2:
        raise EditError(
            "{what}: fewer than two boxes; interpolation needs one at each end", what=what
        )
    first, last = int(ends["frame"][0]), int(ends["frame"][-1])
    frames = np.setdiff1d(np.arange(first, last + 1, dtype=np.int32), ends["frame"])
    if not len(frames):
        raise EditError("{what}: every frame is a keyframe; nothing lies between", what=what)
    return frames


def _way_text(way: Way) -> str:
    return {"floor": msg("along the floor "), "linear": msg("straight "), None: ""}[way.how]


def standing_row(table: TrackTable, track: int, frame: int) -> Rows:
    """The one row of a track in a frame. Raises EditError where it does not stand there."""
    check_known(table, track)
    row = table.of_track(track, frame, frame + 1)
    if not len(row["frame"]):
        raise EditError(
            "track {track} does not stand in frame {frame}; draw a box there instead",
            track=track,
            frame=frame,
        )
    return row


def vouch_for(rows: Rows) -> None:
    """Mark rows as a person's."""
    rows["confidence"][:] = 1.0
    rows["predicted"][:] = False
    rows["source"][:] = Source.PERSON


def put_by_hand(row: Rows, box: Box, place: tuple[float, float]) -> None:
    """Write a box and its x, y in metres into a single row, which becomes a person's."""
    for name, value in zip((*SIDES, "x", "y"), (*box, *place), strict=True):
        row[name][0] = value
    vouch_for(row)


def _held_on_both_sides(rows: Columns, frame: int) -> bool:
    """Whether a frame's row could hang between others: it touches rows, or what hangs, twice."""
    at = int(np.searchsorted(rows["frame"], frame))
    fast = stands_fast(rows)
    if not (fast[:at].any() and fast[at + 1 :].any()):
        return False
    near = [at - 1, at + 1]
    touching = np.abs(rows["frame"][near] - frame) == 1
    return bool((touching | ~fast[near]).all())


def _bridges(rows: Columns, frame: int, way: Way) -> Rows:
    """Rows for the gaps just before and just after a frame."""
    at = int(np.searchsorted(rows["frame"], frame))
    ends = select_rows(rows, slice(max(at - 1, 0), at + 2))
    stop = int(ends["frame"][-1])
    frames = np.setdiff1d(np.arange(ends["frame"][0], stop, dtype=np.int32), ends["frame"])
    return interpolate_between(ends, frames, way, select_rows(rows, slice(0, 0)))


def _reaching(scope: Scope, frames: NDArray[np.int32]) -> Scope:
    """The scope, made to reach over some more frames."""
    reached = [scope.start, *frames.tolist()]
    return Scope(min(reached), max(reached) + 1)


def _with_velocity(rows: Rows, frame: int, fps: float | None) -> Rows:
    """The rows, one frame's velocity told from the frames beside it; unknown: as it was."""
    if fps is None:
        return rows
    near = np.flatnonzero(np.abs(rows["frame"] - frame) <= 1)
    places = places_of(rows)[near]
    seconds = (rows["frame"][near[-1]] - rows["frame"][near[0]]) / fps
    if seconds and np.isfinite(places).all():
        at = near[rows["frame"][near] == frame]
        rows["vx"][at], rows["vy"][at] = (places[-1] - places[0]) / seconds
    return rows
