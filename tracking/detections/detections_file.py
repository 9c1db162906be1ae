"""Files of detections: which format one has, told by content, and what it holds."""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.detections.box_collector import BoxCollector
from tracking.detections.box_format import YOLO, BoxFormat
from tracking.detections.catalogue import box_format_of, told_of_plugins
from tracking.detections.frame_numbers import Footage
from tracking.detections.table import BoxTable
from tracking.detections.yolo_boxes import contents_of, is_yolo
from tracking.errors import FormatError, explain_unreadable
from tracking.formats.mot import lacks_commas
from tracking.formats.read_result import Reading
from tracking.formats.track_format import HEAD_BYTES
from tracking.owned_files import SAFE_FLAGS
from tracking.progress import Progress, no_progress
from tracking.translation import Message, count_msg, msg

MOST_BYTES = 200 << 20
"""More than five million boxes take as text."""


@dataclass(frozen=True, slots=True, eq=False)
class DetectionsFile:
    """What a file of detections, or a folder of them, holds of some footage.

    Attributes:
        path: of the file. format: its name. title: what people call that.
        fingerprint: SHA-256 of all bytes, in hex; of a folder see `_read_folder`.
        table: the boxes that are valid and in the footage.
        notes: what else the user should know, a line each.
    """

    path: Path
    format: str
    title: str
    fingerprint: str
    table: BoxTable
    notes: tuple[Message, ...]


def read_detections(path: Path, footage: Footage, report: Progress = no_progress) -> DetectionsFile:
    """The boxes of a file; those that are invalid or not of the footage are left out and told.

    Raises FormatError where it is missing, a link, too large, of no known format or without any
    box that can be used.
    """
    (file,) = read_cameras([(path, footage)], report)
    return file


def read_cameras(
    given: Sequence[tuple[Path, Footage]], report: Progress = no_progress
) -> tuple[DetectionsFile, ...]:
    """The same of a file for each camera; where they count pictures, they count alike.

    That is from 1, as tools do, unless one of them has a 0.
    """
    taken = [_Taken.of(path, footage, report) for path, footage in given]
    first = 0 if any(each.boxes.has_zero for each in taken) else 1
    return tuple(each.counted_from(first) for each in taken)


@dataclass(frozen=True, slots=True, eq=False)
class _Taken:
    """A file that was read, before it is known from where on it counts pictures."""

    known: BoxFormat
    fingerprint: str
    boxes: BoxCollector
    footage: Footage

    @classmethod
    def of(cls, path: Path, footage: Footage, report: Progress) -> _Taken:
        boxes = BoxCollector(Reading(path, report))
        known, fingerprint = _read_into(boxes)
        known.read(boxes, footage)
        boxes.held, boxes.files = b"", {}
        return cls(known, fingerprint, boxes, footage)

    def counted_from(self, first: int) -> DetectionsFile:
        reading, known = self.boxes.reading, self.known
        path = reading.path
        table, told = _in_footage(path, self.boxes.table(first), self.footage)
        notes = [*reading.notes, *_invalid(reading), *told]
        return DetectionsFile(
            path,
            known.name,
            known.title,
            self.fingerprint,
            table,
            tuple(msg("{file}: {note}", file=path.name, note=note) for note in notes),
        )


def _read_into(boxes: BoxCollector) -> tuple[BoxFormat, str]:
    """Read a file or folder, once, into `held` or `files`: its format, the SHA-256 of all bytes."""
    path = boxes.reading.path
    if path.is_symlink():
        raise FormatError(
            "{path} is a link, which is not followed; name the file it leads to", path=path
        )
    if path.is_dir():
        return YOLO, _read_folder(boxes)
    boxes.held = _read_file(path)
    known = _format_of(path, boxes.held[:HEAD_BYTES])
    return known, hashlib.sha256(boxes.held).hexdigest()


def _read_file(path: Path) -> bytes:
    """All bytes of a plain file."""
    with (
        explain_unreadable(path),
        os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as stream,
    ):
        state = os.fstat(stream.fileno())
        _check_state(path, state)
        held = stream.read(MOST_BYTES + 1)
    _check_size(path, len(held))
    return held


def _check_state(path: Path, state: os.stat_result) -> None:
    if not stat.S_ISREG(state.st_mode):
        raise FormatError("{path} is no file of detections; name one", path=path)
    if not state.st_size:
        raise FormatError("{path} is empty; give a file of detections", path=path)
    _check_size(path, state.st_size)


def _read_folder(boxes: BoxCollector) -> str:
    """Read the files of a folder of YOLO text: SHA-256 of name, length and bytes of each."""
    folder = boxes.reading.path
    if not is_yolo(folder):
        raise FormatError(
            "{path} is a folder without text files; give one of YOLO text, or a file", path=folder
        )
    size, digest = 0, hashlib.sha256()
    for name, held in contents_of(boxes.reading):
        size += len(held)
        _check_size(folder, size)
        for part in (os.fsencode(name), f" {len(held)} ".encode(), held):
            digest.update(part)
        boxes.files[name] = held
    return digest.hexdigest()


def _check_size(path: Path, size: int) -> None:
    if size > MOST_BYTES:
        raise FormatError(
            "{path} is larger than {size} MB; split it first", path=path, size=MOST_BYTES >> 20
        )


def _format_of(path: Path, head: bytes) -> BoxFormat:
    known = box_format_of(head)
    if known is not None:
        return known
    first, _, rest = head.partition(b"\n")
    if box_format_of(rest) is not None and first.strip():
        raise FormatError(
            "{path}: line 1 is no row of numbers, and the others are MOT text; remove it", path=path
        )
    failed = told_of_plugins()
    also = " (" + failed + ")" if failed else ""
    if lacks_commas(head):
        raise FormatError(
            "{path}: no commas between values; MOT text wants them, and YOLO text is given as the "
            "folder of its files{also}",
            path=path,
            also=also,
        )
    raise FormatError(
        "{path} is no file of detections; give MOT text, COCO JSON or a folder of YOLO text{also}",
        path=path,
        also=also,
    )


def _in_footage(
    path: Path, table: BoxTable, footage: Footage
) -> tuple[BoxTable, tuple[Message, ...]]:
    """The boxes that are of frames there are and lie, at least in part, in their pictures.

    One that reaches beyond the picture stays whole: where feet are cut off it tells where they
    are. Raises FormatError where no box is left.
    """
    later = table.frame >= footage.frames
    if len(table.box) and bool((table.box[:, 2:] <= 1).all()):
        raise FormatError(
            "{path}: its boxes are no larger than a pixel, as shares of an image are; give pixels, "
            "or YOLO text as the folder of its files",
            path=path,
        )
    low, high = table.box[:, :2], table.box[:, :2] + table.box[:, 2:]
    outside = ((low >= footage.size_px) | (high <= 0)).any(axis=1) & ~later
    width, height = footage.size_px
    if (later | outside).all():
        raise FormatError(
            "{path}: none of its boxes is in the {frames} frames of {width} x {height} px; is it "
            "of this recording?",
            path=path,
            frames=footage.frames,
            width=width,
            height=height,
        )
    told = []
    if beyond := int(np.count_nonzero(later)):
        told.append(
            msg(
                "not among them: {boxes} after the last frame ({last})",
                boxes=count_msg(beyond, "{n} box", "{n} boxes"),
                last=footage.frames - 1,
            )
        )
    if beside := int(np.count_nonzero(outside)):
        told.append(
            msg(
                "not among them: {boxes} outside of the image of {width} x {height} px",
                boxes=count_msg(beside, "{n} box", "{n} boxes"),
                width=width,
                height=height,
            )
        )
    return table.select(~(later | outside)) if told else table, tuple(told)


def _invalid(reading: Reading) -> Iterator[Message]:
    if reading.bad_count:
        first = reading.bad_rows[0]
        yield msg(
            "{boxes} cannot be used, the first in {place}: {reason}",
            boxes=count_msg(reading.bad_count, "{n} box", "{n} boxes"),
            place=first.place,
            reason=first.reason,
        )
