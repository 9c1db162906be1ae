"""Counts as the views show them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import Colour
from app.core.scenes.okabe_ito import GREEN, PURPLE, SKY_BLUE, VERMILION
from tracking.counting import Counts

FORWARD_COLOUR: Colour = VERMILION
BACKWARD_COLOUR: Colour = SKY_BLUE
PEOPLE_COLOUR: Colour = GREEN
SPEED_COLOUR: Colour = PURPLE

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class TallyRow:
    """A line or a region in the panel, at the frame that is shown.

    Attributes:
        name: its own. is_line: else a region. colour: its outline's.
        cells: forward and backward so far and in all, people inside, people a square metre, m/s;
            "" where it does not apply.
        hint: the same in a sentence.
    """

    name: str
    is_line: bool
    colour: Colour
    cells: tuple[str, ...]
    hint: str


@dataclass(frozen=True, slots=True, eq=False)
class CountCurve:
    """One curve of a plot.

    Attributes:
        label: what it shows. values: (frames,) one a frame of the recording; NaN breaks it.
        dashed: drawn so, that it is told apart without its colour.
    """

    label: str
    values: Floats
    colour: Colour
    dashed: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class CountPlot:
    """One of the plots below each other.

    Attributes:
        name: what is plotted. unit: of its numbers, e.g. "m/s"; "" where they are counts.
        curves: over all frames. high: the least that its upper edge stands for.
    """

    name: str
    unit: str
    curves: tuple[CountCurve, ...]
    high: float


@dataclass(frozen=True, slots=True, eq=False)
class CountingScene:
    """The panel.

    Attributes:
        rows: lines, then regions. picked: the number of the one that is plotted; -1: none.
        tracks: whose tracks can be counted; track_source: the number of those that are.
        step_s, jitter_m, jitter_px: how it is counted. least_step_s: the shortest step there is.
        jitters: which of the two distances matter, on the floor and in the picture.
        plots: of the one that is picked.
        counts: all steps, for the table; None while there are none.
        frame, frame_count, fps: of the frame and the recording.
        doing: said while it counts. message: what to do where there is nothing to count.
    """

    rows: tuple[TallyRow, ...] = ()
    picked: int = -1
    tracks: tuple[str, ...] = ()
    track_source: int = 0
    step_s: float = 0.5
    least_step_s: float = 0.01
    jitter_m: float = 0.0
    jitter_px: float = 0.0
    jitters: tuple[bool, bool] = (True, False)
    plots: tuple[CountPlot, ...] = ()
    counts: Counts | None = None
    frame: int = 0
    frame_count: int = 1
    fps: float = 1.0
    doing: str = ""
    message: str = ""
