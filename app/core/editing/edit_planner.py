"""The change that an edit on its way comes to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

import numpy as np

from app.core.editing.flow import EditFlow, Fill
from app.core.editing.gap_places import gap_near
from app.core.editing.kinds import EditKind, EditScope, Way
from app.core.i18n import tr
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import box_of
from tracking.editing import (
    Change,
    How,
    Keep,
    keyframes_of,
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
    rows_beyond_the_log,
    with_parts_carried,
)
from tracking.errors import EditError
from tracking.tracks import Source, TrackTable

_KEEPS: Final[Mapping[Way, Keep]] = {
    Way.KEEP_FIRST: "first",
    Way.KEEP_SECOND: "second",
    Way.KEEP_SURER: "surer",
}
_HOWS: Final[Mapping[Way, How]] = {Way.LINEAR: "linear", Way.FLOOR: "floor"}


def plan_of(flow: EditFlow, on: EditContext) -> Change:
    """The change that Enter applies.

    Raises:
        EditError: the edit does not apply to the tracks as they are.
    """
    if flow.needs_other:
        raise EditError(tr("The other person is not picked yet: click on them"))
    change = with_parts_carried(_PLANNERS[flow.kind](flow, on), on.labels)
    refuse_too_large(change)
    return change


def refuse_too_large(change: Change) -> None:
    """Raise EditError where a change is larger than the history can keep: before it is tried."""
    rows = rows_beyond_the_log(change)
    if rows:
        raise EditError(
            tr(
                "{n} boxes at once are more than the history can keep: "
                "choose a shorter range of frames, or fewer people at a time",
                n=f"{rows:,}",
            )
        )


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


_PLANNERS: Final[Mapping[EditKind, Callable[[EditFlow, EditContext], Change]]] = {
    EditKind.SWAP: _swap,
    EditKind.SPLIT: _split,
    EditKind.MERGE: _merge,
    EditKind.REASSIGN: _reassign,
    EditKind.DELETE: _delete,
    EditKind.DRAW: _draw,
    EditKind.MOVE: _move,
    EditKind.FLOOR: _drag,
    EditKind.INTERPOLATE: _interpolate,
    EditKind.FILL: _fill,
    EditKind.FILL_ALL: _fill_all,
    EditKind.KEYFRAME: _keyframe,
    EditKind.NO_KEYFRAME: _no_keyframe,
    EditKind.THIN: _thin,
    EditKind.OCCLUDE: _occlude,
    EditKind.SHOW: _show,
    EditKind.REVIEW: _review,
}


def stretch_between_keyframes(table: TrackTable, track: int, frame: int) -> tuple[int, int]:
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
            tr(
                "Track {track} has no keyframe {missing} frame {frame}: draw or move a box there, "
                "or choose a range",
                track=track,
                missing=missing,
                frame=frame,
            )
        )
    return int(keys[after - 1]), int(keys[after]) + 1
