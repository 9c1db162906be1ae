"""`export`: a session's tracks as a file of another tool."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.destination import check_file
from app.cli.output import print_json
from app.cli.tracks import is_session
from tracking.errors import OutputError, SessionError
from tracking.formats import as_truth, format_named
from tracking.session import Session
from tracking.tracks import Columns


def run_export(path: Path, out: Path, name: str, run: int | None, *, as_json: bool) -> None:
    """Write the corrected tracks, or those of one run as the tracker left them."""
    wanted = format_named(name)
    check_file(out)
    if out.exists() and is_session(out):
        raise OutputError(f"{out} is a session and would be lost; choose another name with -o")
    columns = _tracks(path, run)
    wanted.write(out, columns)
    if as_json:
        print_json({"written": str(out), "format": wanted.name, "rows": len(columns["frame"])})
    else:
        print(out)


def _tracks(path: Path, run: int | None) -> Columns:
    with closing(Session.open(path)) as session:
        if run is None:
            return as_truth(session.tracks.columns())
        if run >= len(session.runs):
            raise SessionError(f"{path} has {len(session.runs)} runs, counted from 0; no run {run}")
        return session.runs[run].tracks
