"""`open`: the window."""

from __future__ import annotations

from pathlib import Path

from app.cli.display import why_no_window
from app.cli.option_groups import Bare
from app.cli.recordings import options_of
from app.core.document.document_loader import open_path
from app.core.interrupts import ending_at_once
from tracking.errors import OutputError, RecordingError, SessionError
from tracking.recording import OpenOptions
from tracking.session import find_backups


def run_open(path: Path | None, bare: Bare, recording: Path | None) -> None:
    """Show the window until it is closed.

    Args:
        path: a recording or session; None: the welcome page, or the cameras `bare` names.
        bare: what the options say of a recording without recording.toml.
        recording: where a session's recording is by now, if it has moved.

    Raises:
        OutputError: no window can be opened here.
        RecordingMissing: the session's recording is not at `recording`.
        RecordingError, SessionError: nothing is at `path`.
    """
    if path is not None and bare.left is None:
        _check_there(path)
    options = options_of(bare)
    if path is not None and recording is not None:
        _note_place(path, recording, options)
    why_not = why_no_window()
    if why_not:
        raise OutputError(
            "{why_not}. Without a window: info, track, demo --no-gui", why_not=why_not
        )
    with ending_at_once():
        from app.shell.application import run

    raise SystemExit(run(path or bare.left, options))


def _check_there(path: Path) -> None:
    """Refuse a path that holds nothing; a session that is gone may have backups to go back to."""
    if path.exists():
        return
    if path.suffix.lower() != ".h5":
        raise RecordingError("{path}: no such recording; check the path", path=path)
    if not find_backups(path):
        raise SessionError("{path}: there is no such session; check the path", path=path)


def _note_place(path: Path, recording: Path, options: OpenOptions) -> None:
    """Remember where a session's recording stands now; the window finds it there."""
    document = open_path(path, recording, options).document
    document.recording.close()
    if document.session is not None:
        document.session.close()
