"""Whose tracks there are to choose from: those in view, and each run."""

from __future__ import annotations

from collections.abc import Callable

from app.core.document.document import Document
from app.core.i18n import tr
from app.core.tracks.live_tracks import ContinuedTracks, LiveTracks
from tracking.tracks import Columns, TrackTable


def name_of_run(number: int, tracker: str) -> str:
    """What a run is called."""
    return tr("Run {number}: {tracker}", number=number, tracker=tracker)


def list_track_sources(document: Document) -> tuple[str, ...]:
    """What is in view first, then the runs by their numbers."""
    session = document.session
    runs = session.runs if session is not None else ()
    shown = tr("People shown") if document.is_live else tr("Corrected tracks")
    return (shown, *(name_of_run(number, run.tracker) for number, run in enumerate(runs)))


SHOWN = -1
"""Whose: the tracks that are shown, corrected or of a tracker at work; else a run's number."""

_COLUMNS = ("frame", "track", "left", "top", "width", "height", "x", "y")

Version = tuple[object, ...]

Load = Callable[[], Columns]
"""Gives the rows of a moment; may be called on any thread."""


def version_of(document: Document, track_source: int) -> Version:
    """What changes when the tracks do; while a tracker is at work once for each second of it."""
    if track_source != SHOWN:
        return ("run", track_source)
    tracks = document.tracks
    if isinstance(tracks, LiveTracks | ContinuedTracks):
        seconds = int((tracks.frames[1] - tracks.frames[0]) / document.recording.fps)
        return ("live", id(tracks), seconds)
    session = document.session
    table = session.tracks if session is not None else TrackTable()
    return ("corrected", id(table), table.revision)


def capture_rows(document: Document, track_source: int) -> Load:
    """Takes hold of the rows as they are now: quick; reading them may take longer."""
    session = document.session
    if track_source != SHOWN and session is not None:
        run = session.runs[track_source]
        return lambda: run.tracks
    return document.tracks.capture(_COLUMNS)
