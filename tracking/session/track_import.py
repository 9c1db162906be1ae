"""Tracks made elsewhere as they fit a recording: what can be taken of them, and what cannot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tracking.editing import ThinningResult, on_the_floor, thin_dense
from tracking.editing.labels.track_labels import LONGEST_NOTES
from tracking.formats import BadRow, Filmed, Imported
from tracking.formats.label_text import is_person
from tracking.formats.read_result import MOST_TOLD, SeenAs, in_order
from tracking.formats.row_rules import BOX
from tracking.progress import Progress, no_progress
from tracking.recording.fingerprint import Fingerprint, fingerprint
from tracking.session.import_notes import differing_footage, note_on_outside
from tracking.session.import_schema import fit_labels
from tracking.session.imported_ids import id_of_zero, new_ids
from tracking.tracks import (
    LONGEST_KEY,
    LONGEST_NAME,
    LONGEST_VALUE,
    Columns,
    Schema,
    TrackLabel,
    TrackTable,
)
from tracking.translation import Message, msg

if TYPE_CHECKING:
    from tracking.geometry import View
    from tracking.recording import Recording

IMPORTED = "imported"
"""What the run of imported tracks says its tracker is."""

_SHARES = ("confidence", "visibility")


@dataclass(frozen=True, slots=True)
class ImportWish:
    """How tracks are to be taken.

    Attributes:
        thin_px: thin tracks of which every row is a keyframe, within this tolerance; None: not.
        as_new: give all of them new ids; else they keep those of the file.
        only_people: leave out tracks the file says are something else.
    """

    thin_px: float | None = None
    as_new: bool = False
    only_people: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Importable:
    """Tracks of a file, ready to be taken.

    Attributes:
        rows: `CORRECTED_COLUMNS`, by frame then track. labels: what is said of their tracks.
        bad_rows, bad_count: as in `Imported`, with rows beyond the recording among them.
        thinned: how far they were thinned. notes: what the user should know, a line each.
        view: the recording's left camera over its floor; None also where boxes do not reach to the
            feet, so that no place follows from them.
        seen_as: as in `Imported`.
        schema: which attributes people have, the file's or what the session has; empty: neither.
    """

    rows: Columns
    labels: Mapping[int, TrackLabel] = field(default_factory=dict)
    bad_rows: tuple[BadRow, ...] = ()
    bad_count: int = 0
    thinned: ThinningResult = field(default_factory=ThinningResult)
    notes: tuple[Message, ...] = ()
    view: View | None = None
    seen_as: SeenAs | None = None
    schema: Schema = ()

    @property
    def tracks(self) -> int:
        """How many tracks there are."""
        return len(np.unique(self.rows["track"]))


@dataclass(frozen=True, slots=True)
class ImportOrigin:
    """Where tracks come from: the format, and the file by name, size and hash of its ends."""

    format: str
    file: Fingerprint

    @classmethod
    def of(cls, path: Path, format_name: str) -> ImportOrigin:
        """Of a file, or of the plain files of a folder. Raises RecordingError where it has gone."""
        files = [path]
        if path.is_dir():
            held = (each for each in path.iterdir() if each.is_file() and not each.is_symlink())
            files = sorted(held) or files
        return cls(format_name, fingerprint(path.name, files))

    def as_json(self) -> dict[str, str | int]:
        """As the run of the tracks keeps it."""
        return {
            "format": self.format,
            "file": self.file.source,
            "size_bytes": self.file.size_bytes,
            "sha256": self.file.sha256,
        }


def fit_to_recording(
    imported: Imported,
    filmed: Filmed,
    wish: ImportWish,
    known: TrackTable | None = None,
    report: Progress = no_progress,
    schema: Schema = (),
) -> Importable:
    """The tracks of a file fitted to a recording: what is beyond it is bad, what is odd is noted.

    Args:
        imported: as read. filmed: the recording. wish: how they are taken.
        known: the table they are to go into; None: a new one.
        report: called with rows while they are thinned; raises to cancel.
        schema: which attributes people have, of the session or project; empty: as the file says.

    Raises EditError for a tolerance that is none, FormatError where no ids are left.
    """
    notes = [*imported.notes, *differing_footage(imported, filmed)]
    found = Importable(
        imported.columns,
        imported.labels,
        imported.bad_rows,
        imported.bad_count,
        notes=tuple(notes),
        view=filmed.view if imported.boxes_reach_feet else None,
        seen_as=imported.seen_as,
    )
    found = _with_clean_labels(_within(found, imported, filmed.frames))
    if filmed.size_px is not None:
        found = _with_note_on_outside(found, filmed.size_px)
    if wish.only_people:
        found = _only_people(found)
    found = _with_shares(found)
    if filmed.view is not None and np.isnan(found.rows["x"]).all():
        found = _with_places(found, imported, filmed.view, is_new=known is None)
    found = _with_ids(found, imported.track_of_zero, wish, known)
    found = _with_schema(found, imported.schema, schema)
    if wish.thin_px is not None:
        view, fps = found.view, filmed.fps
        rows, thinned = thin_dense(found.rows, wish.thin_px, view=view, fps=fps, report=report)
        found = replace(found, rows=rows, thinned=thinned)
    return found


def describe_footage(recording: Recording) -> Filmed:
    """What is known of a recording."""
    return Filmed(recording.frame_count, recording.fps, recording.size, recording.view)


def _within(found: Importable, imported: Imported, frames: int | None) -> Importable:
    """What lies in the recording's frames; rows beyond are bad, told as the file counts them.

    found: with all rows of what was imported.
    """
    if frames is None:
        return found
    beyond = found.rows["frame"] >= frames
    told = list(found.bad_rows)
    for row in np.flatnonzero(beyond)[: MOST_TOLD - len(told)].tolist():
        track, first = int(found.rows["track"][row]), imported.first_frame
        frame = int(found.rows["frame"][row]) + first
        place = (
            msg("track {track}, frame {frame}", track=track, frame=frame)
            if imported.place_of is None
            else imported.place_of(row)
        )
        reason = msg(
            "track {track} is in frame {frame}, the recording has only {frames} "
            "frames, counted from {first} in this file",
            track=track,
            frame=frame,
            frames=frames,
            first=first,
        )
        told.append(BadRow(place, reason))
    count = found.bad_count + int(beyond.sum())
    return _with_rows(replace(found, bad_rows=tuple(told), bad_count=count), ~beyond)


def _with_note_on_outside(found: Importable, size_px: tuple[int, int]) -> Importable:
    note = note_on_outside(found.rows, size_px)
    return replace(found, notes=(*found.notes, note)) if note else found


def _with_places(found: Importable, imported: Imported, view: View, *, is_new: bool) -> Importable:
    """With places on the floor where the boxes tell them, and a note of what tells them.

    Args:
        found: without any place; its ids are those of what was imported.
        is_new: the tracks go into no table that knows some of them with their places.
    """
    if imported.boxes_reach_feet and not is_new:
        return found  # a place that is known is followed from where it was, see `plan_import`
    if imported.boxes_reach_feet:
        rows: Columns = on_the_floor(found.rows, view)
        note = msg("places on the floor are told from the boxes' feet: the file has none")
    else:
        rows = _below_heads(found.rows, imported.head_heights_m, view)
        note = msg("places on the floor are told from heads at the heights that the file has")
    placed, total = int(np.isfinite(rows["x"]).sum()), len(rows["x"])
    if not placed:
        note = msg(
            "there are no places on the floor: the file has none, nor boxes that reach the feet"
        )
    elif placed < total:
        note += msg("; {lost} of {total} rows have no place", lost=total - placed, total=total)
    return replace(found, rows=rows, notes=(*found.notes, note) if total else found.notes)


def _below_heads(rows: Columns, heights_m: Mapping[int, float], view: View) -> Columns:
    """Rows with places below the middles of their boxes, which are heads at those heights."""
    tracks, place = np.unique(rows["track"], return_inverse=True)
    height_m = np.array([heights_m.get(track, np.nan) for track in tracks.tolist()])[place]
    left, top, width, height = (np.asarray(rows[name], np.float64) for name in BOX)
    heads = np.stack([left + width / 2, top + height / 2], axis=1)
    x, y = view.floor_from_pixel(heads, height_m).T
    return {**rows, "x": x.astype(rows["x"].dtype), "y": y.astype(rows["y"].dtype)}


def _only_people(found: Importable) -> Importable:
    """Without the tracks that are of another class."""
    others = [track for track, label in found.labels.items() if not is_person(label)]
    if not others:
        return found
    notes = (*found.notes, msg("{count} tracks that are no people are left out", count=len(others)))
    return _with_rows(replace(found, notes=notes), ~np.isin(found.rows["track"], others))


def _with_schema(found: Importable, said: Schema, own: Schema) -> Importable:
    """With labels as the schema stores them, and notes of what does not suit it."""
    tracks = [int(track) for track in np.unique(found.rows["track"])] if said or own else []
    labels, notes = fit_labels(found.labels, tracks, said, own)
    return replace(found, labels=labels, notes=(*found.notes, *notes), schema=own or said)


def _with_rows(found: Importable, chosen: NDArray[np.bool_]) -> Importable:
    """Some of the rows, and the labels of the tracks that are left."""
    rows = {name: column[chosen] for name, column in found.rows.items()}
    there = set(np.unique(rows["track"]).tolist())
    labels = {track: label for track, label in found.labels.items() if track in there}
    return replace(found, rows=rows, labels=labels)


def _with_shares(found: Importable) -> Importable:
    """Confidences and visibilities cut to 0 to 1, which is noted."""
    rows, notes = dict(found.rows), list(found.notes)
    for name in _SHARES:
        beyond = int(np.count_nonzero((rows[name] < 0) | (rows[name] > 1)))
        if beyond:
            rows[name] = np.clip(rows[name], 0, 1)
            notes.append(
                msg(
                    "{name} is beyond 0 to 1 in {beyond} rows and cut to that",
                    name=name,
                    beyond=beyond,
                )
            )
    return replace(found, rows=rows, notes=tuple(notes))


def _with_clean_labels(found: Importable) -> Importable:
    """Labels a file can hold: no half characters, no zeros, no more than people may write."""
    labels = {
        track: TrackLabel(
            " ".join(_clean(label.name, LONGEST_NAME).split()),
            {
                _clean(key, LONGEST_KEY): _clean(value, LONGEST_VALUE)
                for key, value in sorted(label.attributes.items())
            },
            _clean(label.notes, LONGEST_NOTES),
        )
        for track, label in found.labels.items()
    }
    return replace(found, labels=labels)


def _clean(text: str, longest: int) -> str:
    return text.replace("\0", " ").encode("utf-8", "replace").decode("utf-8")[:longest]


def _with_ids(
    found: Importable, of_zero: int, wish: ImportWish, known: TrackTable | None
) -> Importable:
    """With the ids the tracks get; tells that of the file's track 0, where there is one.

    Args:
        of_zero: what the reader made of track 0; 0: there is none.
    """
    new: dict[int, int] = {}
    if wish.as_new:
        new = new_ids(found.rows, known)
    elif of_zero and known is not None:
        new = {of_zero: id_of_zero(found.rows, of_zero, known)}
    renamed = _renamed(found, new)
    if not (found.rows["track"] == of_zero).any():
        return renamed
    note = msg(
        "track 0 of the file is track {track} here: ids are positive",
        track=new.get(of_zero, of_zero),
    )
    return replace(renamed, notes=(*renamed.notes, note))


def _renamed(found: Importable, new: Mapping[int, int]) -> Importable:
    """With new ids of some tracks, which no other track has."""
    if all(track == became for track, became in new.items()):
        return found
    old, place = np.unique(found.rows["track"], return_inverse=True)
    ids = np.array([new.get(track, track) for track in old.tolist()], np.int32)
    rows = in_order({**found.rows, "track": ids[place]})
    labels = {new.get(track, track): label for track, label in found.labels.items()}
    return replace(found, rows=rows, labels=labels)
