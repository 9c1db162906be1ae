"""What is told to screen readers of the timeline, the overview and the lanes of errors."""

from __future__ import annotations

from app.core.i18n import count_text, joined_text, tr
from app.core.plots.axis import TimeAxis
from app.core.scenes import TimelineScene
from app.core.scenes.ground_truth import ErrorLanes
from app.core.widgets.spoken_description import told_lines


def told_timeline(scene: TimelineScene | None, axis: TimeAxis) -> str:
    """The frame, how many tracks there are, what is in view, who is selected."""
    if scene is None:
        return ""
    last = min(int(axis.start + axis.frames), scene.frame_count) - 1
    shown = tr("Frames {first} to {last} in view", first=int(axis.start), last=max(last, 0))
    selected = [lane.label for lane in scene.lanes if lane.selected]
    names = tr("Selected: {names}", names=joined_text(", ", selected)) if selected else ""
    tracks = count_text(len(scene.lanes), "{n} track", "{n} tracks")
    return told_lines(_frame(scene), tracks, shown, names, _cut(scene), scene.message)


def told_overview(scene: TimelineScene | None) -> str:
    """The frame, how many people are in it, what was tracked, where to look."""
    if scene is None:
        return ""
    frame = scene.frame
    here = int(scene.activity[frame]) if 0 <= frame < len(scene.activity) else 0
    first, end = scene.tracked
    tracked = tr("Tracked: frames {first} to {last}", first=first, last=end - 1)
    return told_lines(
        _frame(scene),
        count_text(here, "{n} person", "{n} people"),
        tracked if end > first else "",
        count_text(len(scene.review_items), "{n} review item", "{n} review items"),
        _reviewed(scene),
    )


def told_errors(scene: ErrorLanes | None) -> str:
    """How many errors there are of each kind."""
    if scene is None:
        return ""
    lanes = [
        tr(
            "{name}: {count} in {places} places",
            name=one.name,
            count=one.count,
            places=len(one.events),
        )
        for one in scene.lanes
    ]
    return told_lines(*lanes, scene.message)


def _frame(scene: TimelineScene) -> str:
    return tr("Frame {frame} of {count}", frame=scene.frame, count=scene.frame_count)


def _cut(scene: TimelineScene) -> str:
    return (
        tr("An edit is previewed at frame {frame}", frame=scene.cut)
        if scene.cut is not None
        else ""
    )


def _reviewed(scene: TimelineScene) -> str:
    if not scene.reviewed:
        return ""
    ranges = [f"{first}\N{EN DASH}{end - 1}" for first, end in scene.reviewed[:20]]
    return tr("Reviewed: {ranges}", ranges=joined_text(", ", ranges))
