"""Formats of plug-ins: whatever goes wrong in them names them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from tracking.errors import EditError
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_format import Read, TrackFormat, Write
from tracking.formats.track_writer import Exported
from tracking.plugins import Offer, blaming
from tracking.plugins.blame import accused, guarded, guarded_if
from tracking.progress import Progress, no_progress
from tracking.tracks import CORRECTED_COLUMNS, check_tracks, checked_columns


def guard_format(kind: TrackFormat, offer: Offer) -> TrackFormat:
    """The same format, whose mistakes name the plug-in. Raises PluginError for a wrong entry."""
    if not kind.extensions or not all(one.startswith(".") for one in kind.extensions):
        raise accused(offer, "its extensions must begin with a dot, the usual one first")
    return replace(
        kind,
        recognises=guarded(kind.recognises, offer),
        recognises_folder=guarded_if(kind.recognises_folder, offer),
        label_as_read=guarded_if(kind.label_as_read, offer),
        read=None if kind.read is None else _guarded_read(kind.read, offer),
        write=None if kind.write is None else _guarded_write(kind.write, offer),
    )


def _guarded_read(read: Read, offer: Offer) -> Read:
    def guarded(path: Path, filmed: Filmed, /, report: Progress = no_progress) -> Imported:
        with blaming(offer):
            found: Any = read(path, filmed, report)
        if not isinstance(found, Imported):
            raise accused(
                offer, "read gave {found}, and should give Imported", found=type(found).__name__
            )
        try:
            columns = checked_columns(found.columns, CORRECTED_COLUMNS, "tracks")
            check_tracks(columns, "tracks")
        except EditError as error:
            raise accused(offer, "{path}: {error}", path=path, error=error) from error
        return replace(found, columns=columns)

    return guarded


def _guarded_write(write: Write, offer: Offer) -> Write:
    def guarded(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
        with blaming(offer):
            made: Any = write(path, exported, report)
        if (
            not isinstance(made, tuple)
            or not made
            or not all(isinstance(one, Path) for one in made)
        ):
            raise accused(offer, "write must give the files it made, as a tuple of paths")
        return made

    return guarded
