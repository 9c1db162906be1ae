"""The formats tracks are exported in, as the user chooses among them."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.i18n import tr
from tracking.formats import FORMATS, TrackFormat


@dataclass(frozen=True, slots=True)
class ExportFormat:
    """A format as the dialog lists it.

    Attributes:
        name: in the catalogue. title: what people call it. ending: of its files, with the dot; "":
            it is a folder.
        about: what of the tracks it holds, and for whom.
    """

    name: str
    title: str
    ending: str
    about: str


def export_formats() -> tuple[ExportFormat, ...]:
    """All that are written."""
    return tuple(_listed(each) for each in FORMATS.values() if each.write is not None)


def _listed(each: TrackFormat) -> ExportFormat:
    ending = "" if each.is_folder else each.extensions[0]
    return ExportFormat(each.name, tr(each.title), ending, tr(each.about))


def propose_file_name(recording: str, each: ExportFormat) -> str:
    """What a file of the recording's tracks is called at first, e.g. "lobby-tracks.csv"."""
    return f"{_begun(recording)}tracks{each.ending}"


def propose_session_name(recording: str) -> str:
    """What a session of a recording is called at first, e.g. "lobby-session.h5"."""
    return f"{_begun(recording)}session.h5"


def propose_report_folder(recording: str) -> str:
    """What the folder of a report on a recording is called, e.g. "lobby-score"."""
    return f"{_begun(recording)}score"


def _begun(recording: str) -> str:
    """A recording's name as files may begin with it; "" where nothing of it may."""
    plain = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in recording)
    stem = "-".join(part for part in plain.split("-") if part)
    return f"{stem}-" if stem else ""
