"""Thousands of particles drawn as one small image."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPainter

_FAINTEST = 0.2


def darkened(colours: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Colours (n, 3) for dots on a light ground, the palest darkened most."""
    lightness = colours.max(axis=1, keepdims=True).astype(np.float32) / 255
    return np.asarray(colours * (1.0 - 0.3 * lightness), np.uint8)


def draw_particles(
    painter: QPainter,
    points: NDArray[np.float64],
    colours: NDArray[np.uint8],
    weights: NDArray[np.float32],
    size: tuple[int, int],
    radius_px: float,
    pixel_ratio: float = 1.0,
) -> None:
    """Draw particles as soft dots, light ones faint, heavy ones bright and on top.

    Args:
        painter: of the area's top left corner, in logical pixels.
        points: (n, 2) in device pixels of an area of `size` (width, height).
        colours: (n, 3) red, green, blue.
        weights: (n,) 0..1, relative to the person's heaviest.
        size: of the area; particles outside are left out.
        radius_px: of a dot, in device pixels.
        pixel_ratio: device pixels per logical pixel.
    """
    reach = int(np.ceil(radius_px))
    inside = ((points >= -reach) & (points < np.add(size, reach))).all(axis=1)
    if not inside.any():
        return
    levels = (255 * np.clip(weights[inside], 0, 1)).astype(np.uint8)
    order = np.flatnonzero(inside)[np.argsort(levels, kind="stable")]  # bytes sort ten times faster
    at = np.rint(points[order]).astype(np.int64)
    left, top = (at.min(axis=0) - reach).tolist()
    width, height = (at.max(axis=0) - (left, top) + reach + 1).tolist()
    pixels = _stamped(at - (left, top), colours[order], weights[order], (width, height), radius_px)
    image = QImage(pixels.data, width, height, QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(pixel_ratio)
    painter.drawImage(QPointF(left / pixel_ratio, top / pixel_ratio), image)


def _stamped(
    at: NDArray[np.int64],
    colours: NDArray[np.uint8],
    weights: NDArray[np.float32],
    size: tuple[int, int],
    radius_px: float,
) -> NDArray[np.uint32]:
    """Premultiplied ARGB (height * width,) with a soft dot at each place; later ones on top."""
    width, height = size
    pixels = np.zeros(height * width, np.uint32)
    place = at[:, 1] * width + at[:, 0]
    alpha = _FAINTEST + (1 - _FAINTEST) * np.clip(weights, 0, 1)
    rgb = colours.astype(np.float32)
    for coverage, columns, rows in soft_dot(radius_px):
        ink = _premultiplied(rgb, alpha * coverage)
        for offset in (rows * width + columns).tolist():
            pixels[place + offset] = ink
    return pixels


def soft_dot(radius_px: float) -> list[tuple[float, NDArray[np.int64], NDArray[np.int64]]]:
    """A disc's pixels by how much of each it covers (0..1): columns and rows, faintest first."""
    reach = int(np.ceil(radius_px))
    rows, columns = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    covered = np.clip(radius_px + 0.5 - np.hypot(rows, columns), 0.0, 1.0).round(2)
    levels = [float(level) for level in np.unique(covered) if level > 0.1]
    return [(level, columns[covered == level], rows[covered == level]) for level in levels]


def _premultiplied(rgb: NDArray[np.float32], alpha: NDArray[np.float32]) -> NDArray[np.uint32]:
    red, green, blue = (rgb * alpha[:, None]).astype(np.uint32).T
    packed = ((alpha * 255).astype(np.uint32) << 24) | (red << 16) | (green << 8) | blue
    return np.asarray(packed, np.uint32)
