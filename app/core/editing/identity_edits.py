"""Edits of who is who: swap, split, merge, give to another id, delete."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from app.core.editing.edit_options import EditScope, Fill, Way
from app.core.editing.edit_spec import EditCommand, EditSpec
from app.core.tracks.edit_context import EditContext
from tracking.editing import (
    Change,
    Keep,
    plan_delete,
    plan_delete_tracks,
    plan_merge_tracks,
    plan_reassign,
    plan_split,
    plan_swap,
)

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow

_ANY: Final = (EditScope.ON, EditScope.RANGE, EditScope.FRAME, EditScope.WHOLE)

_KEEPS: Final[Mapping[Way, Keep]] = {
    Way.KEEP_FIRST: "first",
    Way.KEEP_SECOND: "second",
    Way.KEEP_SURER: "surer",
}


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


SWAP: Final = EditSpec(
    "swap",
    "Swap {a} with...",
    _swap,
    _ANY,
    (EditCommand("tracks.swap", "Swap with...", ("X",), icon="swap", also="exchange id switch"),),
    of_two=True,
)

SPLIT: Final = EditSpec(
    "split",
    "Split {a}",
    _split,
    (EditScope.ON,),
    (EditCommand("tracks.split", "Split here", ("S",), icon="split", also="cut"),),
)

MERGE: Final = EditSpec(
    "merge",
    "Merge into {a}...",
    _merge,
    (EditScope.WHOLE,),
    (EditCommand("tracks.merge", "Merge with...", ("M",), icon="merge", also="join link stitch"),),
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
    (EditCommand("tracks.reassign", "Give to another id...", ("A",), also="relabel change id"),),
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
            also="outside gone leaves remove",
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

EDITS: Final = (SWAP, SPLIT, MERGE, REASSIGN, DELETE)
