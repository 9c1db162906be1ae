"""Ghosts: where somebody stood when the background was learnt."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import Subtraction
from tracking.geometry import Ellipses, FlatView
from tracking.trackers.spheroid.hypothesis_scores import bounds, silhouette

Picture = NDArray[np.uint8]

_STRONGER = 0.9
"""Edges of the background along an outline, over those of the picture: people seen at all are
below one half, ghosts above 1."""
_RING = np.ones((5, 5), np.uint8)
_FOREGROUND = 128
_FEWEST_PX = 30


def are_ghosts(
    flat: FlatView, outlines: Ellipses, ramp: Picture, seen: Subtraction
) -> NDArray[np.bool_]:
    """(people,) who is but a hole that somebody left in the background.

    Along a person's silhouette the picture has an edge and the background has none; along a
    ghost's it is the other way round.

    Args:
        outlines: (people) a little larger than their spheroids, flat px.
        ramp: (height, width) uint8, flat.
        seen: the picture beside its background, not undistorted.
    """
    corners = outlines.polygons(40)
    boxes = zip(*bounds(outlines, ramp.shape), strict=True)
    said = [
        _is_ghost(flat, ramp, (left, top, right, bottom), corners[k], seen)
        for k, (left, top, right, bottom) in enumerate(boxes)
    ]
    return np.array(said, bool)


def _is_ghost(
    flat: FlatView,
    ramp: Picture,
    box: tuple[int, int, int, int],
    outline: NDArray[np.float64],
    seen: Subtraction,
) -> bool:
    left, top, right, bottom = (int(side) for side in box)
    part = ramp[top:bottom, left:right]
    own = silhouette(part.shape, outline, left, top)
    own[part < _FOREGROUND] = 0
    if min(own.shape, default=0) < 5 or cv2.countNonZero(own) < _FEWEST_PX:
        return False
    v, u = np.nonzero(cv2.morphologyEx(own, cv2.MORPH_GRADIENT, _RING))
    recorded = flat.recorded_from_flat(np.column_stack((u + left, v + top)).astype(float))
    shrunk = np.rint((recorded + 0.5) / flat.shrink - 0.5).astype(np.intp)
    limit = np.array(seen.picture.shape[1::-1]) - 2
    u, v = np.clip(np.nan_to_num(shrunk), 1, limit).T.astype(np.intp)
    now, usual = (_edges(image, u, v) for image in (seen.picture, seen.background))
    return usual > _STRONGER * now


def _edges(picture: Picture, u: NDArray[np.intp], v: NDArray[np.intp]) -> float:
    """How steep the brightness is at pixels, on the mean."""
    light = picture[..., 1]
    down = light[v + 1, u].astype(np.float64) - light[v - 1, u]
    across = light[v, u + 1].astype(np.float64) - light[v, u - 1]
    return float((np.abs(down) + np.abs(across)).mean())
