"""Pictures that show a fault."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from tracking.arrays import Floats, Picture
from tracking.doctor.matches import Matches
from tracking.geometry import Ground, Rectification, StereoCalibration

_GOOD, _BAD, _LINE = (80, 200, 80), (60, 60, 230), (200, 170, 60)
"""BGR."""
_LEVEL_LINES = 12
_MOST_DRAWN = 150
_LONGER = 8.0
"""Arrows are drawn longer than what they show, which is a pixel or a few."""


def draw_rows(
    calibration: StereoCalibration,
    left: Picture,
    right: Picture,
    matches: Matches,
    residual_px: Floats,
) -> Picture:
    """The rectified pair side by side, level lines, and pairs red where they are off their row."""
    rectification = Rectification(calibration, None)
    pair = np.hstack(rectification.rectify(left, right))
    for row in np.linspace(0, pair.shape[0], _LEVEL_LINES + 2)[1:-1].astype(int):
        cv2.line(pair, (0, int(row)), (pair.shape[1], int(row)), _LINE, 1)
    first = rectification.rectified_from_recorded(matches.first)
    second = rectification.rectified_from_recorded(matches.second, right=True)
    second = second + np.array((left.shape[1], 0.0))
    for number in _spread(len(matches)):
        colour = _BAD if abs(residual_px[number]) > 1.0 else _GOOD
        for point in (first[number], second[number]):
            if np.isfinite(point).all():
                cv2.circle(pair, _whole(point), 3, colour, 1, cv2.LINE_AA)
    return pair


def draw_floor(
    calibration: StereoCalibration,
    ground: Ground,
    left: Picture,
    points: Floats,
    residual_px: Floats,
) -> Picture:
    """The metre grid of the floor as told, and where the cameras see it nearer or farther."""
    shown = left.copy()
    rotation, centre = ground.world_from_camera
    for line in _grid():
        pixels = calibration.left.project((line - centre) @ rotation)
        for a, b in pairwise(pixels):
            if np.isfinite((a, b)).all() and np.abs((a, b)).max() < _FAR_PX:
                cv2.line(shown, _whole(a), _whole(b), _LINE, 1, cv2.LINE_AA)
    for number in _spread(len(points)):
        off = residual_px[number]
        if np.isfinite(off):
            end = points[number] + (0.0, -_LONGER * off)
            colour = _BAD if abs(off) > 0.25 else _GOOD
            cv2.arrowedLine(shown, _whole(points[number]), _whole(end), colour, 1, cv2.LINE_AA)
    return shown


_FAR_PX = 1e4
_GRID_M = 12
"""Metres of floor drawn ahead, and to both sides half of it."""


def _grid() -> list[Floats]:
    along = np.arange(0.25, _GRID_M + 0.1, 0.25)
    side = np.arange(-_GRID_M / 2, _GRID_M / 2 + 0.1, 0.25)
    level = np.zeros
    ahead = [np.column_stack((level(len(along)) + x, along, level(len(along))))
             for x in range(-_GRID_M // 2, _GRID_M // 2 + 1)]  # fmt: skip
    across = [np.column_stack((side, level(len(side)) + y, level(len(side))))
              for y in range(1, _GRID_M + 1)]  # fmt: skip
    return ahead + across


def draw_moves(image: Picture, matches: Matches) -> Picture:
    """Where points of the scene were, and where they are."""
    shown = image.copy()
    for number in _spread(len(matches)):
        a, b = matches.first[number], matches.second[number]
        cv2.arrowedLine(shown, _whole(a), _whole(b), _BAD, 1, cv2.LINE_AA)
    return shown


def draw_pair(left: Picture, right: Picture, matches: Matches) -> Picture:
    """Both images side by side with lines between points of the scene."""
    pair = np.hstack((left, right))
    for number in _spread(len(matches))[::4]:
        end = matches.second[number] + (left.shape[1], 0)
        cv2.line(pair, _whole(matches.first[number]), _whole(end), _BAD, 1, cv2.LINE_AA)
    return pair


def _spread(count: int) -> list[int]:
    spread = np.linspace(0, count - 1, min(count, _MOST_DRAWN))
    return [int(number) for number in np.unique(spread.astype(int))]


def _whole(point: Floats) -> tuple[int, int]:
    return round(float(point[0])), round(float(point[1]))
