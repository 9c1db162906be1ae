"""A session's tracks as other tools read them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from app.features.files.own_files import is_own
from app.features.files.protected_files import why_protected
from tracking.errors import OutputError, SessionError
from tracking.formats import Exported, begins_as_hdf5
from tracking.geometry import View
from tracking.session import IMPORTED, Session
from tracking.session.session_reader import check_file
from tracking.tracks import Columns, Run, TrackTable


def select_exported(session: Session, run: int | None = None) -> Columns:
    """The rows that are exported: the corrected tracks, or a run's as the tracker left them.

    Raises:
        SessionError: there is no such run.
    """
    if run is None:
        return session.tracks.columns()
    return _run(session, run).tracks


def capture_export(session: Session, run: int | None = None, view: View | None = None) -> Exported:
    """The same rows with what is known of their footage; what is edited later is not in it.

    Of a session that began as imported truth, rows that do not count (confidence 0) stay so.
    view: the left camera over its floor, for formats that tell places as it sees them.

    Raises SessionError as `select_exported`.
    """
    return prepare_export(session, run, view)()


def prepare_export(
    session: Session, run: int | None = None, view: View | None = None
) -> Callable[[], Exported]:
    """Takes hold of the rows at once; what it gives puts them together, on any thread.

    Args:
        view: the left camera over its floor, where it is known.

    Raises SessionError as `select_exported`.
    """
    corrected, footage = run is None, session.recording
    table = session.tracks.snapshot() if run is None else None
    own = None if run is None else _run(session, run)
    labels = dict(session.labels.tracks) if corrected else {}
    schema = session.labels.schema if corrected else ()
    dont_cares = corrected and _began_as_import(session)

    def put_together() -> Exported:
        whole = table if own is None else TrackTable(own.tracks)
        assert whole is not None
        return Exported.of_table(
            whole,
            frames=footage.frame_count,
            fps=footage.fps,
            size_px=footage.size,
            name=footage.name,
            labels=labels,
            schema=schema,
            view=view,
            corrected=corrected,
            dont_cares=dont_cares,
        )

    return put_together


def refuse_to_lose(path: Path) -> None:
    """A session, and what a recording is made of, are not written over by what is exported.

    Raises:
        OutputError: there is one of that name.
    """
    if path.is_file() and (what := why_protected(path)) and not is_own(path):
        raise OutputError(
            "{path} is {what} and would be lost; choose another name", path=path, what=what
        )
    if path.is_file() and begins_as_hdf5(path):
        try:
            check_file(path)
        except SessionError:
            return  # other tools' HDF5, which the user agreed to replace
        raise OutputError("{path} is a session and would be lost; choose another name", path=path)


def _began_as_import(session: Session) -> bool:
    adopted = session.adopted_run
    return adopted is not None and session.runs.tracker_of(adopted) == IMPORTED


def _run(session: Session, number: int) -> Run:
    if number >= len(session.runs):
        raise SessionError(
            "{path} has {count} runs, counted from 0; no run {number}",
            path=session.path,
            count=len(session.runs),
            number=number,
        )
    return session.runs[number]
