"""What is drawn into pictures of footage."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Colour = tuple[int, int, int]

WHITE = (255, 255, 255)


def write(image: Picture, text: str, place: tuple[int, int], colour: Colour = WHITE) -> None:
    """Text on a dark plate; its left bottom corner is at `place`, px."""
    font, size = cv2.FONT_HERSHEY_SIMPLEX, 0.5
    (width, height), below = cv2.getTextSize(text, font, size, 1)
    left, bottom = place
    low, high = (left - 2, bottom - height - 2), (left + width + 1, bottom + below)
    cv2.rectangle(image, low, high, (0, 0, 0), -1)
    cv2.putText(image, text, place, font, size, colour, 1, cv2.LINE_AA)
