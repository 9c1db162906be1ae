"""Bodies in the boxes of another program's detector, painted where the foreground lacks them."""

from __future__ import annotations

import cv2
import numpy as np

from tracking.arrays import Flags, Floats, Mask

FILLED = 0.25
"""Share of a body that is foreground from which on the foreground tells where it is, better than
boxes, which err by some 7 % of their height; less, and somebody stands still, or is dressed like
what is behind."""
WIDE = 1.15
"""Arms and strides reach out of the usual outline."""
_RIGHT = np.array(((0.12, 0.0), (0.2, 0.12), (0.42, 0.2), (0.42, 0.5), (0.3, 0.55), (0.3, 1.0)))
_OUTLINE = np.concatenate((_RIGHT, _RIGHT[::-1] * (-1.0, 1.0)))
"""Of a body, from the middle of its box's upper side, in sizes of the box: head, arms, legs."""
_FAR_PX = 30_000.0
_MIDDLE = 0.25
"""Of a box: somebody whose middle is so far inside is the one it shows."""


def working_boxes(boxes: Floats, shrink: int) -> Floats:
    """(n, 4) the boxes (n, 4) px as recorded, in pixels that are `shrink` of these wide."""
    low = (boxes[:, :2] + 0.5) / shrink - 0.5
    return np.concatenate((low, boxes[:, 2:] / shrink), axis=1)


def body_in(
    box: Floats, shape: tuple[int, ...], scale: float = 1.0
) -> tuple[tuple[slice, slice], Mask]:
    """The body in a box: the part of a picture that holds it, and 1 where it is there, else 0.

    Args:
        box: (4,) left, top, width, height px. shape: (height, width) of the picture.
        scale: by which it is wider than usual.
    """
    corners = np.array((box[0] + box[2] / 2, box[1])) + _OUTLINE * (scale * box[2], box[3])
    whole = np.rint(np.clip(corners, -_FAR_PX, _FAR_PX)).astype(np.int32)
    left, top, wide, tall = cv2.boundingRect(whole)
    rows, columns = (
        slice(max(low, 0), min(max(low + size, 0), length))
        for low, size, length in ((top, tall, shape[0]), (left, wide, shape[1]))
    )
    size = max(rows.stop - rows.start, 0), max(columns.stop - columns.start, 0)
    body = np.zeros(size, np.uint8)
    if body.size:
        cv2.fillPoly(body, [whole - (columns.start, rows.start)], 1.0)
    return (rows, columns), body


def paint_bodies(picture: Mask, boxes: Floats, value: int, *, only: bool = False) -> Mask:
    """The picture with a body painted in boxes that it leaves empty.

    Args:
        picture: (height, width) uint8, 0 to 255 for how surely something is there.
        boxes: (n, 4) left, top, width, height px of this picture.
        value: 1 to 255, what bodies are painted with.
        only: whether nothing counts outside of boxes.
    """
    drawn = np.zeros_like(picture) if only else picture.copy()
    for box in boxes:
        place, body = body_in(box, picture.shape)
        pixels = cv2.countNonZero(body)
        if not pixels:
            continue
        if float(picture[place][body > 0].sum()) < FILLED * 255.0 * pixels:
            drawn[place] = cv2.max(drawn[place], body * np.uint8(value))
        elif only:
            place, body = body_in(box, picture.shape, WIDE)
            drawn[place] = cv2.max(drawn[place], picture[place] * body)
    return drawn


def in_boxes(points: Floats, boxes: Floats) -> Flags:
    """(n,) whether points (n, 2) lie in the middle part of one of the boxes (k, 4), px."""
    inner = boxes[:, 2:] * _MIDDLE
    low, high = boxes[:, :2] + inner, boxes[:, :2] + boxes[:, 2:] - inner
    inside = (points[:, None] >= low) & (points[:, None] <= high)
    return np.asarray(np.any(np.all(inside, axis=2), axis=1), np.bool_)
