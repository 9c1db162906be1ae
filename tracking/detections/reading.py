"""Files of detections: which format one has, told by content, and what it holds."""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tracking.detections.box_reading import BoxReading
from tracking.detections.mot_boxes import read_mot_boxes
from tracking.detections.table import BoxTable
from tracking.errors import FormatError, explain_unreadable
from tracking.formats.mot import is_mot, lacks_commas
from tracking.formats.read_result import Reading
from tracking.formats.track_format import HEAD_BYTES
from tracking.progress import Progress, no_progress
from tracking.translation import Message, count_msg, msg

MOST_BYTES = 200 << 20
"""More than five million boxes take as text."""
_BLOCK = 1 << 20


@dataclass(frozen=True, slots=True)
class BoxFormat:
    """A format of detections.

    Attributes:
        name: as sessions and reports have it. title: what people call it.
        recognises: whether a file is of it, by its first `HEAD_BYTES` bytes; never raises.
        read: takes the boxes of a file in.
    """

    name: str
    title: str
    recognises: Callable[[bytes], bool]
    read: Callable[[BoxReading], None]


_FORMATS = (BoxFormat("mot", "MOTChallenge text", is_mot, read_mot_boxes),)


@dataclass(frozen=True, slots=True, eq=False)
class DetectionsFile:
    """What a file of detections holds.

    Attributes:
        path: of the file. format: its name. title: what people call that.
        fingerprint: SHA-256 of all its bytes, in hex.
        table: the boxes that are valid. notes: what else the user should know, a line each.
    """

    path: Path
    format: str
    title: str
    fingerprint: str
    table: BoxTable
    notes: tuple[Message, ...]


def read_detections(path: Path, report: Progress = no_progress) -> DetectionsFile:
    """The boxes of a file; invalid ones are left out and told.

    Raises FormatError where it is missing, a link, too large, of no known format or without any
    box that can be used.
    """
    _check_place(path)
    with explain_unreadable(path):
        head, fingerprint = _looked_through(path)
    known = _format_of(path, head)
    boxes = BoxReading(Reading(path, report))
    known.read(boxes)
    table = boxes.table()
    notes = _notes(boxes.reading)
    return DetectionsFile(path, known.name, known.title, fingerprint, table, notes)


def _check_place(path: Path) -> None:
    """Refuse what is no plain file of a size that is read."""
    with explain_unreadable(path):
        state = os.lstat(path)
    if stat.S_ISLNK(state.st_mode):
        raise FormatError(
            "{path} is a link, which is not followed; name the file it leads to", path=path
        )
    if not stat.S_ISREG(state.st_mode):
        raise FormatError("{path} is no file of detections; name one", path=path)
    if not state.st_size:
        raise FormatError("{path} is empty; give a file of detections", path=path)
    if state.st_size > MOST_BYTES:
        raise FormatError(
            "{path} is larger than {size} MB; split it first", path=path, size=MOST_BYTES >> 20
        )


def _looked_through(path: Path) -> tuple[bytes, str]:
    """The first `HEAD_BYTES` bytes of a file, and the SHA-256 of all."""
    digest, head = hashlib.sha256(), b""
    with path.open("rb") as stream:
        while block := stream.read(_BLOCK):
            head = head or block[:HEAD_BYTES]
            digest.update(block)
    return head, digest.hexdigest()


def _format_of(path: Path, head: bytes) -> BoxFormat:
    for known in _FORMATS:
        if known.recognises(head):
            return known
    if lacks_commas(head):
        raise FormatError("{path}: no commas between values; MOT text wants them", path=path)
    raise FormatError(
        "{path} is no file of detections; give MOT text, COCO JSON or a folder of YOLO text",
        path=path,
    )


def _notes(reading: Reading) -> tuple[Message, ...]:
    if not reading.bad_count:
        return ()
    first = reading.bad_rows[0]
    told = msg(
        "{path}: {boxes} cannot be used, the first in {place}: {reason}",
        path=reading.path.name,
        boxes=count_msg(reading.bad_count, "{n} box", "{n} boxes"),
        place=first.place,
        reason=first.reason,
    )
    return (told,)
