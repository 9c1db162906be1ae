"""A folder of YOLO text: a file a frame, a box a row, `class cx cy w h` and perhaps a confidence.

The centre and the sides are shares of the picture. Class 0 is people, or where the folder has a
`classes.txt` (or `obj.names`), the one that is called person in it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tracking.detections.box_collector import BoxCollector
from tracking.detections.coco_boxes import PEOPLE
from tracking.detections.frame_numbers import Footage
from tracking.errors import FormatError, explain_unreadable
from tracking.formats.read_result import Reading
from tracking.formats.xanylabeling_folder import files_in
from tracking.owned_files import SAFE_FLAGS
from tracking.translation import msg

ENDING = ".txt"
_NAMES = ("classes.txt", "obj.names")
_MOST_FILE_BYTES = 1 << 20
"""Of one frame: ten thousand boxes."""
_NUMBER = r"[-+]?(?:nan|inf|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)"
_FIELDS = 6
"""Of a row with a confidence; trackers append an id."""
_ROW = re.compile(rf"\d+(?:[ \t]+{_NUMBER}){{4,6}}[ \t\r]*", re.IGNORECASE)
_FARTHEST = 10.0
"""Shares of a picture beyond which a number is none."""


def is_yolo(folder: Path) -> bool:
    """Whether a folder has text files, as far as told by their names."""
    try:
        with os.scandir(folder) as entries:
            return any(entry.name.lower().endswith(ENDING) for entry in entries)
    except OSError:
        return False


def contents_of(reading: Reading) -> Iterator[tuple[str, bytes]]:
    """Name and bytes of each text of a folder, in natural order, then of that with the classes.

    Links are told as bad. Raises FormatError where the folder or one of its files cannot be read,
    or there are far too many.
    """
    for path in files_in(reading, ENDING)[0]:
        if path.name not in _NAMES:
            yield path.name, _read_small(path)
    for path in (reading.path / name for name in _NAMES):
        if path.is_file() and not path.is_symlink():
            yield path.name, _read_small(path)
            return


def read_yolo_boxes(boxes: BoxCollector, footage: Footage) -> None:
    """All boxes of people in the folder's files, as `boxes.files` has them.

    Raises FormatError where a file is no such text.
    """
    reading = boxes.reading
    texts = {name: held for name, held in boxes.files.items() if name not in _NAMES}
    numbers, counts = footage.numbers_of_names([Path(name).stem for name in texts])
    if counts:
        boxes.count(numbers)
    people = _people_in(boxes)
    for at, ((name, held), frame) in enumerate(zip(texts.items(), numbers.tolist(), strict=True)):
        reading.report(at, len(texts))
        if frame < 0:
            reading.bad(name, msg("its name has no number of a frame"))
        else:
            _take(boxes, name, _lines_of(held), frame, people, footage)


def _read_small(path: Path) -> bytes:
    """The bytes of a plain file of a folder.

    Raises FormatError where it is a link or anything but a file, or larger than a frame's.
    """
    with (
        explain_unreadable(path),
        os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as stream,
    ):
        held = stream.read(_MOST_FILE_BYTES + 1)
    if len(held) > _MOST_FILE_BYTES:
        raise FormatError(
            "{path} is larger than {size} kB; is it the text of one frame?",
            path=path,
            size=_MOST_FILE_BYTES >> 10,
        )
    return held


def _lines_of(held: bytes) -> list[str]:
    return held.decode("utf-8", "replace").split("\n")


def _people_in(boxes: BoxCollector) -> int:
    """The class of people, by the names the folder has; 0 where it has none.

    Raises FormatError where none of the names is person.
    """
    file = next((name for name in _NAMES if name in boxes.files), None)
    if file is None:
        return 0
    for number, name in enumerate(_lines_of(boxes.files[file])):
        if name.strip().lower() in PEOPLE:
            return number
    raise FormatError(
        "{path}: none of the classes is person; rename the one of people",
        path=boxes.reading.path / file,
    )


def _take(
    boxes: BoxCollector,
    file: str,
    texts: list[str],
    frame: int,
    people: int,
    footage: Footage,
) -> None:
    """The boxes of one file, line by line."""
    rows, lines = [], []
    for number, line in enumerate(texts, 1):
        if not line.strip():
            continue
        if not _ROW.fullmatch(line.strip()):
            boxes.reading.bad(
                msg("{file}, line {line}", file=file, line=number),
                msg("it is no row of YOLO text: class, centre, width, height and confidence"),
            )
            continue
        fields = [float(field) for field in line.split()]
        boxes.reading.good += 1
        if fields[0] == people:
            rows.append([*fields[1:5], fields[5] if len(fields) >= _FIELDS else np.nan])
            lines.append(number)
    if not rows:
        return
    table = np.array(rows)
    share = table[:, :4]
    share[(np.abs(share) > _FARTHEST).any(axis=1)] = np.nan
    width, height = footage.size_px
    centre, size = share[:, :2] * (width, height), share[:, 2:] * (width, height)
    boxes.add(
        np.full(len(table), float(frame)),
        np.column_stack((centre - size / 2, size)),
        table[:, 4],
        lambda row: msg("{file}, line {line}", file=file, line=lines[row]),
    )
