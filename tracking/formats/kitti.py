"""KITTI's tracking labels (`label_02/0000.txt`): a row an object a frame, divided by blanks.

`frame id type truncated occluded alpha left top right bottom height width length x y z rotation`,
and in results a score. Frames and pixels count from 0. The place is where the object meets the
floor, in metres along the camera's axes (x right, y down, z forward). KITTI takes it from its left
grey camera, 6 cm beside the left colour camera; here it is the recording's left camera, and what is
written reads back exactly. `DontCare` marks regions of the picture, which belong to nobody.
"""

from __future__ import annotations

import re
from pathlib import Path

from tracking.formats.kitti_reading import import_kitti
from tracking.formats.kitti_writing import export_kitti
from tracking.formats.track_format import Content, TrackFormat

_NUMBER = rb"[-+]?(?:nan|inf|[\d.]+(?:e[-+]?\d+)?)"
_FIRST_LINE = re.compile(
    rb"%b[ \t]+%b[ \t]+[a-z_]{1,40}(?:[ \t]+%b){14,15}[ \t\r]*" % (_NUMBER, _NUMBER, _NUMBER),
    re.IGNORECASE,
)


def _recognises(_path: Path, head: bytes) -> bool:
    first = head.removeprefix(b"\xef\xbb\xbf").lstrip().split(b"\n", 1)[0]
    return _FIRST_LINE.fullmatch(first) is not None


KITTI = TrackFormat(
    "kitti",
    "KITTI tracking labels",
    (".txt",),
    _recognises,
    import_kitti,
    export_kitti,
    in_camera=True,
    holds=frozenset(
        (
            Content.BOXES,
            Content.PLACES,
            Content.CONFIDENCE,
            Content.VISIBILITY,
            Content.CLASSES,
        )
    ),
    confidence_in_results=True,
)
