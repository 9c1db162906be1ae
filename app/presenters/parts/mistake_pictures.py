"""Pieces of pictures around parts that were judged wrongly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.presenters.document.document import Document
from app.presenters.labelling.parts import Box, parts_of
from app.presenters.parts.training_result import MistakeItem

_AROUND = 1.2
"""How much is seen around the part, in its larger side."""
_LEAST_PX = 48


def cut_out(document: Document, item: MistakeItem) -> tuple[NDArray[np.uint8], Box] | None:
    """The surroundings of a part, and the part's rectangle in them.

    None where the mistake is in another recording, or its person is gone.
    """
    session, recording = document.session, document.recording
    if session is None or item.recording != recording.name:
        return None
    if not 0 <= item.frame < recording.frame_count:
        return None
    run = session.corrected_run
    there = parts_of(session.labels, session.tracks, run, item.track, item.frame)
    if item.part not in there:
        return None
    picture = recording.read(item.frame).left
    return cut_around(picture, there[item.part][0].box)


def cut_around(picture: NDArray[np.uint8], box: Box) -> tuple[NDArray[np.uint8], Box] | None:
    """A square of the picture around a box, cut off at its edges; None far beside it."""
    left, top, width, height = box
    side = max((1 + 2 * _AROUND) * max(width, height), _LEAST_PX)
    across, down = left + width / 2 - side / 2, top + height / 2 - side / 2
    rows, columns = picture.shape[:2]
    first, last = max(0, round(across)), min(columns, round(across + side))
    upper, lower = max(0, round(down)), min(rows, round(down + side))
    if last <= first or lower <= upper:
        return None
    piece = np.ascontiguousarray(picture[upper:lower, first:last])
    return piece, (left - first, top - upper, width, height)
