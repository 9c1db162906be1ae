"""A format of another tool: how it is told, read and written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Protocol

from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported
from tracking.progress import Progress
from tracking.tracks import TrackLabel

HEAD_BYTES = 1 << 16
"""So much of a file is enough to tell its format."""

Write = Callable[[Path, Exported, Progress], tuple[Path, ...]]


class Content(StrEnum):
    """What tracks may have that not every format holds; the values are read by people."""

    BOXES = "boxes"
    PLACES = "places on the floor"
    VELOCITIES = "velocities"
    CONFIDENCE = "confidence"
    VISIBILITY = "visibility"
    SOURCES = "sources (tracker, person, interpolated)"
    PREDICTED = "marks of predicted rows"
    CLASSES = "classes"
    NAMES = "names and attributes"
    NOTES = "notes on tracks"
    SCHEMA = "which attributes people have"


class Read(Protocol):
    """Reads a file of the format."""

    def __call__(self, path: Path, filmed: Filmed, /, report: Progress = ...) -> Imported:
        """The tracks of a file, of a recording of which that is known; see `TrackFormat`."""


@dataclass(frozen=True, slots=True)
class TrackFormat:
    """A format of another tool. A module makes one; the catalogue lists it.

    Attributes:
        name: as `--format` takes it.
        title: what people call it. about: what it holds of the tracks, and for whom, where it is
            written.
        extensions: of its files, with the dot, the usual one first.
        recognises: whether a file is of this format, given its path and its first
            `HEAD_BYTES` bytes; never raises, however hostile they are.
        read: the tracks of a file; bad rows are collected. Raises FormatError where the file as a
            whole cannot be read, and what the progress raises to cancel. None: this program does
            not read it.
        write: makes a file, which appears whole or not at all; gives the files made. Raises
            OutputError, FormatError where the tracks lack what the format needs, and what the
            progress raises to cancel. None: this program does not write it.
        in_camera: it tells places as the camera sees them: without a view they are left out.
        in_percent: it tells boxes in percent of a picture whose size a file need not say: it is
            read with what is known of the recording.
        recognises_folder: whether a folder holds tracks of this format, a file a frame; never
            raises. None: its files hold whole tracks, and a folder is none of it.
        by_numbers: its files are told by rows of numbers alone: all others are asked first.
        dont_cares: in a truth, rows of confidence 0 are not counted; else that is a tracker's.
        holds: what is written of the tracks, in full or in the format's grades.
        needs: rows without it (boxes or places) are not written; None: all rows are.
        unit_unsaid: its files may leave out their unit; then the user says it, see `Stated`.
        label_as_read: what comes back of a track's label that is written, without its notes; None:
            names and attributes are not in the format.
        confidence_in_results: confidence is written in results alone, not in ground truth.
    """

    name: str
    title: str
    extensions: tuple[str, ...]
    recognises: Callable[[Path, bytes], bool]
    read: Read | None = None
    write: Write | None = None
    in_camera: bool = False
    in_percent: bool = False
    by_numbers: bool = False
    recognises_folder: Callable[[Path], bool] | None = None
    dont_cares: bool = False
    holds: frozenset[Content] = frozenset()
    needs: Content | None = None
    unit_unsaid: bool = False
    confidence_in_results: bool = False
    label_as_read: Callable[[TrackLabel], TrackLabel] | None = None
    about: str = ""

    @property
    def is_folder(self) -> bool:
        """Whether tracks are a folder of files, a file a frame."""
        return self.recognises_folder is not None
