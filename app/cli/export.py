"""`export`: a session's tracks as a file of another tool."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.destination import check_file
from app.cli.output import print_json
from app.cli.tracks import is_session
from app.presenters.files.exporting import exported_tracks
from tracking.errors import OutputError
from tracking.formats import format_named
from tracking.session import Session


def run_export(path: Path, out: Path, name: str, run: int | None, *, as_json: bool) -> None:
    """Write the corrected tracks, or those of one run as the tracker left them."""
    wanted = format_named(name)
    check_file(out)
    if out.exists() and is_session(out):
        raise OutputError(f"{out} is a session and would be lost; choose another name with -o")
    with closing(Session.open(path)) as session:
        columns = exported_tracks(session, run)
    wanted.write(out, columns)
    if as_json:
        print_json({"written": str(out), "format": wanted.name, "rows": len(columns["frame"])})
    else:
        print(out)
