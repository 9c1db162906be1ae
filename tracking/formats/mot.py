"""MOTChallenge text: a row a person a frame, numbers divided by commas.

Three dialects share their first seven numbers, `frame, id, left, top, width, height, conf`: what
trackers give ends there; the challenge of 2015 adds the place in the world, `x, y, z`; those of
2016 and later add `class, visibility`. The text counts frames and pixels from 1; everything else in
this program counts from 0, so both are shifted in `mot_reading` and `mot_writing`, and nowhere
else. `-1` stands for a number that is not known.
"""

from __future__ import annotations

import re
from pathlib import Path

from tracking.formats.mot_reading import import_mot
from tracking.formats.mot_writing import export_mot, export_mot_classes
from tracking.formats.track_format import TrackFormat

_NUMBER = rb"[ \t]*[-+]?(?:nan|inf|[\d.]+(?:e[-+]?\d+)?)[ \t]*"
"""Also what no row can hold: a reader tells the line and why, nobody else does."""
_FIRST_LINE = re.compile(rb"%b(?:,%b){5,9}\r?" % (_NUMBER, _NUMBER), re.IGNORECASE)
_WITH_CLASSES = (8, 9)


def _numbers_in_first_row(head: bytes) -> int:
    """How many numbers the first line holds; 0 where it is no row of MOT text."""
    first = head.removeprefix(b"\xef\xbb\xbf").lstrip().split(b"\n", 1)[0]
    return first.count(b",") + 1 if _FIRST_LINE.fullmatch(first) else 0


def _with_world(_path: Path, head: bytes) -> bool:
    count = _numbers_in_first_row(head)
    return count > 0 and count not in _WITH_CLASSES


def _with_classes(_path: Path, head: bytes) -> bool:
    return _numbers_in_first_row(head) in _WITH_CLASSES


MOT = TrackFormat(
    "mot",
    "MOTChallenge text, world columns",
    (".txt",),
    _with_world,
    import_mot,
    export_mot,
    dont_cares=True,
)
MOT16 = TrackFormat(
    "mot16",
    "MOTChallenge text from 2016 on, class and visibility",
    (".txt",),
    _with_classes,
    import_mot,
    export_mot_classes,
    dont_cares=True,
)
