"""Boxes of regions, and full-body boxes of people who may be seen only in part."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Boxes = NDArray[np.float64]
GridBox = tuple[int, int, int, int]

_COVERED = 0.3
"""Share of a side along which somebody nearer must stand to hide what is behind."""
_EDGE_PLACES = 1


def region_boxes(labels: NDArray[np.uint8], count: int) -> list[GridBox]:
    """Left, top, width, height of the pixels labelled 1 to count; (0, 0, 0, 0) where none are."""
    return [
        tuple(cv2.boundingRect(cv2.compare(labels, k, cv2.CMP_EQ))) for k in range(1, count + 1)
    ]  # type: ignore[misc]


def hidden_sides(
    labels: NDArray[np.uint8], boxes: list[GridBox], sight: NDArray[np.float32]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Where regions end at the picture's edge or behind somebody nearer.

    Args:
        labels: (rows, columns) uint8, k + 1 for the pixels of region k.
        boxes: of the regions.
        sight: (k, 2) m on the floor from the eye to each region.

    Returns:
        (k, 4) bool for the left, top, right and bottom side, and (k,) bool, touching the edge.
    """
    rows, columns = labels.shape
    hidden = np.zeros((len(boxes), 4), np.bool_)
    distance = np.hypot(sight[:, 0], sight[:, 1])
    truncated = np.zeros(len(boxes), np.bool_)
    for k, (left, top, width, height) in enumerate(boxes):
        right, bottom = left + width, top + height
        at_edge = (
            left <= _EDGE_PLACES,
            top <= _EDGE_PLACES,
            right >= columns - _EDGE_PLACES,
            bottom >= rows - _EDGE_PLACES,
        )
        nearer = np.concatenate(([False], distance < distance[k]))
        strips = (
            labels[top:bottom, max(left - 1, 0) : left],
            labels[max(top - 1, 0) : top, left:right],
            labels[top:bottom, right : right + 1],
            labels[bottom : bottom + 1, left:right],
        )
        covered = [strip.size > 0 and nearer[strip].mean() > _COVERED for strip in strips]
        hidden[k] = np.logical_or(at_edge, covered)
        truncated[k] = any(at_edge)
    return hidden, truncated


def full_body_boxes(seen: Boxes, standing: Boxes, hidden: NDArray[np.bool_]) -> Boxes:
    """Boxes of whole bodies, from what is seen where it is whole.

    Args:
        seen: (n, 4) left, top, width, height of the visible regions.
        standing: (n, 4) of a body of the measured height standing at the measured place.
        hidden: (n, 4) bool; left, top, right, bottom side of the region ends at somebody nearer
            or at the picture's edge, so the body goes on behind it.

    Returns:
        (n, 4); a hidden side is taken from `standing` where that reaches farther.
    """
    near, far = _corners(seen), _corners(standing)
    outer = np.where([True, True, False, False], np.minimum(near, far), np.maximum(near, far))
    corners = np.where(hidden & np.isfinite(far), outer, near)
    return np.concatenate((corners[:, :2], corners[:, 2:] - corners[:, :2]), axis=1)


def _corners(boxes: Boxes) -> Boxes:
    """(n, 4) left, top, right, bottom."""
    return np.concatenate((boxes[:, :2], boxes[:, :2] + boxes[:, 2:]), axis=1)
