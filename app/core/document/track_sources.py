"""Whose tracks there are to choose from: those in view, and each run."""

from __future__ import annotations

from app.core.document.document import Document
from app.core.i18n import tr


def name_of_run(number: int, tracker: str) -> str:
    """What a run is called."""
    return tr("Run {number}: {tracker}", number=number, tracker=tracker)


def list_track_sources(document: Document) -> tuple[str, ...]:
    """What is in view first, then the runs by their numbers."""
    session = document.session
    runs = session.runs if session is not None else ()
    shown = tr("People shown") if document.is_live else tr("Corrected tracks")
    return (shown, *(name_of_run(number, run.tracker) for number, run in enumerate(runs)))
