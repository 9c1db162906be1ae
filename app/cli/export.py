"""`export`: a session's tracks as a file of another tool."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import typer

from app.cli.destination import check_file, check_folder, check_replaced, check_text_replaced
from app.cli.output import (
    STDOUT,
    escape_controls,
    print_json,
    print_line,
    progress,
    refuse_two_documents,
    say,
    text_at,
)
from app.cli.sessions import open_session
from app.core.document.document_loader import known_recordings
from app.features.files.export import capture_export
from app.features.files.own_files import is_own, remember
from tracking.errors import FormatError, OutputError
from tracking.formats import (
    FORMATS,
    TrackFormat,
    losses,
    sample_files,
    write_part_labels,
    write_samples,
)
from tracking.formats.samples_layout import HDF5_FORMAT
from tracking.formats.track_format import Write
from tracking.geometry import View
from tracking.session import RecordingMissing, Session, session_samples
from tracking.trackers import body_part_tracker
from tracking.translation import Message, joined, msg, tr

_PARTS = ("samples", "labels")
"""What is exported of body parts, beside the formats of tracks."""
_TEXT_ENDINGS = (".txt", ".csv", ".xml", ".json")
"""Of formats that are text."""


@dataclass(frozen=True, slots=True)
class ExportRequest:
    """What is to be exported, as typed.

    Attributes:
        session: whose tracks. out: the file to make; `STDOUT`: a text goes there.
        format: its name, or one of body parts. run: a tracker's run; None: the corrected tracks.
        ground_truth: the tracks are written as ground truth wherever the file is.
        force: replace also a text file that export did not write.
    """

    session: Path
    out: Path
    format: str
    run: int | None = None
    ground_truth: bool = False
    force: bool = False


def run_export(request: ExportRequest, *, as_json: bool) -> None:
    """Write the corrected tracks, or those of one run as the tracker left them.

    Of body parts: samples of the failure detector, or the labels themselves.
    """
    if request.ground_truth and not _says_what_counts(request.format):
        raise typer.BadParameter(
            msg("{format} has no such mark", format=request.format), param_hint="--ground-truth"
        )
    refuse_two_documents(request.out, "--out", as_json=as_json)
    if request.format in _PARTS:
        _export_parts(request, as_json=as_json)
        return
    wanted, write = _format_to_write(request.format)
    out, ending = request.out, wanted.extensions[0]
    if out == STDOUT:
        _check_is_text(wanted)
    elif wanted.is_folder:
        check_folder(out.parent)
    else:
        check_file(out)
        check_text_replaced(out)
        check_is_own([out], force=request.force)
    with closing(open_session(request.session)) as session:
        view = _view(session) if wanted.in_camera else None
        tracks = capture_export(session, request.run, view)
    tracks = replace(tracks, ground_truth=request.ground_truth)
    notes = losses(wanted, tracks, out)
    with text_at(out, ending) as place, progress(msg("Writing {name}", name=out.name)) as report:
        made = write(place, tracks, report)
    for note in notes:
        say(msg("note: {note}", note=note))
    facts = {"format": wanted.name, "rows": len(tracks), "notes": list(notes)}
    _tell(out, made, {"written": str(out), "files": list(map(str, made)), **facts}, as_json=as_json)


def _tell(out: Path, made: Sequence[Path], facts: Mapping[str, Any], *, as_json: bool) -> None:
    """Where the files are that were made, which are known again from now on."""
    if out == STDOUT:
        return
    remember(made)
    if as_json:
        print_json(facts)
        return
    for file in made:
        print_line(file)


def _check_is_text(wanted: TrackFormat) -> None:
    """Raises BadParameter where the format is none that stdout can take."""
    if wanted.is_folder or wanted.extensions[0] not in _TEXT_ENDINGS:
        reason = msg("{title} is not one text and needs a place; name one", title=wanted.title)
        raise typer.BadParameter(reason, param_hint="--out")


def check_is_own(places: Sequence[Path], *, force: bool) -> None:
    """Ask before files are lost that export did not write.

    Raises OutputError: somebody said no, or nobody can be asked.
    """
    for place in places:
        if force or not place.exists() or is_own(place):
            continue
        why = msg(
            "{place} is there, and export did not write it or it was changed since", place=place
        )
        if not sys.stdin.isatty():
            raise OutputError(why, "choose another name with -o, or add --force")
        if not typer.confirm(escape_controls(msg("{why}. Replace it?", why=why)), err=True):
            raise OutputError("{place} stays as it is", "choose another name with -o", place=place)


def _says_what_counts(name: str) -> bool:
    """Whether ground truth in that format is written otherwise than a result."""
    return name not in _PARTS and (name not in FORMATS or FORMATS[name].confidence_in_results)


def _format_to_write(name: str) -> tuple[TrackFormat, Write]:
    """The format of that name. Raises BadParameter, which lists what can be written."""
    written = {each.name: each.write for each in FORMATS.values() if each.write is not None}
    if name in written:
        return FORMATS[name], written[name]
    known = name in FORMATS
    reason = tr(
        "{title} is only read; choose one of: {names}"
        if known
        else "format {name!r} is unknown; choose one of: {names}",
        title=FORMATS[name].title if known else "",
        name=name,
        names=joined(", ", (*written, *_PARTS)),
    )
    raise typer.BadParameter(reason, param_hint="--format")


def _view(session: Session) -> View | None:
    """The session's camera over its floor; None where nobody knows it."""
    try:
        with session.open_recording(known=known_recordings()) as recording:
            return recording.view
    except RecordingMissing:
        return None


def _what_first(session: Session) -> Message:
    """What to do before there are samples."""
    run = session.corrected_run
    if run is None or not len(run.parts["frame"]):
        return msg(
            "its tracks have no body parts: track it with {tracker}, then label them",
            tracker=body_part_tracker(),
        )
    return msg("label tracked body parts first")


def _export_parts(request: ExportRequest, *, as_json: bool) -> None:
    name, out = request.format, request.out
    if request.run is not None:
        reason = msg("{name} belong to the corrected tracks; leave it out", name=name)
        raise typer.BadParameter(reason, param_hint="--run")
    if out != STDOUT:
        _check_parts_place(name, out, force=request.force)
    with closing(open_session(request.session)) as session, text_at(out) as place:
        written = _write_labels if name == "labels" else _write_samples
        made, rows = written(session, request.session, place)
    facts = {"written": [str(file) for file in made], "format": name, "rows": rows}
    _tell(out, made, facts, as_json=as_json)


def _check_parts_place(name: str, out: Path, *, force: bool) -> None:
    """Refuse a place where nothing of body parts can be written, or something would be lost."""
    check_file(out)
    if name == "labels":
        check_text_replaced(out)
        check_is_own([out], force=force)
        return
    try:
        places = sample_files(out)
    except FormatError as error:
        raise typer.BadParameter(tr(error.message), param_hint="--out") from error
    check_replaced(out, HDF5_FORMAT)
    check_is_own(places, force=force)


def _write_labels(session: Session, path: Path, place: Path) -> tuple[list[Path], int]:
    """The files that were made, and how many labels are in them; path: of the session."""
    labels = list(session.labels.parts.values())
    if not labels:
        raise OutputError("{path} has no labels of body parts; label some first", path=path)
    write_part_labels(place, labels)
    return [place], len(labels)


def _write_samples(session: Session, path: Path, place: Path) -> tuple[list[Path], int]:
    """The same of samples."""
    samples = session_samples(session)
    if not len(samples):
        raise OutputError(
            "{path} has no samples; {what_first}", path=path, what_first=_what_first(session)
        )
    return write_samples(place, samples), len(samples)
