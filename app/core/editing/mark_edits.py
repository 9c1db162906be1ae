"""Edits that mark rows: occluded, visible, reviewed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from app.core.editing.edit_options import EditScope
from app.core.editing.edit_spec import EditCommand, EditSpec
from app.core.editing.frame_bounds import frame_bounds
from app.core.tracks.edit_context import EditContext
from tracking.editing import (
    Change,
    plan_mark_occluded,
    plan_mark_reviewed,
)

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow

_STRETCH: Final = (EditScope.FRAME, EditScope.RANGE, EditScope.ON, EditScope.WHOLE)


def _occlude(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_occluded(on.table, flow.everybody, flow.start, flow.stop, occluded=True)


def _show(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_occluded(on.table, flow.everybody, flow.start, flow.stop, occluded=False)


def _review(flow: EditFlow, on: EditContext) -> Change:
    return plan_mark_reviewed(on.labels, flow.everybody, *frame_bounds(flow, on), on.table)


OCCLUDE: Final = EditSpec(
    "occlude",
    "Mark {a} as occluded",
    _occlude,
    _STRETCH,
    (
        EditCommand(
            "tracks.occluded", "Mark as occluded", ("H",), submenu="Mark as", also="hidden covered"
        ),
    ),
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

EDITS: Final = (OCCLUDE, SHOW, REVIEW)
