"""What an edit would do, in words and as trails before and after."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.presenters.edit_flow import SCOPES, EditFlow, EditKind, Scope
from app.presenters.palette import colour_of_track
from app.presenters.scenes import EditPreview, PreviewTrail
from app.presenters.words import counted, time_text, tr
from tracking.editing import Change, apply_change
from tracking.errors import EditError
from tracking.tracks import Columns, Labels, TrackTable

PointsOf = Callable[[Columns], NDArray[np.float64]]
"""Where the people of some rows stand, (n, 2), on the floor or in a picture."""

AROUND_S = 4.0
"""Trails are shown this long before and after the cut."""

_TITLES = {
    EditKind.SWAP: "Swap {a} with...",
    EditKind.SPLIT: "Split {a}",
    EditKind.MERGE: "Merge into {a}...",
    EditKind.DELETE: "Delete {a}",
}


@dataclass(frozen=True, slots=True)
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


def planned_edit(
    flow: EditFlow, table: TrackTable, labels: Labels, fps: float, problem: str = ""
) -> PlannedEdit:
    """Plan the edit and say what it would do; a plan that does not apply says why.

    `problem` is said instead where the other person was not to be found.
    """
    try:
        change = flow.plan(table, labels)
    except EditError as why_not:
        ask = tr("Click on the other person, type their id, or press Tab to go through them")
        lines = [problem] if problem else []
        lines.append(ask if flow.needs_other else str(why_not))
        return PlannedEdit(_scene(flow, tuple(lines), None))
    changed = table.snapshot()
    apply_change(changed, labels, change)
    around = round(AROUND_S * fps)
    middle = flow.cut if flow.has_cut else change.frame
    start, end = max(0, middle - around), middle + around
    details = _details(flow, change, table, fps)
    return PlannedEdit(
        _scene(flow, (problem, *details) if problem else details, change),
        change,
        tuple(table.of_track(track, start, end) for track in change.tracks),
        tuple(changed.of_track(track, start, end) for track in change.tracks),
    )


def preview_trails(planned: PlannedEdit, points_of: PointsOf) -> tuple[PreviewTrail, ...]:
    """The trails before and after in the coordinates that `points_of` gives for rows."""
    return tuple(
        PreviewTrail(points[np.isfinite(points).all(axis=1)], colour, after)
        for after, parts in ((False, planned.before), (True, planned.after))
        for rows in parts
        if len(rows["track"])
        for points, colour in ((points_of(rows), colour_of_track(int(rows["track"][0]))),)
    )


def _scene(flow: EditFlow, details: tuple[str, ...], change: Change | None) -> EditPreview:
    title = tr(_TITLES[flow.kind], a=flow.track) if change is None else change.text
    title_of_choice, choices = _choices(flow, change)
    return EditPreview(
        title=title,
        details=details,
        frame=flow.cut,
        choice_title=title_of_choice,
        choices=choices,
        choice=flow.choice,
        other=flow.other if flow.takes_other else None,
        has_cut=flow.has_cut,
        ready=change is not None,
        hint=_hint(flow, change is not None, len(choices)),
    )


def _choices(flow: EditFlow, change: Change | None) -> tuple[str, tuple[str, ...]]:
    """What can be chosen, and between what; nothing where it makes no difference."""
    if flow.kind is not EditKind.MERGE:
        return tr("How far"), tuple(tr(scope.value) for scope in SCOPES[flow.kind])
    if change is None or not len(change.before.rows["track"]):
        return "", ()
    keeps = tuple(tr("keep {track}", track=track) for track in (flow.track, flow.other))
    return tr("Where both stand"), keeps


def _hint(flow: EditFlow, ready: bool, choices: int) -> str:
    if not ready:
        return tr("Esc leaves everything as it is")
    keys = [tr("Left / Right move the frame")] if flow.has_cut else []
    if flow.scope is Scope.RANGE:
        keys.append(tr("Ctrl+Left / Right move the end"))
    if choices > 1:
        keys.append(tr("R changes whom to keep") if not flow.has_cut else tr("R changes how far"))
    return ", ".join(keys)


def _details(flow: EditFlow, change: Change, table: TrackTable, fps: float) -> tuple[str, ...]:
    when = time_text(flow.cut / fps)
    lines = []
    if flow.proposed:
        lines.append(tr("Frame {n} ({when}): where the two came closest", n=flow.cut, when=when))
    elif flow.has_cut:
        lines.append(tr("Frame {n} ({when})", n=flow.cut, when=when))
    if flow.kind is EditKind.SPLIT:
        lines.append(tr("{a} keeps its id before the cut", a=flow.track))
    counts = rows_changed(change, table)
    what = ", ".join(
        counted(n, "{n} frame of {track}", "{n} frames of {track}", track=track)
        for track, n in counts.items()
    )
    if what:
        lines.append(tr("Changes {what}", what=what))
    return tuple(lines)


def rows_changed(change: Change, table: TrackTable) -> dict[int, int]:
    """How many rows of each track the change moves or takes out."""
    counts: dict[int, int] = {}
    for track, start, end in change.before.stretches.tolist():
        frames = table.frames_of_track(track)
        first, stop = np.searchsorted(frames, (start, end))
        counts[track] = counts.get(track, 0) + int(stop - first)
    for track in change.before.rows["track"].tolist():
        counts[track] = counts.get(track, 0) + 1
    return counts
