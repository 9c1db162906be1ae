"""What is worth labelling: the parts of a session of which the detector is least sure."""

from __future__ import annotations

from app.presenters.labelling.labelling_scene import Suggested
from app.presenters.palette import colour_of_track
from app.presenters.parts.picturing import part_name
from app.presenters.words import time_text, tr
from tracking.errors import EditError
from tracking.failure import Detector, Suggestion, suggest
from tracking.session.belonging import parts_by_now
from tracking.tracks import Labels, Run, TrackTable


def suggestions_for(
    table: TrackTable, run: Run | None, labels: Labels, fps: float, detector: Detector
) -> tuple[Suggested, ...]:
    """The parts nearest to the detector's operating point, the nearest first.

    Raises EditError where no parts were tracked.
    """
    if run is None or not len(run.parts["frame"]):
        raise EditError(tr("No parts were tracked: track with three-part (Ctrl+T) first"))
    parts = parts_by_now(table, run, table.track_ids)
    found = suggest(parts, fps, detector, labels.parts)
    return tuple(_suggested(one, labels, fps) for one in found)


def _suggested(one: Suggestion, labels: Labels, fps: float) -> Suggested:
    return Suggested(
        key=one.key,
        reason=one.reason,
        title=part_name(one.part),
        label=labels.title(one.track),
        colour=colour_of_track(one.track),
        when=time_text(one.frame / fps),
    )
