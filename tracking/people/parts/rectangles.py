"""Inner rectangles: the part of a body section that holds its bulk."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.tracks import HIP_LEG

Mask = NDArray[np.uint8] | NDArray[np.bool_]

_LEAST_SIZE_PX = 2.0


def inner_rectangle(mask: Mask, box: Floats) -> Floats:
    """(4,) cx, cy, width, height in px of the inner rectangle of the foreground in a box.

    [ZhaoLee2009] section 4.1: the centre is the foreground's mass centre, half the size its
    standard deviations across and down.

    Args:
        mask: (height, width) non-zero where foreground is.
        box: (4,) left, top, width, height in px; it may reach out of the picture.

    Returns:
        NaN where the box shows no foreground.
    """
    left, top, width, height = (float(value) for value in box)
    u0, u1 = np.clip(np.ceil((left, left + width)), 0, mask.shape[1]).astype(int)
    v0, v1 = np.clip(np.ceil((top, top + height)), 0, mask.shape[0]).astype(int)
    own = mask[v0:v1, u0:u1] > 0
    across, down = own.sum(axis=0, dtype=np.float64), own.sum(axis=1, dtype=np.float64)
    if not across.any():
        return np.full(4, np.nan)
    cx, spread_x = _moments(across)
    cy, spread_y = _moments(down)
    size = np.maximum(2 * np.array((spread_x, spread_y)), _LEAST_SIZE_PX)
    return np.array((u0 + cx, v0 + cy, *size))


def inner_rectangles(mask: Mask, box: Floats, lines: Floats) -> Floats:
    """(3, 4) inner rectangles of head, torso and hip-leg; NaN rows where nothing is seen.

    [ZhaoLee2009] section 4.1; the hip-leg's rectangle has half the section's height, because
    lower legs look different at every step. It takes the upper half, where the thighs are.

    Args:
        mask: (height, width) non-zero where the person is seen.
        box: (4,) left, top, width, height in px of the whole person.
        lines: (2,) rows of `decompose`.
    """
    left, top, width, height = (float(value) for value in box)
    hip_leg = (top + height - lines[1]) / 2
    edges = (top, lines[0], lines[1], lines[1] + hip_leg)
    sections = [(left, edges[k], width, edges[k + 1] - edges[k]) for k in range(3)]
    found = np.stack([inner_rectangle(mask, np.array(section)) for section in sections])
    if np.isfinite(found[HIP_LEG, 3]):
        found[HIP_LEG, 3] = max(hip_leg, _LEAST_SIZE_PX)
    return found


def _moments(counts: Floats) -> tuple[float, float]:
    """Mean and standard deviation of places that count so often."""
    places = np.arange(len(counts))
    total = counts.sum()
    mean = float(counts @ places / total)
    return mean, float(np.sqrt(counts @ (places - mean) ** 2 / total))
