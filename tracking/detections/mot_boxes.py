"""MOTChallenge's det.txt: a box a row, `frame, id, left, top, width, height, conf` and more.

Frames and pixels count from 1 there; a file with a frame 0 counts both from 0. The id is -1, as
nobody is followed yet; whatever it is, it is passed over.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.detections.box_collector import BoxCollector
from tracking.detections.frame_numbers import Footage
from tracking.formats.delimited_text import NumberRows, RowShape, pieces_of
from tracking.formats.mot import UNKNOWN
from tracking.translation import Message, msg

_SHAPE = RowShape("MOT text", least=6, most=10, comment="#")
_CONFIDENCE = 6


def read_mot_boxes(boxes: BoxCollector, _footage: Footage) -> None:
    """All boxes of the file; raises FormatError where it is no such text."""
    boxes.no_score, boxes.counts_pixels = UNKNOWN, True
    reading = boxes.reading
    for table, lines, _ in NumberRows(reading, _SHAPE).tables(
        pieces_of(reading.path, reading.report, boxes.held)
    ):
        boxes.count(table[:, 0])
        box = table[:, 2:_CONFIDENCE]
        boxes.add(table[:, 0], box, _scores(table), partial(_line_of, lines))


def _line_of(lines: NDArray[np.int32], row: int) -> Message:
    return msg("line {line}", line=int(lines[row]))


def _scores(table: Floats) -> Floats:
    """(n,) as the text has them; what stands for none where rows are too short for one."""
    if table.shape[1] <= _CONFIDENCE:
        return np.full(len(table), UNKNOWN)
    return table[:, _CONFIDENCE].copy()
