"""Tracks made elsewhere on their way into the open session: read, looked over, taken."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from app.core.editing.edit_planner import refuse_too_large
from app.core.i18n import count_text, tr
from tracking.editing import StoredChange, plan_import
from tracking.errors import EditError, FormatError
from tracking.formats import Filmed, Imported, TrackFormat, format_of, track_endings
from tracking.progress import Progress
from tracking.session import Importable, ImportOrigin, ImportWish, fit_to_recording
from tracking.tracks import Labels, Schema, TrackTable, row_keys

USUAL_TOLERANCE_PX = 2.0
_OF_SESSIONS = {".h5", ".hdf5"}


@dataclass(frozen=True, slots=True, eq=False)
class ReadFile:
    """A file of another tool as it was read.

    Attributes:
        path: of it. format: it was read as. imported: what it says. filmed: the recording.
        origin: the file by its fingerprint.
    """

    path: Path
    format: TrackFormat
    imported: Imported
    filmed: Filmed
    origin: ImportOrigin


@dataclass(frozen=True, slots=True)
class ImportChoice:
    """What the user has chosen in the dialog.

    Attributes:
        thins: tracks that are keyframes throughout are thinned. thin_px: within this tolerance.
        as_new: all get new ids. only_people: other classes are left out.
        takes_good: bad rows are left out and the others taken.
    """

    thins: bool = False
    thin_px: float = USUAL_TOLERANCE_PX
    as_new: bool = False
    only_people: bool = False
    takes_good: bool = False

    @property
    def wish(self) -> ImportWish:
        """The same for whatever fits the tracks to the recording."""
        return ImportWish(self.thin_px if self.thins else None, self.as_new, self.only_people)


@dataclass(frozen=True, slots=True)
class ImportScene:
    """The dialog.

    Attributes:
        lines: what would happen, a line each. notes: what is odd about the file.
        bad: (place, reason) of invalid rows. bad_count: how many there are in all.
        classes: the file says of some tracks that they are no people.
        why_not: why it cannot be imported now; "": it can.
    """

    lines: tuple[str, ...]
    notes: tuple[str, ...] = ()
    bad: tuple[tuple[str, str], ...] = ()
    bad_count: int = 0
    classes: bool = False
    why_not: str = ""


def holds_tracks_alone(path: Path) -> bool:
    """Whether a file's name says that it is of tracks, and neither a recording nor a session."""
    return path.suffix.lower() in set(track_endings()) - _OF_SESSIONS


def read_tracks(
    path: Path, filmed: Filmed, known: TrackFormat | None, report: Progress
) -> ReadFile:
    """Read a file, told by its content or as a format somebody named; for a thread of its own.

    Raises:
        FormatError: it cannot be read as a whole, or is of no format known here.
    """
    named = known or format_of(path)
    if named.read is None:
        raise FormatError(
            "{path} is {title}, which is only written; choose another file",
            path=path,
            title=named.title,
        )
    imported = named.read(path, filmed, report)
    return ReadFile(path, named, imported, filmed, ImportOrigin.of(path, named.name))


@dataclass(frozen=True, slots=True, eq=False)
class FittedTracks:
    """The tracks of a file fitted to the recording, as somebody chose.

    Attributes:
        choice: it. found: the tracks. known: how many of them are in the session already.
        written: the edit that takes them; None: it would change nothing. into: the table it is of.
    """

    choice: ImportChoice
    found: Importable
    known: int
    written: StoredChange | None
    into: TrackTable | None = field(default=None, repr=False)


def prepare_fit(
    read: ReadFile,
    choice: ImportChoice,
    table: TrackTable | None,
    labels: Labels,
    schema: Schema = (),
) -> Callable[[Progress], FittedTracks]:
    """What fits tracks to the recording; to be called in any thread.

    It raises EditError for a tolerance that is none, FormatError where no ids are left.

    Args:
        table: the corrected tracks of now, which nobody changes meanwhile; None: no session yet.
        schema: the project's, where the session has none yet.
    """

    def work(report: Progress) -> FittedTracks:
        own = labels.schema or schema
        found = fit_to_recording(read.imported, read.filmed, choice.wish, table, report, own)
        ids = set(np.unique(found.rows["track"]).tolist())
        known = len(ids & set(table.track_ids)) if table is not None else 0
        written = None
        if table is not None:
            written = _planned(read, found, table, labels)
        return FittedTracks(choice, found, known, written, table)

    return work


def _planned(
    read: ReadFile, found: Importable, table: TrackTable, labels: Labels
) -> StoredChange | None:
    """The edit, ready to be kept; None where the file says what the session says."""
    rows, told, source = found.rows, found.labels, read.path.name
    try:
        change = plan_import(
            table,
            labels,
            rows,
            told,
            source,
            view=found.view,
            seen_as=found.seen_as,
            schema=found.schema,
        )
    except EditError:
        return None
    refuse_too_large(change)
    return StoredChange.of(change)


def import_scene(read: ReadFile, fitted: FittedTracks | None, own: int) -> ImportScene:
    """The dialog; fitted: None while it is worked out. own: how many tracks the session has."""
    imported = read.imported
    classes = any("class" in label.attributes for label in imported.labels.values())
    if fitted is None:
        return ImportScene((tr("Looking..."),), classes=classes, why_not=tr("Looking..."))
    found = fitted.found
    return ImportScene(
        lines=_lines(fitted, own),
        notes=tuple(map(tr, found.notes)),
        bad=tuple((tr(row.place), tr(row.reason)) for row in found.bad_rows),
        bad_count=found.bad_count,
        classes=classes,
        why_not=_why_not(fitted),
    )


def with_good(fitted: FittedTracks, takes_good: bool) -> FittedTracks:
    """The same tracks, where somebody says whether they are taken beside bad rows."""
    return replace(fitted, choice=replace(fitted.choice, takes_good=takes_good))


def _lines(fitted: FittedTracks, own: int) -> tuple[str, ...]:
    found, rows = fitted.found, fitted.found.rows["frame"]
    if not len(rows):
        return (tr("The file holds no tracks to import."),)
    people = count_text(found.tracks, "{n} track", "{n} tracks")
    boxes = count_text(len(rows), "{n} row", "{n} rows")
    span = tr("frames {first} to {last}", first=int(rows[0]), last=int(rows[-1]))
    lines = [f"{people}, {boxes}, {span}"]
    if fitted.into is not None:
        lines += _beside_own(fitted, own)
    thinned = found.thinned
    if thinned.tracks:
        lines.append(
            tr(
                "{tracks} of them thinned: {boxes} boxes to {keyframes} keyframes, interpolated "
                "between",
                tracks=thinned.tracks,
                boxes=thinned.boxes,
                keyframes=thinned.keyframes,
            )
        )
    elif fitted.choice.thins:
        lines.append(tr("None of them can be thinned within this tolerance."))
    return tuple(lines)


def _beside_own(fitted: FittedTracks, own: int) -> list[str]:
    """What becomes of the session's own tracks."""
    lines = []
    new = fitted.found.tracks - fitted.known
    if new:
        lines.append(count_text(new, "{n} is added", "{n} are added"))
    if fitted.known:
        lines.append(
            count_text(
                fitted.known,
                "{n} has the id of a track in the session and replaces it",
                "{n} have ids of tracks in the session and replace them",
            )
        )
        gone = _rows_gone(fitted.written)
        if gone:
            lines.append(
                count_text(
                    gone,
                    "{n} row of these tracks is not in the file and is deleted; undo restores it",
                    "{n} rows of these tracks are not in the file and are deleted; undo restores "
                    "them",
                )
            )
    kept = own - fitted.known
    if kept:
        lines.append(
            count_text(
                kept,
                "{n} track of the session is not in the file and stays as it is",
                "{n} tracks of the session are not in the file and stay as they are",
            )
        )
    return lines


def _rows_gone(written: StoredChange | None) -> int:
    """How many rows an edit takes away without another one in their place."""
    if written is None:
        return 0
    change = written.change
    was, will = (
        row_keys(side.rows["frame"], side.rows["track"]) for side in (change.before, change.after)
    )
    return len(np.setdiff1d(was, will, assume_unique=True))


def _why_not(fitted: FittedTracks) -> str:
    if not len(fitted.found.rows["frame"]):
        return tr("there is nothing to import")
    if fitted.found.bad_count and not fitted.choice.takes_good:
        return tr("choose whether to import the other rows, or correct the file")
    if fitted.into is not None and fitted.written is None:
        return tr("the session has these tracks already")
    return ""
