"""What an edit would do, in words, as boxes, and as trails before and after."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.core.colours.track_colours import ColourOf
from app.core.editing.edit_planner import plan_of
from app.core.editing.edit_texts import preview_scene
from app.core.editing.flow import EditFlow, Range
from app.core.editing.preview_tracks import apply_to_rows, within
from app.core.error_messages import explain_in_sentence
from app.core.i18n import tr
from app.core.keymap import key_or_title
from app.core.scenes import EditPreview, PreviewTrail
from app.core.tracks.edit_context import EditContext
from app.core.tracks.track_reader import concatenate
from app.core.tracks.two_versions import PointsOf
from tracking.editing import Change
from tracking.errors import EditError
from tracking.tracks import Columns

"""Where the people of some rows stand, (n, 2), on the floor or in a picture."""

AROUND_S = 4.0
"""Trails are shown this long before and after the cut."""


@dataclass(frozen=True, slots=True, eq=False)
class PlannedEdit:
    """An edit as it stands: its words, its change, and the rows around the cut.

    Attributes:
        change: None while it cannot be done yet.
        before, after: rows per track around the cut, before and after the change.
    """

    scene: EditPreview
    change: Change | None = None
    before: tuple[Columns, ...] = ()
    after: tuple[Columns, ...] = ()


def preview_plan(flow: EditFlow, on: EditContext, problem: str = "") -> PlannedEdit:
    """Plan the edit and say what it would do; a plan that does not apply says why.

    `problem` is said instead where the other person was not to be found.
    """
    try:
        change = plan_of(flow, on)
    except EditError as why_not:
        ask = tr(
            "Pick the other person: click on them, type their id, or press {next}. "
            "Then press {apply}.",
            next=key_or_title("tracks.next"),
            apply=key_or_title("tracks.confirm"),
        )
        lines = (problem, ask if flow.needs_other else explain_in_sentence(why_not))
        return PlannedEdit(preview_scene(flow, tuple(filter(None, lines)), None, on))
    return preview_change(flow, on, change, problem)


def preview_change(
    flow: EditFlow, on: EditContext, change: Change, problem: str = ""
) -> PlannedEdit:
    """An edit whose change is known already, shown around its cut."""
    around = round(AROUND_S * on.geometry.fps)
    window = max(0, flow.cut - around), flow.cut + around
    before = _rows_of(on, change, window)
    after = apply_to_rows(before, change, window)
    scene = preview_scene(flow, (problem,) if problem else (), change, on)
    return PlannedEdit(scene, change, _by_track(before), _by_track(after))


def preview_trails(
    planned: PlannedEdit, points_of: PointsOf, colour_of: ColourOf
) -> tuple[PreviewTrail, ...]:
    """The trails before and after in the coordinates that `points_of` gives for rows."""
    return tuple(
        PreviewTrail(points[np.isfinite(points).all(axis=1)], colour, after)
        for after, parts in ((False, planned.before), (True, planned.after))
        for rows in parts
        for points, colour in ((points_of(rows), colour_of(int(rows["track"][0]))),)
    )


def rows_replaced_by(planned: PlannedEdit | None, frame: int) -> Columns | None:
    """The rows of a frame that the edit moves elsewhere or takes out; None where there are none."""
    if planned is None or planned.change is None:
        return None
    rows = within(planned.change.before.rows, (frame, frame + 1))
    return rows if len(rows["frame"]) else None


def _rows_of(on: EditContext, change: Change, window: Range) -> Columns:
    """The rows of everybody the change is about, around it."""
    parts = [on.table.of_track(track, *window) for track in change.tracks]
    return concatenate(parts)


def _by_track(rows: Columns) -> tuple[Columns, ...]:
    parts = (rows["track"] == track for track in np.unique(rows["track"]))
    return tuple({name: column[part] for name, column in rows.items()} for part in parts)
