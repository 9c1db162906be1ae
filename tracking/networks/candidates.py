"""Which of a network's boxes are used: sure ones, one a person, in px of the picture."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.networks.letterbox import Placement

MOST_CANDIDATES = 5_000
"""The surest boxes of a picture that are looked at further; public networks have 100 a person."""
_MOST_SCORE = 1.001
_LEAST_SCORE = 1e-6
"""What decoders call nobody has 0."""
_EMPTY = np.empty((0, 5), np.float32)


def chosen_boxes(
    corners: NDArray[np.floating[Any]],
    score: NDArray[np.floating[Any]],
    placement: Placement,
    least_score: float,
    max_overlap: float,
) -> NDArray[np.float32]:
    """(k, 5) left, top, width, height px of the picture as recorded, and score.

    Args:
        corners: (n, 4) px of the input. score: (n,) in 0..1.
        placement: of the picture in the input.
        max_overlap: intersection over union above which the surer of two boxes is used; 1: both.

    Raises FormatError where a score is no share, or a box that is sure has no place.
    """
    if np.isnan(score).any():
        raise FormatError("a score is not a number")
    if len(score) and float(score.max()) > _MOST_SCORE:
        raise FormatError(
            "a score is {score:.3g}, above 1; are decoder and activation right?",
            score=float(score.max()),
        )
    order = np.argsort(-score, kind="stable")
    order = order[score[order] >= max(least_score, _LEAST_SCORE)][:MOST_CANDIDATES]
    if not np.isfinite(corners[order]).all():
        raise FormatError("a box is not finite")
    box = placement.to_picture(corners[order].astype(np.float64))
    sides, sure = box[:, 2:] - box[:, :2], score[order]
    inside = (box[:, :2] < placement.size_px).all(axis=1) & (box[:, 2:] > 0).all(axis=1)
    kept = (sides > 0).all(axis=1) & inside
    rows = np.column_stack((box[:, :2], sides, sure))[kept].astype(np.float32)
    if max_overlap >= 1.0 or len(rows) < 2:
        return rows if len(rows) else _EMPTY
    boxes, scores = rows[:, :4].astype(np.float64).tolist(), rows[:, 4].tolist()
    return rows[np.asarray(cv2.dnn.NMSBoxes(boxes, scores, 0.0, max_overlap), np.intp).ravel()]
