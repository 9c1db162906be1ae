"""The frames that an edit touches."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.core.tracks.edit_context import EditContext

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow


def frame_bounds(flow: EditFlow, on: EditContext) -> tuple[int, int]:
    """The frames of the edit, to the end of its tracks where it goes on."""
    ends = [on.table.frame_range(track)[1] for track in flow.everybody]
    return flow.start, flow.stop if flow.stop is not None else max(ends)
