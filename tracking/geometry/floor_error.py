"""How well places on the floor are known by where feet are seen."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Mask
from tracking.geometry.view import View

FOOT_ERROR_PX = 2.0
"""By which feet are usually seen too high or too low."""
LARGE_ERROR_M = 0.5
"""A place so far off is hardly one: people stand closer to each other."""
_STEP_PX = 8


def distance_of_large_errors(view: View, looked_at: Mask | None = None) -> float | None:
    """How far from the camera's foot point, in m, `FOOT_ERROR_PX` become `LARGE_ERROR_M`.

    Args:
        looked_at: (height, width) non-zero where people are looked for; None: everywhere.

    Returns:
        The least such distance in the picture; None where no floor so far away is seen.
    """
    columns = np.arange(_STEP_PX // 2, view.camera.width, _STEP_PX)
    rows = np.arange(_STEP_PX // 2, view.camera.height, _STEP_PX)
    pixel = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
    if looked_at is not None:
        pixel = pixel[looked_at[pixel[:, 1], pixel[:, 0]] > 0]
    here = view.floor_from_pixel(pixel.astype(float))
    higher = view.floor_from_pixel(pixel.astype(float) - np.array((0.0, FOOT_ERROR_PX)))
    seen = np.isfinite(here).all(axis=1)
    error_m = np.hypot(*(higher - here)[seen].T)
    bad = ~(error_m <= LARGE_ERROR_M)  # not finite: at the horizon
    distance_m = np.hypot(*here[seen][bad].T)
    return float(distance_m.min()) if len(distance_m) else None
