"""Where people are and where their shadows may fall, as the flow tracker tells its perception."""

from __future__ import annotations

import cv2
import numpy as np

from tracking.arrays import Floats, Mask
from tracking.foreground import BodyMasks
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.half_resolution import half_size
from tracking.trackers.flow.silhouettes import spot_pixels
from tracking.trackers.flow.walkers import Walkers

_SURE_S = 0.7
"""Age from which on somebody who is seen is known for certain."""
_UPPER = np.array(((0.0, 1.65), (-0.1, 1.55), (-0.15, 1.35), (-0.13, 0.7), (0.13, 0.7)))
_UPPER = np.concatenate((_UPPER, ((0.15, 1.35), (0.1, 1.55))))
"""Outline of the body above the knees, m across the sight and over the floor: shadows lie below."""
_KEPT = np.array(((-0.15, 1.95), (-0.4, 1.5), (-0.4, -0.1), (0.4, -0.1), (0.4, 1.5), (0.15, 1.95)))
"""Outline that holds people generously."""
_NEAR_M, _FAR_M = 1.0, 1.8
"""Radii of the floor round somebody's feet: seen from above, a body lies before its own shadow
within the one, and what is which cannot be told; shadows fall within the other."""
_CIRCLE = np.stack([turn(np.arange(16) * np.pi / 8) for turn in (np.cos, np.sin)], axis=1)
_FARTHEST_PX = 1e4


def body_masks(walkers: Walkers, floor: Floor) -> BodyMasks:
    """The masks of the frame's people, at half resolution."""
    sure = walkers.select(walkers.walked & (walkers.age_s > _SURE_S) & (walkers.missed_s == 0.0))
    kept = _drawn(_upright(walkers.place, _KEPT, floor), floor)
    on = _drawn(_upright(sure.place, _UPPER, floor), floor)
    beside = _drawn(_on_floor(sure.place, _FAR_M, floor), floor)
    beside[kept > 0] = 0
    on[_drawn(_on_floor(sure.place, _NEAR_M, floor), floor) > 0] = 0
    return BodyMasks(on, beside, kept)


def _upright(place: Floats, outline: Floats, floor: Floor) -> Floats:
    """(k, j, 2) px of an outline (j, 2) that stands at places (k, 2) and faces the camera."""
    return spot_pixels(place, np.column_stack((outline, np.zeros(len(outline)))), floor)


def _on_floor(place: Floats, radius_m: float, floor: Floor) -> Floats:
    """(k, j, 2) px of circles on the floor."""
    return floor.pixels(place[:, None] + radius_m * _CIRCLE, np.zeros(len(_CIRCLE)))


def _drawn(outlines: Floats, floor: Floor) -> Mask:
    """(rows, columns) 255 within any of the outlines (k, j, 2) px, at half resolution."""
    columns, rows = half_size(floor.view.camera.size)
    mask = np.zeros((rows, columns), np.uint8)
    whole = (np.abs(outlines) < _FARTHEST_PX).all(axis=(1, 2))  # NaN: not
    for corners in np.rint(outlines[whole] / 2).astype(np.int32):
        cv2.fillConvexPoly(mask, cv2.convexHull(corners), 255)
    return mask
