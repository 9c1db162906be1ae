"""A session file, checked and read."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py

from tracking.editing import Entry, History, Scope, TouchIndex, footprint_of, up_to_date
from tracking.errors import EditError, SessionError
from tracking.message_data import kept_message
from tracking.recording import Fingerprint
from tracking.session import inspection
from tracking.session.findings import CHECKSUM, Finding, read_findings
from tracking.session.hdf5 import (
    begin_columns,
    open_readonly,
    read_columns,
    read_rows,
    text_attribute,
)
from tracking.session.image import Snapshot, Stamps
from tracking.session.label_tables import read_labels
from tracking.session.layout import VERSION
from tracking.session.notes import note_of_change, note_of_missing_seal, tell_damage
from tracking.session.reference import RecordingReference
from tracking.session.runs import StoredRun
from tracking.session.seal import holds as is_sealed
from tracking.session.seal import is_changed, is_missing
from tracking.session.session_writer import find_backups
from tracking.session.table_reader import PendingColumns
from tracking.stamps import now
from tracking.tracks import LARGEST_NUMBER, TrackTable
from tracking.translation import Message, msg
from tracking.untrusted import verdicts_of

_MOST_FPS, _WIDEST = 1e6, 1 << 20
_ALL_SEALED = (1, 5)
"""From this version of the format on, every save ends the file with a checksum."""


def read_session(path: Path) -> Snapshot:
    """What a session file says; runs stay in it until they are looked at.

    Raises SessionError where it is missing, no session, damaged, hostile or too new.
    """
    version, damage = check_version(path)
    with open_readonly(path) as file:
        snapshot = _READERS[version[0]](file, path)
        findings, known = read_findings(file), report_findings(file, path)
    if damage:
        findings = (*findings, Finding(now(), CHECKSUM))
    return replace(
        snapshot,
        newer=version > VERSION,
        changed=bool(damage),
        damage=(*damage, *known),
        findings=findings,
    )


def report_findings(file: h5py.File, path: Path) -> tuple[Message, ...]:
    """What was found damaged of the session before and nobody has accepted: told once more."""
    open_ones = [one for one in read_findings(file) if not one.accepted]
    return tuple(tell_damage(one.note(path)) for one in open_ones)


def read_save(path: Path) -> tuple[str, str]:
    """Which session a file is, and which of its saves: see `Stamps`. Raises SessionError."""
    check_file(path)
    with open_readonly(path) as file:
        stamps = read_stamps(file)
    return stamps.session, stamps.save


def check_file(path: Path) -> tuple[int, int]:
    """Have the file looked over by a program of its own; gives its format version.

    One that bears this user's seal need not be: its structure is as it was saved. What is damaged
    is told (see `notes`). Raises SessionError with the verdict where it is not safe to read.
    """
    return check_version(path)[0]


def check_version(path: Path) -> tuple[tuple[int, int], tuple[Message, ...]]:
    """The version of a file that is safe to read, and what is damaged of it, which is told."""
    try:
        is_folder, is_there = path.is_dir(), path.is_file()
    except OSError as why:  # its disk fails, or it may not be looked at
        raise SessionError(
            "{path}: the session cannot be looked at: {reason}",
            path=path,
            reason=why.strerror or why,
        ) from why
    if is_folder:
        raise SessionError("{path}: this is a folder; name a session file", path=path)
    if not is_there:
        raise SessionError("{path}: there is no such session; check the path", path=path)
    if is_sealed(path):
        return VERSION, ()
    verdict = inspect_files([path])[0]
    if "refused" in verdict:
        raise SessionError(
            "{path}{why}{way_out}",
            path=path,
            why=verdict["refused"],
            way_out=_way_out(path, unreadable="unreadable" in verdict),
        )
    version = _version(verdict)
    damaged = _damage_of(path, version)
    return version, (tell_damage(damaged),) if damaged else ()


def _version(verdict: Mapping[str, Any]) -> tuple[int, int]:
    major, minor = verdict["version"]
    return int(major), int(minor)


def _damage_of(path: Path, version: tuple[int, int]) -> Message:
    """What is damaged of a file that is safe to read, in a line; "" where nothing is known."""
    if _ALL_SEALED <= version <= VERSION and is_missing(path):  # a later one may seal otherwise
        return note_of_missing_seal(path)
    return note_of_change(path) if is_changed(path) else Message()


def check_files(paths: Sequence[Path]) -> list[tuple[str, str]]:
    """Why each of the files is not safe to read, else what is damaged of it; "" where it is sound.

    One other program looks at all. Nothing is told: these are not the session that is read.
    """
    asked = [path for path in paths if not is_sealed(path)]
    verdicts = dict(zip(asked, inspect_files(asked), strict=True))
    found = []
    for path in paths:
        verdict = verdicts.get(path)
        why = verdict.get("refused") if verdict else ""
        damaged = _damage_of(path, _version(verdict)) if verdict and not why else ""
        found.append((f"{path}{why}" if why else "", damaged))
    return found


def inspect_files(paths: Sequence[Path]) -> list[dict[str, Any]]:
    """What the other program says of each file; one that it does not survive is damaged."""
    return verdicts_of(inspection.__file__, "session", paths)


def _way_out(path: Path, *, unreadable: bool) -> str:
    """What can be done about a file that is refused, for the end of a message."""
    if find_backups(path):
        return msg("; trackwright restore {name} has back what was saved before", name=path.name)
    if unreadable:
        return msg("; no older save is kept: bring a copy of it, or track the recording again")
    return ""


def _read_version_1(file: h5py.File, path: Path) -> Snapshot:
    tracks = file["tracks"]
    try:
        with PendingColumns() as unpacking:
            columns = begin_columns(tracks, unpacking)
            labels, edits = read_labels(file), read_edits(file)
            touches = _read_touched(file["edits"], edits)
            History(edits, touches)
            recording = read_recording(file["recording"])
            unpacking.finish()
        table = TrackTable(columns, highest_track=int(tracks.attrs["highest_track"]))
    except EditError as why:
        raise SessionError(
            "{path}: the session file is damaged: {why}", path=path, why=why
        ) from why
    adopted = int(tracks.attrs["run"])
    if adopted >= len(file["runs"]):
        raise ValueError(f"the tracks began as run {adopted}, which is not there")
    return Snapshot(
        stamps=read_stamps(file),
        recording=recording,
        runs=tuple(StoredRun(path, number) for number in range(len(file["runs"]))),
        tracks=table,
        adopted=None if adopted < 0 else adopted,
        labels=labels,
        edits=edits,
        touched=touches.columns,
        colours=_read_colours(file),
    )


_READERS = {1: _read_version_1}
"""By major version: a file of an older one is brought up to date by its own reader."""


def _read_colours(file: h5py.File) -> dict[int, int]:
    """The colour of each track; none in older files."""
    if "colours" not in file:
        return {}
    return {row["track"]: row["place"] for row in read_rows(file["colours"])}


def read_edits(file: h5py.File) -> tuple[Entry, ...]:
    """The log."""
    return tuple(_read_entry(**row) for row in read_rows(file["edits"]))


def _read_entry(text: str, scope: str = "", message: str = "", **others: Any) -> Entry:
    said = kept_message(text, message)
    return up_to_date(Entry(text=said, scope=Scope.of_text(scope), **others))


def _read_touched(group: h5py.Group, edits: Sequence[Entry]) -> TouchIndex:
    """What the edits touch. Where the file does not say so, or nonsense, it is worked out."""
    if "touched" in group:
        with contextlib.suppress(EditError):
            columns = read_columns(group["touched"])
            return TouchIndex.from_columns(columns, len(edits))
    index = TouchIndex()
    for entry in edits:
        with contextlib.suppress(EditError):  # a damaged line is told when it is asked for
            index.add(entry.id, footprint_of(entry.change))
    return index


def read_recording(group: h5py.Group) -> RecordingReference:
    """The reference to the recording."""
    return RecordingReference(
        name=text_attribute(group, "name"),
        path=text_attribute(group, "path"),
        fps=_within(group, "fps", _MOST_FPS),
        frame_count=int(_within(group, "frame_count", LARGEST_NUMBER)),
        size=(int(_within(group, "width", _WIDEST)), int(_within(group, "height", _WIDEST))),
        is_stereo=bool(group.attrs["stereo"]),
        manifest=str(group["manifest"].asstr(errors="replace")[()]),
        own_manifest=bool(group.attrs.get("own_manifest", True)),
        calibration=str(group["calibration"].asstr(errors="replace")[()]),
        sources=tuple(Fingerprint(**row) for row in read_rows(group["sources"])),
    )


def _within(group: h5py.Group, name: str, most: float) -> float:
    """A number that is used to make arrays and to wait by; ValueError where it can be neither."""
    value = float(group.attrs[name])
    if not 0 <= value <= most:
        raise ValueError(f"the recording's {name} is {value:g}")
    return value


def read_stamps(file: h5py.File) -> Stamps:
    """Which session and which of its saves the file is."""
    names = ("session", "save", "previous_save", "created", "modified", "software")
    said = {name: text_attribute(file, name) for name in names}
    return Stamps(**said, included=int(file.attrs["included_steps"]))
