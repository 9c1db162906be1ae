"""The box or the place that an edit of one begins with."""

from __future__ import annotations

import numpy as np

from app.core.editing.flow import EditFlow
from app.core.editing.nearness import nearest_row
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import Place, box_of
from tracking.tracks import Box


def propose_initial_box(flow: EditFlow, on: EditContext) -> Box:
    """The box of the person in the frame or where they stand nearest to it; else a usual one."""
    row = nearest_row(on.table, flow.track, flow.cut)
    box = box_of(row) if row is not None else on.geometry.first_box()
    return box if np.isfinite(box).all() and min(box[2:]) > 0 else on.geometry.first_box()


def propose_initial_place(flow: EditFlow, on: EditContext) -> Place | None:
    """Where the person stands in the frame; None where they do not, or nobody knows where."""
    row = on.table.of_track(flow.track, flow.cut, flow.cut + 1)
    if not len(row["x"]) or not np.isfinite(row["x"][0] + row["y"][0]):
        return None
    return float(row["x"][0]), float(row["y"][0])
