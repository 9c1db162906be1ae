"""What edits are planned on."""

from __future__ import annotations

from dataclasses import dataclass

from app.presenters.correcting.footing import Footing
from tracking.tracks import Columns, Labels, TrackTable


@dataclass(frozen=True, slots=True)
class Ground:
    """What edits are planned on.

    Attributes:
        table, labels: of the session, or empty ones where there is none yet.
        footing: of the recording. signals: what the run noticed of its rows; None: nothing.
    """

    table: TrackTable
    labels: Labels
    footing: Footing
    signals: Columns | None = None
