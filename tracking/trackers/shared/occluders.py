"""What is drawn in the picture and hides people: the setting `occluders` of trackers."""

from __future__ import annotations

import json
from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import SettingsError
from tracking.tracks.labels import Occluder

_MOST_CORNERS = 100_000

Polygons = tuple[NDArray[np.float64], ...]
Mask = NDArray[np.uint8]


def occluders_from(text: str) -> Polygons:
    """The outlines of the setting `occluders`: each (corners, 2) px as recorded.

    Raises `SettingsError` for what is no list of polygons.
    """
    if not text.strip():
        return ()
    try:
        said = json.loads(text)
        polygons = [np.array(corners, np.float64) for corners in said]
        good = isinstance(said, list) and all(
            outline.ndim == 2
            and outline.shape[1] == 2
            and 3 <= len(outline) <= _MOST_CORNERS
            and bool(np.isfinite(outline).all())
            for outline in polygons
        )
    except (ValueError, TypeError, RecursionError):
        good = False
    if not good:
        raise SettingsError(
            "setting occluders: must be outlines of three corners or more, "
            "like [[[100, 40], [130, 40], [130, 300]]]"
        )
    return tuple(polygons)


def occluder_mask(polygons: Iterable[NDArray[np.float64]], shape: tuple[int, int]) -> Mask:
    """(height, width) 1 where something drawn stands before the scene, else 0.

    Args:
        polygons: (corners, 2) px each. shape: height and width of the picture.
    """
    mask = np.zeros(shape, np.uint8)
    for corners in polygons:
        cv2.fillPoly(mask, [np.rint(corners).astype(np.int32)], (1,))
    return mask


def occluders_as_setting(occluders: Iterable[Occluder]) -> str:
    """What people drew, as the setting `occluders` has it; "" where they drew nothing."""
    outlines = [[list(corner) for corner in one.polygon] for one in occluders]
    return json.dumps(outlines) if outlines else ""
