"""What is told at counting lines and regions in any frame, by what was counted."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from app.core.i18n import tr
from app.core.scenes.labels import Tool
from app.core.tracks.frame_state import FrameState
from app.features.counting.tallies import Tallies, people_inside
from tracking.counting import density_of
from tracking.tracks import Columns, Region, between


@dataclass(frozen=True, slots=True, eq=False)
class ShapeTexts:
    """Takes hold of what was counted; may be asked on any thread.

    Attributes:
        tallies: of the counts. places: of each line in them; None: it cannot be counted.
        regions: as they are drawn.
        tracks: of the run that is counted; None: those that are shown.
    """

    tallies: Tallies | None
    places: tuple[int | None, ...]
    regions: tuple[Region, ...]
    tracks: Columns | None

    def describe(self, state: FrameState, tool: Tool, number: int) -> str:
        """What stands behind the name of a line or a region in a frame; "": nothing yet."""
        if tool is Tool.LINES:
            return self._passages(number, state.frame)
        if tool is not Tool.REGIONS or number >= len(self.regions):
            return ""
        return inside_text(self.regions[number], rows_at(state, self.tracks))

    def _passages(self, number: int, frame: int) -> str:
        place = self.places[number] if number < len(self.places) else None
        if place is None or self.tallies is None:
            return ""
        ahead, back = self.tallies.so_far(place, frame)
        return tr("{ahead} forward, {back} backward", ahead=ahead, back=back)


def inside_text(region: Region, rows: Columns) -> str:
    """How many of a frame's rows are in a region."""
    people = people_inside(region, rows)
    density = float(density_of(region, np.array([people]))[0])
    inside = tr("{people} inside", people=people)
    return f"{inside}, {density:.2f}/m²" if math.isfinite(density) else inside


def rows_at(state: FrameState, tracks: Columns | None) -> Columns:
    """The rows of the frame of those who are counted: of a run, or as they are shown."""
    if tracks is None:
        return state.tracks.of_frame(state.frame)
    rows = between(tracks["frame"], state.frame, state.frame + 1)
    return {name: column[rows] for name, column in tracks.items()}
