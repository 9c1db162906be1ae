"""How sharp a board is seen, however large it is in the image."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np

from tracking.calibration.boards.detection import BoardView, GrayImage

_AROUND_POINT = 0.4
"""Of the distance of neighbouring points: so far around one its edges count."""
_LEAST_PX = 2


def sharpness(image: GrayImage, view: BoardView) -> float:
    """How steep edges beside the points are, relative to their contrast, across or down.

    That is about 0.4 over the blur's standard deviation in px: lenses and motion blur by pixels,
    near boards as far ones. The lesser of the two directions counts: motion blurs in one, and
    leaves edges along it as sharp.
    """
    steep = [_steepness(part) for part in _parts(image, view) if min(part.shape) > _LEAST_PX]
    return float(np.median(steep, axis=0).min()) if steep else 0.0


def _parts(image: GrayImage, view: BoardView) -> Iterator[GrayImage]:
    """The image around each point, without the edges around the next one."""
    apart = np.hypot(*(view.pixel[:, None] - view.pixel[None]).transpose(2, 0, 1))
    np.fill_diagonal(apart, np.inf)
    half = max(int(_AROUND_POINT * float(np.median(apart.min(axis=0)))), _LEAST_PX)
    for u, v in view.pixel.round().astype(int).tolist():
        rows, columns = (slice(max(at - half, 0), max(at + half + 1, 0)) for at in (v, u))
        yield image[rows, columns]


def _steepness(part: GrayImage) -> tuple[float, float]:
    """The steepest change from pixel to pixel across and down, as a share of the contrast."""
    contrast = max(float(np.ptp(part)), 1.0)
    across, down = (
        float(np.abs(cv2.Sobel(part, cv2.CV_32F, *way, ksize=1)).max()) / 2.0 / contrast
        for way in ((1, 0), (0, 1))
    )
    return across, down
