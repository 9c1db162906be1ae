"""A session's tracks as other tools read them."""

from __future__ import annotations

from tracking.errors import SessionError
from tracking.formats import as_truth
from tracking.session import Session
from tracking.tracks import Columns


def exported_tracks(session: Session, run: int | None = None) -> Columns:
    """The rows that are exported: the corrected tracks, or a run's as the tracker left them.

    Corrected tracks count as truth, however sure a tracker was of them.

    Raises:
        SessionError: there is no such run.
    """
    if run is None:
        return as_truth(session.tracks.columns())
    if run >= len(session.runs):
        raise SessionError(
            f"{session.path} has {len(session.runs)} runs, counted from 0; no run {run}"
        )
    return session.runs[run].tracks
