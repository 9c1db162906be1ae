"""The foreground of one camera as silhouettes: fragments joined, noise dropped."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Labels = NDArray[np.uint8]
AnyLabels = NDArray[np.uint8 | np.uint16]
"""A picture of regions: k + 1 for the pixels of the k-th, 0 elsewhere. Where boxes of another
program come to those of the foreground, there may be more than 8 bits tell apart."""
Box = tuple[int, int, int, int]

_SPECK = 1.5e-4
"""Components smaller than this share of the picture are dropped at once."""
_MOST_SILHOUETTES = 250
_GAP = 0.3
"""Fragments one above the other belong together over a gap of this share of their height."""
_COVERED = 0.5
"""And where this share of the narrower one's width lies over the other."""
_CLOSING = cv2.getStructuringElement(cv2.MORPH_RECT, (3, 5))
_HALF_COVERED = 120


def silhouettes(body: NDArray[np.uint8]) -> tuple[Labels, list[Box]]:
    """Label the foreground, what is broken across by belts and shadows joined again.

    What belongs together is found at half the resolution, for speed.

    Args:
        body: (height, width) uint8, 255 in foreground that is no shadow, else 0.

    Returns:
        labels: (height, width), k + 1 for the foreground of silhouette k, 0 elsewhere.
        boxes: left, top, width, height of each.
    """
    small = cv2.resize(body, _half_size(body), interpolation=cv2.INTER_AREA)
    _, small = cv2.threshold(small, _HALF_COVERED, 255, cv2.THRESH_BINARY)
    closed = cv2.morphologyEx(small, cv2.MORPH_CLOSE, _CLOSING)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    largest = np.argsort(-stats[1:, cv2.CC_STAT_AREA], kind="stable")[:_MOST_SILHOUETTES] + 1
    kept = largest[stats[largest, cv2.CC_STAT_AREA] >= _SPECK * small.size]
    boxes = [_box(2 * row, body.shape) for row in stats[kept, :4]]
    areas = stats[kept, cv2.CC_STAT_AREA].tolist()
    number = np.zeros(count, np.uint8)
    owner = _joined(boxes, areas)
    number[kept] = np.array([owner[k] + 1 for k in range(len(kept))], np.uint8)
    full = cv2.resize(number[labels], body.shape[::-1], interpolation=cv2.INTER_NEAREST)
    full = np.where(body > 0, full, np.uint8(0))
    return full, [_union(boxes, owner, k) for k in range(max(owner, default=-1) + 1)]


def _half_size(body: NDArray[np.uint8]) -> tuple[int, int]:
    return -(-body.shape[1] // 2), -(-body.shape[0] // 2)


def _joined(boxes: list[Box], areas: list[int]) -> list[int]:
    """The silhouette each fragment belongs to, numbered from 0; fragments come largest first."""
    owner: list[int] = []
    whole: list[Box] = []
    for k, box in enumerate(boxes):
        fits = [j for j, other in enumerate(whole) if _stacked(other, box)]
        large = [j for j in fits if areas[owner.index(j)] >= 2 * areas[k]]
        if large:
            best = min(large, key=lambda j: _gap(whole[j], box))
            owner.append(best)
            whole[best] = _around(whole[best], box)
        else:
            owner.append(len(whole))
            whole.append(box)
    return owner


def _stacked(one: Box, other: Box) -> bool:
    """Whether two boxes stand one above the other, close enough to be one person."""
    shared = min(one[0] + one[2], other[0] + other[2]) - max(one[0], other[0])
    return shared >= _COVERED * min(one[2], other[2]) and _gap(one, other) <= _GAP * one[3]


def _gap(one: Box, other: Box) -> int:
    return max(one[1] - other[1] - other[3], other[1] - one[1] - one[3], 0)


def _union(boxes: list[Box], owner: list[int], k: int) -> Box:
    own = [box for box, whose in zip(boxes, owner, strict=True) if whose == k]
    whole = own[0]
    for box in own[1:]:
        whole = _around(whole, box)
    return whole


def _around(one: Box, other: Box) -> Box:
    left, top = min(one[0], other[0]), min(one[1], other[1])
    right = max(one[0] + one[2], other[0] + other[2])
    bottom = max(one[1] + one[3], other[1] + other[3])
    return left, top, right - left, bottom - top


def _box(row: NDArray[np.int32], shape: tuple[int, ...]) -> Box:
    """A box of full pixels inside the picture."""
    left, top, width, height = row.tolist()
    return left, top, min(width, shape[1] - left), min(height, shape[0] - top)
