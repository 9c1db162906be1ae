"""The change that a pending edit comes to."""

from __future__ import annotations

from app.core.editing.flow import EditFlow
from app.core.tracks.edit_context import EditContext
from tracking.editing import Change, rows_beyond_the_log, with_parts_carried
from tracking.errors import EditError


def plan_of(flow: EditFlow, on: EditContext) -> Change:
    """The change that Enter applies.

    Raises:
        EditError: the edit does not apply to the tracks as they are.
    """
    if flow.needs_other:
        raise EditError("The other person is not picked yet: click on them")
    change = with_parts_carried(flow.spec.plan(flow, on), on.labels)
    refuse_too_large(change)
    return change


def refuse_too_large(change: Change) -> None:
    """Raise EditError where a change is larger than the history can keep: before it is tried."""
    rows = rows_beyond_the_log(change)
    if rows:
        raise EditError(
            "{n} boxes at once are more than the history can keep: "
            "choose a shorter range of frames, or fewer people at a time",
            n=f"{rows:,}",
        )
