"""Pieces of pictures with boxes drawn on them, as JPEG."""

from __future__ import annotations

import cv2
import numpy as np

from tracking.arrays import Floats
from tracking.recording import Image

_WIDTH, _HEIGHT = 400, 300
_QUALITY = 82
_FONT, _LETTERS = 0.45, 18
"""Size of letters, and height of a line of them."""
_TRUTH = (255, 255, 255)


def painted(
    image: Image,
    window: tuple[int, int, int, int],
    boxes: tuple[Floats, Floats],
    names: tuple[str, str],
    colour: tuple[int, int, int],
) -> bytes:
    """A piece of a picture with the truth's box and the result's, as JPEG.

    Args:
        window: left, top, width, height of the piece.
        boxes: (4,) each, of the truth and of the result. names: of theirs.
        colour: BGR of the result's.
    """
    left, top, width, height = window
    scale = min(_WIDTH / width, _HEIGHT / height)
    piece = image[top : top + height, left : left + width]
    way = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
    piece = np.asarray(cv2.resize(piece, None, fx=scale, fy=scale, interpolation=way), np.uint8)
    for box, name, look in zip(boxes, names, (_TRUTH, colour), strict=True):
        corners = np.array([box[:2], box[:2] + box[2:]]) - (left, top)
        (x0, y0), (x1, y1) = (scale * corners).round().astype(int).tolist()
        cv2.rectangle(piece, (x0, y0), (x1, y1), (0, 0, 0), 4)
        cv2.rectangle(piece, (x0, y0), (x1, y1), look, 2)
        at = (x0, y0 - _LETTERS if look == _TRUTH else y1)
        _label(piece, name, at, look)
    return _packed(piece)


def _label(piece: Image, text: str, at: tuple[int, int], colour: tuple[int, int, int]) -> None:
    """A name on a ground of its own, moved so that it lies in the picture."""
    (width, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, _FONT, 1)
    rows, columns = piece.shape[:2]
    x = min(max(at[0], 0), max(columns - width - 6, 0))
    y = min(max(at[1], 0), rows - _LETTERS)
    cv2.rectangle(piece, (x, y), (x + width + 6, y + _LETTERS), colour, cv2.FILLED)
    place = (x + 3, y + _LETTERS - 5)
    cv2.putText(piece, text, place, cv2.FONT_HERSHEY_SIMPLEX, _FONT, (0, 0, 0), 1, cv2.LINE_AA)


def shrunk(image: Image, width_px: int) -> bytes:
    """A picture no wider than that."""
    scale = min(1.0, width_px / image.shape[1])
    small = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    return _packed(np.asarray(small, np.uint8))


def _packed(image: Image) -> bytes:
    """As JPEG; nothing where OpenCV cannot."""
    done, data = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    return data.tobytes() if done else b""
