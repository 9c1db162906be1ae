"""`export`: a session's tracks as a file of another tool."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.destination import check_file, check_replaced, check_text_replaced
from app.cli.output import print_json, progress, say
from app.presenters.files.exporting import exported
from app.presenters.files.opening import known_recordings
from tracking.errors import FormatError, OutputError
from tracking.formats import FORMATS, TrackFormat, write_part_labels, write_samples
from tracking.formats.samples_layout import HDF5_FORMAT
from tracking.formats.track_format import Write
from tracking.geometry import View
from tracking.session import RecordingMissing, Session, session_samples

_PARTS = ("samples", "labels")
"""What is exported of body parts, beside the formats of tracks."""


def run_export(path: Path, out: Path, name: str, run: int | None, *, as_json: bool) -> None:
    """Write the corrected tracks, or those of one run as the tracker left them.

    Of body parts: samples of the failure detector, or the labels themselves.
    """
    if name in _PARTS:
        _export_parts(path, out, name, run, as_json=as_json)
        return
    wanted, write = _format_to_write(name)
    check_file(out)
    check_text_replaced(out)
    with closing(Session.open(path)) as session:
        tracks = exported(session, run, _view(session) if wanted.in_camera else None)
    with progress(f"Writing {out.name}") as report:
        made = write(out, tracks, report)
    if as_json:
        told = {"written": str(out), "files": list(map(str, made)), "format": wanted.name}
        print_json({**told, "rows": len(tracks)})
    else:
        print(*made, sep="\n")


def _format_to_write(name: str) -> tuple[TrackFormat, Write]:
    """The format of that name. Raises FormatError, which lists what can be written."""
    written = {each.name: each.write for each in FORMATS.values() if each.write is not None}
    if name in written:
        return FORMATS[name], written[name]
    known = name in FORMATS
    why = f"{FORMATS[name].title} is only read" if known else f"format {name!r} is unknown"
    raise FormatError(f"{why}; choose one of: {', '.join((*written, *_PARTS))}")


def _view(session: Session) -> View | None:
    """The session's camera over its floor; None, which is told, where nobody knows it."""
    try:
        with session.open_recording(known=known_recordings()) as recording:
            view = recording.view
    except RecordingMissing:
        view = None
    if view is None:
        say("note: camera and floor are not known or out of reach; places are left out")
    return view


def _what_first(session: Session) -> str:
    """What to do before there are samples."""
    run = session.corrected_run
    if run is None or not len(run.parts["frame"]):
        return "its tracks have no body parts: track it with three-part, then label them"
    return "label tracked body parts first"


def _export_parts(path: Path, out: Path, name: str, run: int | None, *, as_json: bool) -> None:
    if run is not None:
        raise OutputError(f"{name} belong to the corrected tracks; leave --run out")
    check_file(out)
    if name == "labels":
        check_text_replaced(out)
    else:
        check_replaced(out, HDF5_FORMAT)
    with closing(Session.open(path)) as session:
        if name == "labels":
            labels = list(session.labels.parts.values())
            if not labels:
                raise OutputError(f"{path} has no labels of body parts; label some first")
            write_part_labels(out, labels)
            made, rows = [out], len(labels)
        else:
            samples = session_samples(session)
            if not len(samples):
                raise OutputError(f"{path} has no samples; {_what_first(session)}")
            made, rows = write_samples(out, samples), len(samples)
    if as_json:
        written = [str(file) for file in made]
        print_json({"written": written, "format": name, "rows": rows})
    else:
        print(*made, sep="\n")
