"""What is worth labelling: the parts of a session of which the detector is least sure."""

from __future__ import annotations

from app.core.colours.palette import NOBODY
from app.core.document.detector_choice import DetectorChoice
from app.core.i18n import time_text
from app.core.scenes.labels import SuggestedPart
from app.core.scenes.part_names import no_parts, part_name
from tracking.errors import EditError
from tracking.failure import Suggestion, suggest
from tracking.session.provenance import parts_by_now
from tracking.tracks import Labels, Run, TrackTable


def suggestions_for(
    table: TrackTable,
    run: Run | None,
    labels: Labels,
    fps: float,
    choice: DetectorChoice,
) -> tuple[SuggestedPart, ...]:
    """The parts nearest to the detector's operating point, the nearest first, in no colour yet.

    On any thread: it reads nothing that may change meanwhile.
    Raises EditError where no parts were tracked, FormatError where the detector is gone.
    """
    if run is None or not len(run.parts["frame"]):
        raise EditError(no_parts())
    parts = parts_by_now(table, run, table.track_ids)
    found = suggest(parts, fps, choice.load(), labels.parts)
    return tuple(_suggested(one, labels, fps, choice.name_in_text) for one in found)


def _suggested(one: Suggestion, labels: Labels, fps: float, scored_by: str) -> SuggestedPart:
    return SuggestedPart(
        key=one.key,
        reason=f"unsure: score {one.score:+z.2f} of {scored_by}",
        title=part_name(one.part),
        label=labels.title(one.track),
        colour=NOBODY,
        when=time_text(one.frame / fps),
    )
