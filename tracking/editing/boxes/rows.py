"""Planners of edits that add, change or delete rows. They only look; nothing changes here."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tracking.editing.boxes.floor_boxes import (
    USUAL_HEIGHT_M,
    body_position,
    boxes_of,
    places_of,
    position_after_move,
    standing_box,
)
from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.keyframes import key_row_change, put_by_hand, standing_row
from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import (
    Scope,
    check_id,
    check_scope,
    check_tracks,
    scope_text,
    tracks_text,
)
from tracking.editing.core.selection import Rows, select_rows, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import (
    CORRECTED_COLUMNS,
    LARGEST_NUMBER,
    Box,
    Columns,
    TrackTable,
    check_known,
    next_track,
)
from tracking.translation import msg

_SAME_PX = 0.5
_SAME_SIZE_PX = 1e-3
Place = tuple[float, float]
"""x, y in metres on the floor."""


def plan_delete(table: TrackTable, track: int, start: int = 0, end: int | None = None) -> Change:
    """Delete a track's rows in frames start to end; without a range: the whole track.

    Its label stays, so that a deletion undone or a track drawn anew finds it.
    Raises EditError where there is nothing to delete.
    """
    check_known(table, track)
    return plan_delete_tracks(table, [track], start, end)


def plan_delete_tracks(
    table: TrackTable, tracks: Iterable[int], start: int = 0, end: int | None = None
) -> Change:
    """Delete several tracks' rows in frames start to end; without a range: the whole tracks.

    Their labels stay. Raises EditError where there is nothing to delete.
    """
    chosen = check_tracks(table, tracks)
    check_scope(start, end)
    parts = {track: table.of_track(track, start, end) for track in chosen}
    touched = [track for track, rows in parts.items() if len(rows["frame"])]
    if not touched:
        raise EditError(
            "{who}: no rows to delete {where}; choose another range",
            who=tracks_text(chosen),
            where=scope_text(start, end),
        )
    who = tracks_text(touched)
    rows = stack_rows(parts.values())
    first = min(table.frame_range(track)[0] for track in touched)
    stop = max(table.frame_range(track)[1] for track in touched)
    text = msg(
        "Delete {who} {where}",
        who=who,
        where=scope_text(start, None if end is None or end >= stop else end),
    )
    if start <= first and (end is None or end >= stop):
        text = (
            msg("Delete track {who}", who=who)
            if len(touched) == 1
            else msg("Delete tracks {who}", who=who)
        )
    frame = int(rows["frame"][0])
    return Change("delete", text, frame, State(rows=rows), State(), Scope(start, end))


def plan_move_box(
    table: TrackTable,
    track: int,
    frame: int,
    box: Box,
    position: Place | None = None,
    *,
    view: View | None = None,
    how: How | None = None,
    fps: float | None = None,
) -> Change:
    """Put a track's box of one frame elsewhere; the row becomes a keyframe.

    Interpolated stretches beside the frame follow in the same change. A row is never deleted for
    a number that is missing.

    Args:
        table, track, frame, box: what, when and whereto.
        position: x, y in metres on the floor that belong to the box; None: the foot goes along
            with the box as the view sees it; without a view, or where no floor is seen there, the
            place is kept while the box's foot stays where it was, else NaN is written.
        view: the left camera over its floor.
        how, fps: of the stretches beside it and of velocities.

    Raises:
        EditError: the track has no row in the frame, the box is none, or nothing would change.
    """
    row = standing_row(table, track, frame)
    _check_box(box)
    resized = abs(row["width"][0] - box[2]) + abs(row["height"][0] - box[3]) > _SAME_SIZE_PX
    place = _followed(row, box, view) if position is None else position
    _place(row, box, place)
    text = msg(
        "Resize the box of {track} in frame {frame}"
        if resized
        else "Move the box of {track} in frame {frame}",
        track=track,
        frame=frame,
    )
    return key_row_change(table, row, Way(how, view, fps), ("move", text))


def plan_draw_box(
    table: TrackTable,
    track: int | None,
    frame: int,
    box: Box,
    position: Place | None = None,
    *,
    view: View | None = None,
    how: How | None = None,
    fps: float | None = None,
    join: bool = False,
) -> Change:
    """Add a box a person drew, to a track or (None) as the first of a new one: a keyframe.

    Args:
        table, track, frame, box: what, when and where.
        position: x, y in metres on the floor; None: told from the box where there is a view.
        view: the left camera over its floor.
        how, fps: of the interpolation and of velocities.
        join: the gaps between it and the track's rows before and after are interpolated, too.

    Raises:
        EditError: the track stands in the frame already, the box is none, or the id is new and far
            above the highest ever used.
    """
    owner = next_track(table) if track is None else track
    _check_free(table, owner, frame)
    _check_box(box)
    if position is None and view is not None:
        position = body_position(view, box)
    row = _drawn(owner, frame)
    _place(row, box, position or (np.nan, np.nan))
    text = msg(
        "Draw new track {owner} in frame {frame}"
        if track is None
        else "Draw a box of {owner} in frame {frame}",
        owner=owner,
        frame=frame,
    )
    return key_row_change(table, row, Way(how, view, fps), ("draw", text), join=join)


def plan_new_track(
    table: TrackTable,
    frame: int,
    box: Box | None = None,
    position: Place | None = None,
    *,
    view: View | None = None,
    height_m: float = USUAL_HEIGHT_M,
) -> Change:
    """Begin a new track with its first keyframe; its id was never used before.

    Given a box, a place on the floor, or both; a box alone gets its place from the view, and a
    place alone its box, as of somebody of that height.
    Raises EditError for neither, for a place without a view and one that is not to be seen.
    """
    if box is None:
        if position is None or view is None:
            raise EditError("a new track needs a box, or a place on the floor and a calibration")
        box = standing_box(view, position, height_m)
    return plan_draw_box(table, None, frame, box, position, view=view)


def _followed(row: Columns, box: Box, view: View | None) -> Place:
    """Where on the floor the person of a moved box stands; NaN where nothing tells."""
    old_box, old_place, new = boxes_of(row)[0], places_of(row)[0], np.array(box, float)
    moved = old_box[:2] - new[:2] + (old_box[2:] - new[2:]) * (0.5, 1.0)
    if np.isfinite(old_place).all() and np.abs(moved).max() <= _SAME_PX:
        return float(old_place[0]), float(old_place[1])
    if view is None:
        return np.nan, np.nan
    return position_after_move(view, old_box, old_place, new)


def _drawn(track: int, frame: int) -> Rows:
    """A row of which only track and frame are known."""
    row = {name: np.zeros(1, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    row["frame"][0], row["track"][0] = frame, track
    row["vx"][0] = row["vy"][0] = np.nan
    row["visibility"][0] = 1.0
    return row


def _check_free(table: TrackTable, track: int, frame: int) -> None:
    """Raise EditError where no row of a track, known or new, can be added in a frame."""
    if frame < 0:
        raise EditError("frame {frame} is negative; frames count from 0", frame=frame)
    check_id(table, track)
    if frame >= LARGEST_NUMBER:
        raise EditError(
            "frame {frame}: frames go up to {last}", frame=frame, last=LARGEST_NUMBER - 1
        )
    if len(table.of_track(track, frame, frame + 1)["frame"]):
        raise EditError(
            "track {owner} stands in frame {frame} already; move its box instead",
            owner=track,
            frame=frame,
        )


def _check_box(box: Box) -> None:
    if not (len(box) == 4 and np.isfinite(box).all() and box[2] > 0 and box[3] > 0):
        raise EditError(
            "box {box} is none; left, top and a positive width and height are needed", box=box
        )


def _place(row: Rows, box: Box, place: Place) -> None:
    """Write a person's box and place into a single row; NaN: the place is unknown."""
    if np.isinf(place).any():
        raise EditError("place {place} is none; x and y in metres are needed", place=place)
    put_by_hand(row, box, place)


def plan_mark_occluded(
    table: TrackTable,
    tracks: Iterable[int],
    start: int = 0,
    end: int | None = None,
    occluded: bool = True,
) -> Change:
    """Say that people are hidden (visibility 0) or in full view (1) in frames start to end.

    end None: from there on. Their boxes and where these come from stay as they are.
    Raises EditError where none of them stands in the range, or it is said already.
    """
    chosen = check_tracks(table, tracks)
    check_scope(start, end)
    rows = stack_rows(table.of_track(track, start, end) for track in chosen)
    who, where = tracks_text(chosen), scope_text(start, end)
    if not len(rows["frame"]):
        raise EditError(
            "{who}: no rows to mark {where}; choose another range", who=who, where=where
        )
    wanted = np.float32(0.0 if occluded else 1.0)
    old = select_rows(rows, rows["visibility"] != wanted)
    state = msg("occluded") if occluded else msg("visible")
    if not len(old["frame"]):
        raise EditError(
            "{who}: marked as {state} {where} already", who=who, state=state, where=where
        )
    new = select_rows(old, slice(None))
    new["visibility"][:] = wanted
    text = msg("Mark {who} as {state} {where}", who=who, state=state, where=where)
    frame, scope = int(old["frame"][0]), Scope(start, end)
    return Change("occluded", text, frame, State(rows=old), State(rows=new), scope)
