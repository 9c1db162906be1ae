"""A format of another tool: how it is told, read and written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from tracking.formats.reading import Filmed, Imported
from tracking.formats.writing import Exported
from tracking.progress import Progress

HEAD_BYTES = 1 << 16
"""So much of a file is enough to tell its format."""

Write = Callable[[Path, Exported, Progress], tuple[Path, ...]]


class Read(Protocol):
    """Reads a file of the format."""

    def __call__(self, path: Path, filmed: Filmed, /, report: Progress = ...) -> Imported:
        """The tracks of a file, of a recording of which that is known; see `TrackFormat`."""


@dataclass(frozen=True, slots=True)
class TrackFormat:
    """A format of another tool. A module makes one; the catalogue lists it.

    Attributes:
        name: as `--format` takes it.
        title: what people call it.
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
        dont_cares: in a truth, rows of confidence 0 are not counted; else that is a tracker's.
    """

    name: str
    title: str
    extensions: tuple[str, ...]
    recognises: Callable[[Path, bytes], bool]
    read: Read | None = None
    write: Write | None = None
    in_camera: bool = False
    dont_cares: bool = False
