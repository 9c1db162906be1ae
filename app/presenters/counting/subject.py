"""What is counted: whose tracks, over which lines and in which regions, and in which way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.presenters.document.document import Document
from app.presenters.document.live_tracks import ContinuedTracks, LiveTracks
from tracking.counting import CountingLine, Counts, FlowMap, How, Region, count, flow_map
from tracking.tracks import Columns, TrackTable

SHOWN = -1
"""Whose: the tracks that are shown, corrected or of a tracker at work; else a run's number."""
_COLUMNS = ("frame", "track", "left", "top", "width", "height", "x", "y")

Version = tuple[object, ...]
Bounds = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Subject:
    """What is asked for. Two that are equal are counted alike.

    Attributes:
        whose: `SHOWN` or a run's number. version: tells these tracks from others.
        lines, regions: in the order of the labels. how: see `How`.
        mapped: the flow map is asked for, too.
    """

    whose: int
    version: Version
    lines: tuple[CountingLine, ...]
    regions: tuple[Region, ...]
    how: How
    mapped: bool = False

    @property
    def is_empty(self) -> bool:
        """Whether nothing is to be worked out."""
        return not (self.lines or self.regions or self.mapped)


@dataclass(frozen=True, slots=True, eq=False)
class Counted:
    """What came of a subject.

    Attributes:
        subject: it. counts: over its lines and in its regions.
        flow: the flow map; None where it was not asked for.
    """

    subject: Subject
    counts: Counts
    flow: FlowMap | None = None


Load = Callable[[], Columns]
"""Gives the rows of a moment; may be called on any thread."""


def version_of(document: Document, whose: int) -> Version:
    """What changes when the tracks do; while a tracker is at work once for each second of it."""
    if whose != SHOWN:
        return ("run", whose)
    tracks = document.tracks
    if isinstance(tracks, LiveTracks | ContinuedTracks):
        seconds = int((tracks.frames[1] - tracks.frames[0]) / document.recording.fps)
        return ("live", id(tracks), seconds)
    session = document.session
    table = session.tracks if session is not None else TrackTable()
    return ("corrected", id(table), table.revision)


def loader(document: Document, whose: int) -> Load:
    """Takes hold of the rows as they are now: quick; reading them may take longer."""
    session = document.session
    if whose != SHOWN and session is not None:
        run = session.runs[whose]
        return lambda: run.tracks
    return document.tracks.held(_COLUMNS)


@dataclass(frozen=True, slots=True)
class Length:
    """How long people were tracked.

    Attributes:
        fps, frame_count: of the recording. frames: the half-open range that the tracks go over.
    """

    fps: float
    frame_count: int
    frames: tuple[int, int]


def worked_out(subject: Subject, load: Load, length: Length, bounds: Bounds) -> Counted:
    """Count. Raises CountingError for what cannot be counted.

    Args:
        bounds: left, bottom, right and top of the floor that is worth mapping, m.
    """
    columns, fps = load(), length.fps
    counts = count(columns, fps, length.frame_count, subject.lines, subject.regions, subject.how)
    flow = flow_map(columns, fps, length.frames, bounds=bounds) if subject.mapped else None
    return Counted(subject, counts, flow)
