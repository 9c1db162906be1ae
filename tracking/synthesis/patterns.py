"""Patterns of cloth, skin and stone as images of brightness or colour."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s

Colour = NDArray[np.float64]


def noise(shape: tuple[int, int], cell: tuple[float, float], rng: np.random.Generator) -> Float32s:
    """Smooth noise (height, width) of mean 0 and deviation 1, with blobs of `cell` (rows, columns).

    The columns wrap round, so that it can be laid round a body without a seam.
    """
    rows = max(int(np.ceil(shape[0] / cell[0])) + 3, 4)
    columns = max(round(shape[1] / cell[1]), 2)
    coarse = rng.standard_normal((rows, columns)).astype(np.float32)
    coarse = np.concatenate((coarse[:, -2:], coarse, coarse[:, :2]), axis=1)
    zoom = shape[1] / columns
    size = (round(coarse.shape[1] * zoom), round(rows * cell[0]))
    fine = cv2.resize(coarse, size, interpolation=cv2.INTER_CUBIC)
    top, left = int(cell[0]), int(2 * zoom)
    fine = fine[top : top + shape[0], left : left + shape[1]]
    return np.asarray((fine - fine.mean()) / max(float(fine.std()), 1e-6), np.float32)


def folds(shape: tuple[int, int], strength: float, rng: np.random.Generator) -> Float32s:
    """Brightness (height, width) of hanging cloth: long upright folds and finer creases."""
    height, width = shape
    upright = noise(shape, (height / 1.6, width / 11), rng)
    slanting = noise(shape, (height / 5, width / 6), rng)
    weave = noise(shape, (1.5, 1.5), rng)
    relief = 0.6 * upright + 0.55 * slanting
    return np.asarray(np.clip(1.0 + strength * relief + 0.03 * weave, 0.45, 1.45), np.float32)


def plain(shape: tuple[int, int], colour: Colour) -> Float32s:
    """One colour all over, (height, width, 3)."""
    return np.broadcast_to(colour, (*shape, 3)).astype(np.float32)


def stripes(position: Float32s, period: float, share: float, one: Colour, two: Colour) -> Float32s:
    """Two colours in turns along a coordinate image."""
    second = (position / period % 1.0) < share
    return np.where(second[..., None], two, one).astype(np.float32)


def plaid(across: Float32s, down: Float32s, period: float, base: Colour, line: Colour) -> Float32s:
    """Crossing translucent bands and thin lines, as on flannel shirts."""
    band = ((across / period % 1.0) < 0.45).astype(np.float32)
    band = band * 0.5 + ((down / period % 1.0) < 0.45) * 0.5
    thin = ((across / period + 0.28) % 1.0 < 0.07) | ((down / period + 0.28) % 1.0 < 0.07)
    mixed = base + (line - base) * band[..., None]
    light = np.clip(base * 0.3 + 0.6, 0, 1)
    return np.where(thin[..., None], light, mixed).astype(np.float32)


def checks(across: Float32s, down: Float32s, period: float, one: Colour, two: Colour) -> Float32s:
    """A chequered pattern."""
    odd = (np.floor(across / period) + np.floor(down / period)) % 2 > 0
    return np.where(odd[..., None], two, one).astype(np.float32)
