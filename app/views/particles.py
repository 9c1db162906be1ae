"""Thousands of particles as one small image."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

_FAINTEST = 0.16


def stamp(radius_px: float) -> list[tuple[int, int, float]]:
    """A soft dot: column, row and coverage (0..1) of its pixels, the faintest first."""
    reach = int(np.ceil(radius_px))
    rows, columns = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    coverage = np.clip(radius_px + 0.5 - np.hypot(rows, columns), 0.0, 1.0)
    dots = zip(columns.ravel(), rows.ravel(), coverage.ravel(), strict=True)
    inked = [(int(column), int(row), float(share)) for column, row, share in dots if share > 0.1]
    return sorted(inked, key=lambda dot: dot[2])


def particle_image(
    points: NDArray[np.float64],
    colours: NDArray[np.uint8],
    weights: NDArray[np.float32],
    size: tuple[int, int],
    radius_px: float = 1.6,
) -> tuple[QImage, int, int]:
    """Draw particles as soft dots, light ones faint, heavy ones bright and on top.

    Args:
        points: (n, 2) in device pixels of an area of `size` (width, height).
        colours: (n, 3) red, green, blue.
        weights: (n,) 0..1, relative to the person's heaviest.
        size: of the area; particles outside are left out.
        radius_px: of a dot, in device pixels.

    Returns:
        The image (premultiplied ARGB) of the part that has particles, and its left and top.
    """
    reach = int(np.ceil(radius_px))
    inside = ((points >= -reach) & (points < np.add(size, reach))).all(axis=1)
    if not inside.any():
        return QImage(), 0, 0
    order = np.argsort(weights[inside], kind="stable")
    at = np.rint(points[inside][order]).astype(np.int64)
    left, top = (at.min(axis=0) - reach).tolist()
    width, height = (at.max(axis=0) - (left, top) + reach + 1).tolist()
    image = np.zeros(height * width, np.uint32)
    place = (at[:, 1] - top) * width + (at[:, 0] - left)
    alpha = _FAINTEST + (1 - _FAINTEST) * np.clip(weights[inside][order], 0, 1)
    rgb = colours[inside][order].astype(np.float32)
    for column, row, coverage in stamp(radius_px):
        image[place + (row * width + column)] = _premultiplied(rgb, alpha * coverage)
    shared = QImage(image.data, width, height, 4 * width, QImage.Format.Format_ARGB32_Premultiplied)
    return shared.copy(), left, top


def _premultiplied(rgb: NDArray[np.float32], alpha: NDArray[np.float32]) -> NDArray[np.uint32]:
    parts = (rgb * alpha[:, None]).astype(np.uint32)
    opacity = (alpha * 255).astype(np.uint32)
    red, green, blue = parts.T
    packed = (opacity << 24) | (red << 16) | (green << 8) | blue
    return np.asarray(packed, np.uint32)
