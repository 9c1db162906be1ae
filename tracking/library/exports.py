"""Writing tracks for other tools."""

from __future__ import annotations

from pathlib import Path

from tracking.errors import FormatError, OutputError
from tracking.formats import Exported, format_named
from tracking.library.paths import AnyPath, as_path
from tracking.progress import no_progress
from tracking.session import Session
from tracking.tracks import TrackTable


def export(
    session: Session,
    path: AnyPath,
    format: str,  # noqa: A002 - as `export --format`
    *,
    run: int | None = None,
    ground_truth: bool = False,
    replace: bool = False,
) -> tuple[Path, ...]:
    """Write a session's tracks as a file of another tool.

    Args:
        session: whose tracks.
        path: the file to make; it appears whole or not at all.
        format: a name of docs/formats.md, e.g. "mot", "kitti", "cvat", "csv", or of a plug-in.
        run: number of a tracker's run; None: the corrected tracks.
        ground_truth: they are written as ground truth, where the format tells the two apart.
        replace: a file that is there may be replaced.

    Returns:
        The files that were made.

    Raises:
        FormatError: the format is unknown or only read, or the tracks lack what it needs.
        OutputError: the file is there already, or cannot be written.
        SessionError: there is no such run.
    """
    kind, place = format_named(format), as_path(path)
    if kind.write is None:
        raise FormatError("format {name} is only read; choose another", name=kind.name)
    if place.exists() and not replace:
        raise OutputError(
            "{path} is there already; choose another name, or replace=True", path=place
        )
    return kind.write(place, _exported(session, run, ground_truth=ground_truth), no_progress)


def _exported(session: Session, run: int | None, *, ground_truth: bool) -> Exported:
    footage = session.recording
    table = session.tracks.snapshot() if run is None else TrackTable(session.runs[run].tracks)
    return Exported.of_table(
        table,
        frames=footage.frame_count,
        fps=footage.fps,
        size_px=footage.size,
        name=footage.name,
        labels=dict(session.labels.tracks) if run is None else {},
        corrected=run is None,
        ground_truth=ground_truth,
    )
