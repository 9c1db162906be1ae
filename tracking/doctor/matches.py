"""Points of the scene that both cameras, or one camera at two times, show."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats, Picture

MOST_FEATURES = 4000
_CONTRAST = 0.01
"""SIFT's threshold: floors are faint."""
_WINDOW_PX = 15
"""Side of the patch that is aligned below a pixel."""
_MOST_MOVED_PX = 3.0
"""Alignment that goes farther from the feature's place has followed something else."""
_ROUND_TRIP_PX = 0.2
"""Aligned there and back, a point must come home."""


@dataclass(frozen=True, slots=True, eq=False)
class Matches:
    """Pixels (n, 2) of the same points in two images, as recorded."""

    first: Floats
    second: Floats

    def __len__(self) -> int:
        return len(self.first)

    def only(self, kept: NDArray[np.bool_]) -> Matches:
        """Those that are kept."""
        return Matches(self.first[kept], self.second[kept])


def match_points(first: Picture, second: Picture, most: int = MOST_FEATURES) -> Matches:
    """Match two images of a still scene, below a pixel.

    Features that are each other's nearest (SIFT, [Lowe2004]) say where to look; alignment of the
    patches ([Lucas1981]) says where exactly. Outliers are left in: see `consistent`.
    """
    grey = [
        np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), np.uint8) for image in (first, second)
    ]
    sift = cv2.SIFT.create(most, contrastThreshold=_CONTRAST)
    (points_a, features_a), (points_b, features_b) = (
        sift.detectAndCompute(image, None) for image in grey
    )
    none = np.empty((0, 2))
    if not points_a or not points_b:
        return Matches(none, none)
    pairs = cv2.BFMatcher(crossCheck=True).match(features_a, features_b)
    if not pairs:
        return Matches(none, none)
    a = np.array([points_a[pair.queryIdx].pt for pair in pairs], np.float32)
    b = np.array([points_b[pair.trainIdx].pt for pair in pairs], np.float32)
    found, there = _aligned(grey[0], grey[1], a, b)
    back, home = _aligned(grey[1], grey[0], found, a)
    kept = (
        there
        & home
        & (np.hypot(*(found - b).T) < _MOST_MOVED_PX)
        & (np.hypot(*(back - a).T) < _ROUND_TRIP_PX)
    )
    _, once = np.unique(a.round(), axis=0, return_index=True)
    kept &= np.isin(np.arange(len(a)), once)
    return Matches(a[kept].astype(float), found[kept].astype(float))


def _aligned(
    first: Picture, second: Picture, points: NDArray[np.float32], guess: NDArray[np.float32]
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    found, status, _ = cv2.calcOpticalFlowPyrLK(
        first, second, points, guess.copy(), winSize=(_WINDOW_PX, _WINDOW_PX), maxLevel=0,
        flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
    )  # fmt: skip
    return np.asarray(found, np.float32), np.asarray(status).ravel() > 0


def consistent(matches: Matches) -> Matches:
    """Those that one pair of rigid views explains: outliers of the fundamental matrix removed."""
    if len(matches) < _FEWEST:
        return matches
    _, inside = cv2.findFundamentalMat(
        matches.first, matches.second, cv2.USAC_MAGSAC, _OUTLIER_PX, _SURE, _MOST_ROUNDS
    )
    kept = np.atleast_1d(np.asarray(inside, object)).ravel()
    return matches.only(kept.astype(float) > 0) if len(kept) == len(matches) else matches


_FEWEST = 30
"""Matches below which nothing is told."""
_OUTLIER_PX = 0.7
_SURE = 0.999
_MOST_ROUNDS = 2000
"""Of the robust estimate: more take seconds."""
