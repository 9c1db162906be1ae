"""A session's tracks as other tools read them."""

from __future__ import annotations

from tracking.errors import SessionError
from tracking.formats import Exported, as_truth
from tracking.session import Session
from tracking.tracks import Columns, Run, TrackTable


def exported_tracks(session: Session, run: int | None = None) -> Columns:
    """The rows that are exported: the corrected tracks, or a run's as the tracker left them.

    Corrected tracks count as truth, however sure a tracker was of them.

    Raises:
        SessionError: there is no such run.
    """
    if run is None:
        return as_truth(session.tracks.columns())
    return _run(session, run).tracks


def exported(session: Session, run: int | None = None) -> Exported:
    """The same rows with what is known of their footage; what is edited later is not in it.

    Raises SessionError as `exported_tracks`.
    """
    corrected, footage = run is None, session.recording
    table = session.tracks.snapshot() if run is None else TrackTable(_run(session, run).tracks)
    return Exported.of_table(
        table,
        frames=footage.frame_count,
        fps=footage.fps,
        size_px=footage.size,
        name=footage.name,
        labels=dict(session.labels.tracks) if corrected else {},
        counts_in_full=corrected,
    )


def _run(session: Session, number: int) -> Run:
    if number >= len(session.runs):
        raise SessionError(
            f"{session.path} has {len(session.runs)} runs, counted from 0; no run {number}"
        )
    return session.runs[number]
