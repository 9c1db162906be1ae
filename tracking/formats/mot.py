"""MOTChallenge text: a row a person a frame, numbers divided by commas.

Three dialects share their first seven numbers, `frame, id, left, top, width, height, conf`: what
trackers give ends there; the challenge of 2015 adds the place in the world, `x, y, z`; those of
2016 and later add `class, visibility`. The text counts frames and pixels from 1; everything else in
this program counts from 0, so both are shifted in `mot_reading` and `mot_writing`, and nowhere
else. `-1` stands for a number that is not known. `#` and what stands
behind it in a line is a comment.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

from tracking.formats.mot_reading import import_mot
from tracking.formats.mot_writing import export_mot, export_mot_classes
from tracking.formats.track_format import Content, TrackFormat

_NUMBER = rb"[ \t]*[-+]?(?:nan|inf|[\d.]+(?:e[-+]?\d+)?)[ \t]*"
"""Also what no row can hold: a reader tells the line and why, nobody else does."""
_ONE = re.compile(_NUMBER, re.IGNORECASE)
_DIVIDERS = re.compile(rb"(?<=\S)(?:[ \t]*;[ \t]*|[ \t]+)(?=\S)")
_LEAST, _MOST = 6, 10
_WITH_CLASSES = (8, 9)
_LINES = 50
"""So many lines say what a text is, where its first one is bad."""


def _numbers_in_a_row(head: bytes) -> int:
    """How many numbers a row holds; 0 where the text is no MOT text.

    Rows may be bad, the first one too: most lines must look like rows. A first line without any
    number is the header of another table.
    """
    text = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    rows = (line.partition(b"#")[0] for line in text.split(b"\n"))
    lines = [row for row in rows if row.strip()][:_LINES]
    if not lines or not any(map(_ONE.fullmatch, _fields(lines[0]))):
        return 0
    lengths = [len(_fields(line)) for line in lines if _is_like_a_row(line)]
    return Counter(lengths).most_common(1)[0][0] if len(lengths) * 2 > len(lines) else 0


def lacks_commas(head: bytes) -> bool:
    """Whether a text would be MOT text with commas in place of its spaces or semicolons."""
    return b"," not in head and _numbers_in_a_row(_DIVIDERS.sub(b",", head)) > 0


def _fields(line: bytes) -> list[bytes]:
    return line.rstrip(b"\r").split(b",", _MOST)


def _is_like_a_row(line: bytes) -> bool:
    """Whether it has as many values as a row, and all but one of them are numbers."""
    fields = _fields(line)
    numbers = sum(_ONE.fullmatch(field) is not None for field in fields)
    return _LEAST <= len(fields) <= _MOST and numbers >= len(fields) - 1


def _with_world(_path: Path, head: bytes) -> bool:
    count = _numbers_in_a_row(head)
    return count > 0 and count not in _WITH_CLASSES


def _with_classes(_path: Path, head: bytes) -> bool:
    return _numbers_in_a_row(head) in _WITH_CLASSES


MOT = TrackFormat(
    "mot",
    "MOTChallenge text, world columns",
    (".txt",),
    _with_world,
    import_mot,
    export_mot,
    by_numbers=True,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.PLACES, Content.CONFIDENCE)),
    confidence_in_results=True,
)
MOT16 = TrackFormat(
    "mot16",
    "MOTChallenge text from 2016 on, class and visibility",
    (".txt",),
    _with_classes,
    import_mot,
    export_mot_classes,
    by_numbers=True,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.VISIBILITY, Content.CLASSES)),
    confidence_in_results=True,
)
