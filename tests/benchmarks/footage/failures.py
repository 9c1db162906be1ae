"""Pictures of what goes wrong: the frame of a recording in which a tracker errs most.

They show footage of others, so they are made where they are asked for and are no part of the page.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.clips import truth_table
from tests.benchmarks.footage.measures import OVERLAP
from tests.benchmarks.footage.recordings import Footage
from tests.benchmarks.pages import save_jpeg
from tests.benchmarks.pictures import Colour, Picture, write
from tracking.scoring import BoxMatch, ScoringTable, examine
from tracking.tracks import Columns

_MISSED: Colour = (0, 220, 255)
_FALSE: Colour = (40, 40, 255)
_FOUND: Colour = (60, 220, 60)


def save_worst_frame(footage: Footage, tracker: str, tracks: Columns, folder: Path) -> Path | None:
    """A picture with who is found (green), missed (yellow) and false (red); None without labels."""
    if not footage.labelled:
        return None
    compared = examine(
        truth_table(footage.folder), ScoringTable.from_columns(tracks), BoxMatch(OVERLAP)
    )
    truth, result = compared.comparison.truth, compared.comparison.result
    found = np.isin(np.arange(len(result)), compared.matched.rows.result)
    missed = ~np.isin(np.arange(len(truth)), compared.matched.rows.truth)
    wrong = np.concatenate([truth.frame[missed], result.frame[~found]])
    if not len(wrong):
        return None
    frame = int(np.bincount(wrong).argmax())
    with footage.open() as recording:
        image: Picture = recording.read(frame).left.copy()
    if image.ndim == 2:
        image = np.asarray(cv2.cvtColor(image, cv2.COLOR_GRAY2BGR), np.uint8)
    for box in truth.box[missed & (truth.frame == frame)]:
        _draw(image, box, _MISSED, "missed")
    for row in np.flatnonzero(result.frame == frame):
        colour = _FOUND if found[row] else _FALSE
        _draw(image, result.box[row], colour, str(result.track[row]))
    path = folder / f"{footage.name}-{tracker}-{frame}.jpg"
    save_jpeg(path, image)
    return path


def _draw(image: Picture, box: np.ndarray, colour: Colour, text: str) -> None:
    left, top, right, bottom = np.rint([*box[:2], *(box[:2] + box[2:])]).astype(int).tolist()
    cv2.rectangle(image, (left, top), (right, bottom), colour, 2)
    write(image, text, (left, max(top - 4, 14)), colour)
