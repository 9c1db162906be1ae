"""Edits of boxes and places: draw, move, keyframes, gaps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

import numpy as np

from app.core.editing.edit_options import EditScope, LongestGap, Way
from app.core.editing.edit_spec import EditCommand, EditSpec
from app.core.editing.frame_bounds import frame_bounds
from app.core.editing.gap_places import gap_near
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import box_of
from tracking.editing import (
    Change,
    How,
    keyframes_of,
    plan_add_keyframe,
    plan_delete_keyframe,
    plan_drag,
    plan_draw_box,
    plan_fill_gap,
    plan_fill_gaps,
    plan_interpolate,
    plan_move_box,
    plan_new_track,
    plan_propagate,
    plan_put_box,
    plan_put_boxes,
    plan_thin,
)
from tracking.errors import EditError
from tracking.tracks import Source, TrackTable

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow

_PATHS: Final = (Way.FLOOR, Way.LINEAR)

_HOWS: Final[Mapping[Way, How]] = {Way.LINEAR: "linear", Way.FLOOR: "floor"}


def _draw(flow: EditFlow, on: EditContext) -> Change:
    if flow.box is None:
        raise EditError("Draw the box: drag from one of its corners to the opposite one")
    view, fps = on.geometry.view, on.geometry.fps
    if not flow.track:
        return plan_new_track(on.table, flow.cut, flow.box, view=view)
    return plan_draw_box(
        on.table,
        flow.track,
        flow.cut,
        flow.box,
        view=view,
        fps=fps,
        join=flow.scope is EditScope.JOINED,
    )


def _move(flow: EditFlow, on: EditContext) -> Change:
    row = on.table.of_track(flow.track, flow.cut, flow.cut + 1)
    made = len(row["frame"]) and row["source"][0] == Source.PERSON
    if flow.box is None or (made and box_of(row) == flow.box):
        raise EditError("Move the box with the arrow keys, or drag it or its handles")
    geometry = on.geometry
    return plan_move_box(
        on.table, flow.track, flow.cut, flow.box, view=geometry.view, fps=geometry.fps
    )


def _drag(flow: EditFlow, on: EditContext) -> Change:
    if on.geometry.view is None:
        raise EditError("The recording does not state where the floor is: move the box instead")
    if flow.place is None:
        raise EditError("Move the person with the arrow keys, or drag them in the overhead view")
    view, fps = on.geometry.view, on.geometry.fps
    return plan_drag(on.table, flow.track, flow.cut, flow.place, view, fps=fps)


def _put(flow: EditFlow, on: EditContext) -> Change:
    view, fps = on.geometry.view, on.geometry.fps
    if flow.boxes:
        return plan_put_boxes(on.table, flow.cut, dict(flow.boxes), view=view, fps=fps)
    if flow.box is None:
        raise EditError(
            "There is no box to put here: copy one{key}, or draw it",
            key=in_brackets("tracks.copy_box"),
        )
    return plan_put_box(on.table, flow.track or None, flow.cut, flow.box, view=view, fps=fps)


def _propagate(flow: EditFlow, on: EditContext) -> Change:
    start, end = frame_bounds(flow, on)
    geometry = on.geometry
    end = min(end, geometry.frame_count)
    return plan_propagate(on.table, flow.track, start, end, view=geometry.view, fps=geometry.fps)


def _interpolate(flow: EditFlow, on: EditContext) -> Change:
    start, end = flow.cut, flow.end
    if flow.scope is EditScope.BETWEEN:
        start, end = _stretch_between_keyframes(on.table, flow.track, flow.cut)
    how, geometry = _HOWS[flow.way], on.geometry
    return plan_interpolate(
        on.table, flow.track, start, end, how, view=geometry.view, fps=geometry.fps
    )


def _stretch_between_keyframes(table: TrackTable, track: int, frame: int) -> tuple[int, int]:
    """The half-open stretch from the keyframe at or before a frame to the next one.

    Raises:
        EditError: there is no keyframe on one of the sides.
    """
    keys = keyframes_of(table, track)
    after = int(np.searchsorted(keys, frame, side="right"))
    if after == len(keys) and after >= 2 and int(keys[-1]) == frame:
        after -= 1  # at the last keyframe: the stretch that ends there
    if not 0 < after < len(keys):
        missing = tr("before") if after == 0 else tr("after")
        raise EditError(
            "Track {track} has no keyframe {missing} frame {frame}: draw or move a box there, "
            "or choose a range",
            track=track,
            missing=missing,
            frame=frame,
        )
    return int(keys[after - 1]), int(keys[after]) + 1


def _fill(flow: EditFlow, on: EditContext) -> Change:
    frame, geometry = gap_near(on.table, flow.track, flow.cut), on.geometry
    if frame is None:
        raise EditError(
            "Track {track} has no gap between its first and last frame", track=flow.track
        )
    how = _HOWS[flow.way]
    return plan_fill_gap(on.table, flow.track, frame, how, view=geometry.view, fps=geometry.fps)


def _fill_all(flow: EditFlow, on: EditContext) -> Change:
    geometry, seconds = on.geometry, flow.longest.seconds
    longest = round(seconds * geometry.fps) if np.isfinite(seconds) else geometry.frame_count
    how = _HOWS[flow.way]
    return plan_fill_gaps(
        on.table, flow.everybody, longest, how, view=geometry.view, fps=geometry.fps
    )


def _keyframe(flow: EditFlow, on: EditContext) -> Change:
    return plan_add_keyframe(on.table, flow.track, flow.cut)


def _no_keyframe(flow: EditFlow, on: EditContext) -> Change:
    geometry = on.geometry
    return plan_delete_keyframe(
        on.table, flow.track, flow.cut, view=geometry.view, fps=geometry.fps
    )


def _thin(flow: EditFlow, on: EditContext) -> Change:
    start, end = frame_bounds(flow, on)
    geometry = on.geometry
    return plan_thin(on.table, flow.track, start, end, view=geometry.view, fps=geometry.fps)


DRAW: Final = EditSpec(
    "draw", "Draw a box of {a}", _draw, (EditScope.FRAME, EditScope.JOINED), places=True
)

PUT: Final = EditSpec(
    "put", "Put a box of {a}", _put, (EditScope.FRAME,), places=True, at_once=True
)

PROPAGATE: Final = EditSpec(
    "propagate",
    "Copy the box of {a} onto the next frames",
    _propagate,
    (EditScope.RANGE,),
    (
        EditCommand(
            "tracks.propagate",
            "Copy the box onto the next frames",
            ("Ctrl+B",),
            submenu="Annotate",
            also="propagate forward",
        ),
    ),
)

MOVE: Final = EditSpec(
    "move",
    "Move the box of {a}",
    _move,
    (EditScope.FRAME,),
    (EditCommand("tracks.move_box", "Move or resize the box", ("V",), submenu="Draw and move"),),
    places=True,
)

FLOOR: Final = EditSpec(
    "floor",
    "Move {a} on the floor",
    _drag,
    (EditScope.FRAME,),
    (
        EditCommand(
            "tracks.move_floor",
            "Move on the floor",
            ("Shift+V",),
            submenu="Draw and move",
            floor=True,
        ),
    ),
    places=True,
)

KEYFRAME: Final = EditSpec(
    "keyframe",
    "Make a keyframe of {a}",
    _keyframe,
    (EditScope.FRAME,),
    (
        EditCommand(
            "tracks.keyframe", "Make this a keyframe", ("Shift+W",), submenu="Keyframes and gaps"
        ),
    ),
)

NO_KEYFRAME: Final = EditSpec(
    "no keyframe",
    "Delete a keyframe of {a}",
    _no_keyframe,
    (EditScope.FRAME,),
    (
        EditCommand(
            "tracks.no_keyframe",
            "Delete the keyframe",
            ("Ctrl+Shift+W",),
            submenu="Keyframes and gaps",
        ),
    ),
)

THIN: Final = EditSpec(
    "thin",
    "Make keyframes of {a}",
    _thin,
    (EditScope.RANGE, EditScope.ON, EditScope.WHOLE),
    (
        EditCommand(
            "tracks.thin",
            "Make keyframes of what was tracked",
            ("Alt+W",),
            submenu="Keyframes and gaps",
            also="thin simplify",
        ),
    ),
)

INTERPOLATE: Final = EditSpec(
    "interpolate",
    "Interpolate {a}",
    _interpolate,
    (EditScope.BETWEEN, EditScope.RANGE),
    (
        EditCommand(
            "tracks.interpolate",
            "Interpolate between keyframes",
            ("I",),
            submenu="Keyframes and gaps",
            separated=True,
        ),
    ),
    ways=_PATHS,
)

FILL: Final = EditSpec(
    "fill",
    "Fill a gap of {a}",
    _fill,
    (EditScope.GAP,),
    (EditCommand("tracks.fill_gap", "Fill the gap", ("Shift+I",), submenu="Keyframes and gaps"),),
    ways=_PATHS,
)

FILL_ALL: Final = EditSpec(
    "fill all",
    "Fill the gaps of {a}",
    _fill_all,
    (EditScope.WHOLE,),
    (EditCommand("tracks.fill_gaps", "Fill all gaps", ("Ctrl+I",), submenu="Keyframes and gaps"),),
    ways=_PATHS,
    of_several=True,
    leads=True,
    first=tuple(LongestGap),
)

EDITS: Final = (
    DRAW,
    PUT,
    MOVE,
    FLOOR,
    KEYFRAME,
    NO_KEYFRAME,
    THIN,
    INTERPOLATE,
    FILL,
    FILL_ALL,
    PROPAGATE,
)
