"""Places on the floor where somebody may stand, as the camera sees them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, standing_ellipses
from tracking.trackers.spheroid.feet import Feet, feet_of
from tracking.trackers.spheroid.view_model import Flags, steep_places

Floats = NDArray[np.float64]

_ACROSS_M = 0.22
"""Distance between places side by side."""
_ALONG = 0.11
"""Distance between places behind each other, in body heights as they are seen."""
_LEAST_TALL_PX = 42.0
"""Smaller people are not looked for: their legs are as wide as what smooths the picture."""
_FARTHEST_M = 120.0
_LEAST_INSIDE = 0.3
_MOST = 20_000


class FloorCells:
    """A net of places over the floor in view, finer nearby, and the spheroids that stand there.

    Args:
        flat: the camera. height_m, radius_m: of a usual body.

    Attributes:
        xy: (cells, 2) m. step_m: (cells,) to the next one behind each.
        outlines: (cells) in flat px. area: (cells,) px² of them. inside: (cells,) px² of that,
            about, in the picture.
        feet: (cells) of the people there. steep: (cells,) who is there is seen steeply.
    """

    def __init__(self, flat: FlatView, height_m: float, radius_m: float) -> None:
        xy, step_m = _net(flat, height_m)
        outlines = standing_ellipses(flat.projection, xy, np.full(len(xy), height_m), radius_m)
        kept, share = _worth_looking(outlines, flat.size)
        self.xy: Floats = xy[kept]
        self.step_m: Floats = step_m[kept]
        self.outlines: Ellipses = outlines[kept]
        self.area: Floats = self.outlines.areas()
        self.inside: Floats = self.area * share
        self.feet: Feet = feet_of(flat, self.xy)
        self.steep: Flags = steep_places(self.xy, flat)

    def __len__(self) -> int:
        """The number of places."""
        return len(self.xy)


def _net(flat: FlatView, height_m: float) -> tuple[Floats, Floats]:
    """(n, 2) m, rings round the point below the camera, and (n,) m to the next ring."""
    camera_m = float(flat.camera_position[2])
    reach = [0.0]
    focal_px = float(np.linalg.norm(np.cross(flat.projection[0, :3], flat.projection[2, :3])))
    farthest = min(_FARTHEST_M, focal_px * height_m / _LEAST_TALL_PX)
    while reach[-1] < farthest:
        reach.append(reach[-1] + max(_ACROSS_M, _ALONG * height_m * reach[-1] / camera_m))
    bearing = _bearings(flat)
    rings, steps = [], []
    for radius, step in zip(reach, np.diff(reach, append=reach[-1] + _ACROSS_M), strict=True):
        count = max(1, int(np.ceil((bearing[1] - bearing[0]) * radius / _ACROSS_M)))
        angle = bearing[0] + (np.arange(count) + 0.5) / count * (bearing[1] - bearing[0])
        rings.append(np.column_stack((radius * np.sin(angle), radius * np.cos(angle))))
        steps.append(np.full(count, step))
    return np.concatenate(rings), np.concatenate(steps)


def _bearings(flat: FlatView) -> tuple[float, float]:
    """The horizontal directions in view, radians from forward to the right."""
    floor = flat.view.field_of_view(_FARTHEST_M)
    angle = np.arctan2(floor[:, 0], floor[:, 1])
    around = np.isfinite(angle).all() and (np.abs(angle).max() < np.pi / 2)
    spare = 0.1
    return (angle.min() - spare, angle.max() + spare) if around else (-np.pi, np.pi)


def _worth_looking(outlines: Ellipses, size: tuple[int, int]) -> tuple[NDArray[np.intp], Floats]:
    """Numbers of those large enough and sufficiently in the picture, and by what share."""
    top, bottom = outlines.rows()
    left, right = outlines.columns()
    wide = np.minimum(right, size[0]) - np.maximum(left, 0)
    tall = np.minimum(bottom, size[1]) - np.maximum(top, 0)
    inside = np.maximum(wide, 0) * np.maximum(tall, 0) / ((right - left) * (bottom - top))
    large = np.maximum(tall, wide) >= _LEAST_TALL_PX
    good = np.flatnonzero(np.isfinite(inside) & (inside >= _LEAST_INSIDE) & large)
    if len(good) <= _MOST:
        return good, inside[good]
    nearest = np.argsort(-(bottom - top)[good], kind="stable")[:_MOST]
    kept = np.sort(good[nearest])
    return kept, inside[kept]
