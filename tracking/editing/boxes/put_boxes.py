"""Planners that put boxes at once: one, the same over some frames, and those of several people."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.keyframes import keyframes_of, standing_row, vouch_for
from tracking.editing.boxes.rows import plan_draw_box, plan_move_box
from tracking.editing.boxes.stretches import compare_windows, reinterpolate, rows_around
from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import Scope, check_scope, tracks_text
from tracking.editing.core.selection import Rows, rows_differ, select_rows, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Box, Source, TrackTable
from tracking.translation import msg


def is_by_hand(table: TrackTable, track: int) -> bool:
    """Whether a person drew, moved or interpolated any row of a track."""
    return track in table and bool(np.any(table.of_track(track)["source"] != Source.TRACKER))


def plan_put_box(
    table: TrackTable,
    track: int | None,
    frame: int,
    box: Box,
    *,
    view: View | None = None,
    how: How | None = None,
    fps: float | None = None,
) -> Change:
    """Have a track's box of one frame there: move the one it has, else draw one: a keyframe.

    Between it and the rows beside it a track that was made by hand is interpolated. None: the box
    begins a new track.

    Raises:
        EditError: the box is none, or nothing would change.
    """
    if track is not None and len(table.of_track(track, frame, frame + 1)["frame"]):
        return plan_move_box(table, track, frame, box, view=view, how=how, fps=fps)
    join = track is not None and is_by_hand(table, track)
    return plan_draw_box(table, track, frame, box, view=view, how=how, fps=fps, join=join)


def plan_put_boxes(
    table: TrackTable,
    frame: int,
    boxes: Mapping[int, Box],
    *,
    view: View | None = None,
    how: How | None = None,
    fps: float | None = None,
) -> Change:
    """The same for several tracks in one frame, as one edit.

    Raises:
        EditError: there are no boxes, one is none, or nothing would change for a track.
    """
    if not boxes:
        raise EditError("no boxes to put in frame {frame}", frame=frame)
    changes = [
        plan_put_box(table, track, frame, box, view=view, how=how, fps=fps)
        for track, box in sorted(boxes.items())
    ]
    if len(changes) == 1:
        return changes[0]
    sides = [
        State(rows=stack_rows(side.rows for side in each))
        for each in ([one.before for one in changes], [one.after for one in changes])
    ]
    scopes = [one.scope for one in changes if one.scope is not None]
    ends = [one.end for one in scopes if one.end is not None]
    text = msg("Put boxes of {who} in frame {frame}", who=tracks_text(sorted(boxes)), frame=frame)
    scope = Scope(min(one.start for one in scopes), max(ends))
    return Change("draw", text, frame, sides[0], sides[1], scope)


def plan_propagate(
    table: TrackTable,
    track: int,
    frame: int,
    end: int,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Copy a track's box of one frame onto the following ones, up to a frame it ends before.

    The first and the last box are keyframes then, those between interpolated, so that moving the
    last one takes them along. A later keyframe stands fast: the copies end before it, and what was
    interpolated up to it follows.

    Raises:
        EditError: the track has no row in the frame, no frame follows, the next is a keyframe, or
            nothing would change.
    """
    check_scope(frame, end)
    row = standing_row(table, track, frame)
    keys = keyframes_of(table, track, frame + 1, end)
    stop = int(keys[0]) if len(keys) else end
    if stop - frame < 2:
        raise EditError(
            "track {track}: no frame to copy the box of frame {frame} onto; choose a longer range, "
            "or delete the keyframe after it",
            track=track,
            frame=frame,
        )
    old = _window(table, track, frame, stop)
    new = _with_copies(old, row, stop)
    new = reinterpolate(old, new, Way(None, view, fps))
    before, after = compare_windows(old, new)
    _check_changed(before, after, track)
    text = msg(
        "Copy the box of {track} in frame {frame} up to frame {last}",
        track=track,
        frame=frame,
        last=stop - 1,
    )
    return Change(
        "propagate", text, frame, State(rows=before), State(rows=after), Scope(frame, stop)
    )


def _window(table: TrackTable, track: int, frame: int, stop: int) -> Rows:
    """The track's rows that copies in the frames up to `stop` can touch."""
    sides = rows_around(table, track, frame), rows_around(table, track, stop - 1)
    first, last = frame, stop - 1
    for side in sides:
        if len(side["frame"]):
            first, last = min(first, int(side["frame"][0])), max(last, int(side["frame"][-1]))
    return select_rows(table.of_track(track, first, last + 1), slice(None))


def _with_copies(old: Rows, row: Rows, stop: int) -> Rows:
    """The window with a row copied onto the frames after it; the first and last are keyframes."""
    frame = int(row["frame"][0])
    copies = select_rows(row, np.zeros(stop - frame, np.intp))
    copies["frame"][:] = np.arange(frame, stop)
    for name in ("vx", "vy"):
        copies[name][:] = 0.0 if np.isfinite(row["x"][0] + row["y"][0]) else np.nan
    vouch_for(copies)
    copies["source"][1:-1] = Source.INTERPOLATED
    outside = (old["frame"] < frame) | (old["frame"] >= stop)
    return stack_rows([select_rows(old, outside), copies])


def _check_changed(before: Rows, after: Rows, track: int) -> None:
    same = len(before["frame"]) == len(after["frame"])
    if same and not rows_differ(before, after).any():
        raise EditError("track {track} is already so; nothing to change", track=track)
