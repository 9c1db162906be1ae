"""Places on the floor in the pictures of both cameras."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.core.projection.trails import floor_points, foot_points
from app.core.scenes import Side
from tracking.recording import Recording
from tracking.tracks import Columns

Floats = NDArray[np.float64]

_STEP_M = 0.1


def project_floor(recording: Recording, side: Side, floor: Floats) -> Floats:
    """Pixels (n, 2) of floor points (n, 2) in metres; NaN where they are not seen."""
    points = np.column_stack((floor, np.zeros(len(floor))))
    if not len(points):
        return np.zeros((0, 2))
    if side is not Side.RIGHT:
        view = recording.view
        return view.pixel_from_world(points) if view is not None else _nowhere(points)
    rectification = recording.rectification
    if rectification is None or recording.ground is None:
        return _nowhere(points)
    return rectification.right_pixel_from_world(points)


def left_foot_points(recording: Recording, rows: Columns) -> Floats:
    """Where the people of the rows stand, (n, 2) px: by the floor, else by their boxes."""
    boxes = foot_points(rows)
    if recording.view is None:
        return boxes
    floor = project_floor(recording, Side.LEFT, floor_points(rows))
    return np.where(np.isfinite(floor), floor, boxes)


def project_outline(recording: Recording, side: Side, corners: Floats) -> Floats:
    """The pixels of a line through floor points, which bends with the lens.

    NaN rows stand where it leaves the surroundings of the picture.
    """
    pixels = project_floor(recording, side, _dense(corners))
    reach = 4 * max(recording.size)
    with np.errstate(invalid="ignore"):
        near = np.asarray((np.abs(pixels) < reach).all(axis=1))
    return np.where(near[:, None], pixels, np.nan)


def _dense(corners: Floats) -> Floats:
    """The same line with a point every few centimetres."""
    parts = [corners[:1]]
    for start, end in pairwise(corners):
        count = min(max(1, int(np.ceil(np.hypot(*(end - start)) / _STEP_M))), 1000)
        share = np.arange(1, count + 1)[:, None] / count
        parts.append(start + share * (end - start))
    return np.concatenate(parts)


def _nowhere(points: Floats) -> Floats:
    return np.full((len(points), 2), np.nan)
