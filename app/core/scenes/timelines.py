"""What the timeline and the line of the transport draw."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum, IntEnum

import numpy as np
from numpy.typing import NDArray

from app.core.scenes.frame_scenes import Colour
from app.core.scenes.part_curve import LaneScore


class SpanKind(IntEnum):
    """What the rows of a stretch of a lane are."""

    MEASURED = 0
    PREDICTED = 1
    INTERPOLATED = 2


class MarkKind(Enum):
    """What a mark on the timeline stands for."""

    EDIT = "edit"
    SWAP = "swap"
    REVIEW_ITEM = "review_item"


@dataclass(frozen=True, slots=True)
class TimelineMark:
    """Something at a frame of a track.

    Attributes:
        track: id; 0 where it is about no track in particular.
        text: said when the mouse rests on it.
    """

    kind: MarkKind
    frame: int
    track: int
    text: str = ""


@dataclass(frozen=True, slots=True)
class Lane:
    """A track on the timeline.

    Attributes:
        spans: (k, 3) int64 rows of first frame, end frame (half-open), `SpanKind`; ascending.
        marks: by frame. keyframes: (n,) int64 frames whose row a person made, ascending.
        reviewed: half-open ranges of frames a person has looked at in this track alone.
        score: how a part of the person went, drawn above the bar.
    """

    track: int
    label: str
    colour: Colour
    selected: bool
    spans: NDArray[np.int64]
    marks: tuple[TimelineMark, ...] = ()
    keyframes: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    reviewed: tuple[tuple[int, int], ...] = ()
    score: LaneScore | None = None


@dataclass(frozen=True, slots=True)
class TimelineScene:
    """Lanes, playhead and the overview of the whole recording.

    Attributes:
        frame_count, fps: of the recording. frame: the playhead.
        lanes: a track each, by first frame.
        activity: (frame_count,) people per frame, uint16.
        tracked: half-open frame range. loaded: the half-open ranges of frames at hand.
        cut: a frame with an edit being previewed, or None.
        marked: the half-open range of frames the user has set, or that an edit goes over.
        message: said where there are no lanes.
        review_items: those of all lanes, in any order; the very same tuple while they are the same.
        reviewed: half-open ranges looked at for all tracks.
    """

    frame_count: int
    fps: float
    frame: int
    lanes: tuple[Lane, ...]
    activity: NDArray[np.uint16]
    tracked: tuple[int, int] = (0, 0)
    loaded: tuple[tuple[int, int], ...] = ()
    cut: int | None = None
    marked: tuple[int, int] | None = None
    message: str = ""
    review_items: tuple[TimelineMark, ...] = ()
    reviewed: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class TransportScene:
    """The line between the views and the timeline."""

    playing: bool
    speed: float
    frame: int
    frame_count: int
    time_s: float
    tracker: str
    status: str  # e.g. "live 43 fps", "tracked", "no tracker"
    live: bool = False  # a tracker is at work and has found something
    loops: bool = False  # a stretch is played again and again
    following: bool | None = None  # whether the playhead goes with the tracker; None: none works
