"""What edits are planned on."""

from __future__ import annotations

from dataclasses import dataclass, field

from app.core.colours.track_colours import TrackColours
from app.core.tracks.recording_geometry import RecordingGeometry
from tracking.tracks import Columns, Labels, TrackTable


@dataclass(frozen=True, slots=True)
class EditContext:
    """What edits are planned on.

    Attributes:
        table, labels: of the session, or empty ones where there is none yet.
        geometry: of the recording. signals: what the run noticed of its rows; None: nothing.
        colours: of the tracks.
    """

    table: TrackTable
    labels: Labels
    geometry: RecordingGeometry
    signals: Columns | None = None
    colours: TrackColours = field(default_factory=TrackColours)
