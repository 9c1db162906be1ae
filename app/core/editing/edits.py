"""The kinds of edits, each declared once beside what plans it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

import numpy as np

from app.core.editing.edit_options import EditScope, Fill, LongestGap, Way
from app.core.editing.edit_spec import EditCommand, EditSpec
from app.core.editing.gap_places import gap_near
from app.core.editing.keyframe_stretch import stretch_between_keyframes
from app.core.i18n import tr
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import box_of
from tracking.editing import (
    Change,
    How,
    Keep,
    plan_add_keyframe,
    plan_delete,
    plan_delete_keyframe,
    plan_delete_tracks,
    plan_drag,
    plan_draw_box,
    plan_fill_gap,
    plan_fill_gaps,
    plan_interpolate,
    plan_mark_occluded,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_move_box,
    plan_new_track,
    plan_reassign,
    plan_split,
    plan_swap,
    plan_thin,
)
from tracking.errors import EditError
from tracking.tracks import Source

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow

_ANY: Final = (EditScope.ON, EditScope.RANGE, EditScope.FRAME, EditScope.WHOLE)
_STRETCH: Final = (EditScope.FRAME, EditScope.RANGE, EditScope.ON, EditScope.WHOLE)
_PATHS: Final = (Way.FLOOR, Way.LINEAR)
_KEEPS: Final[Mapping[Way, Keep]] = {
    Way.KEEP_FIRST: "first",
    Way.KEEP_SECOND: "second",
    Way.KEEP_SURER: "surer",
}
_HOWS: Final[Mapping[Way, How]] = {Way.LINEAR: "linear", Way.FLOOR: "floor"}


def _swap(flow: EditFlow, on: EditContext) -> Change:
    return plan_swap(on.table, flow.track, flow.other, flow.start, flow.stop)


def _split(flow: EditFlow, on: EditContext) -> Change:
    return plan_split(on.table, flow.track, flow.cut)


def _merge(flow: EditFlow, on: EditContext) -> Change:
    geometry, others = on.geometry, flow.also or (flow.other,)
    return plan_merge_tracks(
        on.table,
        flow.track,
        others,
        _KEEPS[flow.way],
        on.labels,
        fill=flow.fill is Fill.FILL,
        view=geometry.view,
        fps=geometry.fps,
    )


def _reassign(flow: EditFlow, on: EditContext) -> Change:
    return plan_reassign(on.table, flow.track, flow.other, flow.start, flow.stop)


def _delete(flow: EditFlow, on: EditContext) -> Change:
    if flow.also:
        return plan_delete_tracks(on.table, flow.everybody, flow.start, flow.stop)
    return plan_delete(on.table, flow.track, flow.start, flow.stop)


def _draw(flow: EditFlow, on: EditContext) -> Change:
    if flow.box is None:
        raise EditError(tr("Draw the box: drag from one of its corners to the opposite one"))
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
        raise EditError(tr("Move the box with the arrow keys, or drag it or its handles"))
    geometry = on.geometry
    return plan_move_box(
        on.table, flow.track, flow.cut, flow.box, view=geometry.view, fps=geometry.fps
    )


def _drag(flow: EditFlow, on: EditContext) -> Change:
    if on.geometry.view is None:
        raise EditError(tr("The recording does not say where the floor is: move the box instead"))
    if flow.place is None:
        raise EditError(
            tr("Move the person with the arrow keys, or drag them in the overhead view")
        )
    view, fps = on.geometry.view, on.geometry.fps
    return plan_drag(on.table, flow.track, flow.cut, flow.place, view, fps=fps)


def _interpolate(flow: EditFlow, on: EditContext) -> Change:
    start, end = flow.cut, flow.end
    if flow.scope is EditScope.BETWEEN:
        start, end = stretch_between_keyframes(on.table, flow.track, flow.cut)
    how, geometry = _HOWS[flow.way], on.geometry
    return plan_interpolate(
        on.table, flow.track, start, end, how, view=geometry.view, fps=geometry.fps
    )


def _fill(flow: EditFlow, on: EditContext) -> Change:
    frame, geometry = gap_near(on.table, flow.track, flow.cut), on.geometry
    if frame is None:
        said = tr("Track {track} has no gap between its first and last frame", track=flow.track)
        raise EditError(said)
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
    start, end = _bounded(flow, on)
    geometry = on.geometry
    return plan_thin(on.table, flow.track, start, end, view=geometry.view, fps=geometry.fps)


def _occlude(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_occluded(on.table, flow.everybody, flow.start, flow.stop, occluded=True)


def _show(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_occluded(on.table, flow.everybody, flow.start, flow.stop, occluded=False)


def _review(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_reviewed(on.labels, flow.everybody, *_bounded(flow, on), on.table)


def _bounded(flow: EditFlow, on: EditContext) -> tuple[int, int]:
    """The frames of the edit, to the end of its tracks where it goes on."""
    ends = [on.table.frame_range(track)[1] for track in flow.everybody]
    return flow.start, flow.stop if flow.stop is not None else max(ends)


SWAP: Final = EditSpec(
    "swap",
    "Swap {a} with...",
    _swap,
    _ANY,
    (EditCommand("tracks.swap", "Swap with...", ("X",), icon="swap"),),
    of_two=True,
)

SPLIT: Final = EditSpec(
    "split",
    "Split {a}",
    _split,
    (EditScope.ON,),
    (EditCommand("tracks.split", "Split here", ("S",), icon="split"),),
)

MERGE: Final = EditSpec(
    "merge",
    "Merge into {a}...",
    _merge,
    (EditScope.WHOLE,),
    (EditCommand("tracks.merge", "Merge with...", ("M",), icon="merge"),),
    ways=(Way.KEEP_FIRST, Way.KEEP_SECOND, Way.KEEP_SURER),
    of_two=True,
    of_several=True,
    second=tuple(Fill),
)

REASSIGN: Final = EditSpec(
    "reassign",
    "Give {a} to...",
    _reassign,
    _ANY,
    (EditCommand("tracks.reassign", "Give to another id...", ("A",)),),
    of_two=True,
)

DELETE: Final = EditSpec(
    "delete",
    "Delete {a}",
    _delete,
    _ANY,
    (
        EditCommand(
            "tracks.end_here",
            "Delete from here on",
            ("Del",),
            submenu="Delete",
            icon="delete",
            separated=True,
            scope=EditScope.ON,
        ),
        EditCommand(
            "tracks.delete_range",
            "Delete a range",
            ("Alt+Del",),
            submenu="Delete",
            scope=EditScope.RANGE,
        ),
        EditCommand(
            "tracks.delete_frame",
            "Delete in this frame",
            ("Shift+Del",),
            submenu="Delete",
            scope=EditScope.FRAME,
        ),
        EditCommand(
            "tracks.delete_track",
            "Delete the whole track",
            ("Ctrl+Del",),
            submenu="Delete",
            scope=EditScope.WHOLE,
        ),
    ),
    of_several=True,
)

DRAW: Final = EditSpec(
    "draw", "Draw a box of {a}", _draw, (EditScope.FRAME, EditScope.JOINED), places=True
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
    "Take a keyframe of {a} out",
    _no_keyframe,
    (EditScope.FRAME,),
    (
        EditCommand(
            "tracks.no_keyframe",
            "Take the keyframe out",
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

OCCLUDE: Final = EditSpec(
    "occlude",
    "Mark {a} as occluded",
    _occlude,
    _STRETCH,
    (EditCommand("tracks.occluded", "Mark as occluded", ("H",), submenu="Mark as"),),
    of_several=True,
)

SHOW: Final = EditSpec(
    "show",
    "Mark {a} as visible",
    _show,
    _STRETCH,
    (EditCommand("tracks.visible", "Mark as visible", ("Shift+H",), submenu="Mark as"),),
    of_several=True,
)

REVIEW: Final = EditSpec(
    "review",
    "Mark {a} as reviewed",
    _review,
    _STRETCH,
    (EditCommand("tracks.reviewed", "Mark as reviewed", ("Y",), submenu="Mark as"),),
    of_several=True,
    leads=False,
)


EDITS: Final = (
    SWAP,
    SPLIT,
    MERGE,
    REASSIGN,
    DELETE,
    DRAW,
    MOVE,
    FLOOR,
    KEYFRAME,
    NO_KEYFRAME,
    THIN,
    INTERPOLATE,
    FILL,
    FILL_ALL,
    OCCLUDE,
    SHOW,
    REVIEW,
)


def edit_named(name: str) -> EditSpec:
    """The kind of edit of a name. Raises KeyError where there is none."""
    return {spec.name: spec for spec in EDITS}[name]
