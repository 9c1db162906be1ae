"""Checks: cameras that changed places, and a camera that is late."""

from __future__ import annotations

import numpy as np

from tracking.doctor.drawings import draw_pair
from tracking.doctor.evidence import StillPair
from tracking.doctor.findings import Finding, Mend
from tracking.doctor.floor_cost import DISTANCE_M
from tracking.doctor.matches import Matches
from tracking.doctor.residuals import disparities
from tracking.geometry import StereoCalibration
from tracking.people.first_lag import first_lag
from tracking.recording import Recording
from tracking.translation import msg

SWAPPED, LAG = "cameras-swapped", "cameras-out-of-step"
_MOST = 0.8
"""Share of the points that must lie behind the cameras as told, and before them if swapped."""
_WALK_M_PER_S = 1.3
"""Of adults; what a late picture has moved by."""


def check_swapped(pair: StillPair, calibration: StereoCalibration) -> Finding | None:
    """The finding where the scene lies behind the cameras, and before them once they swap."""
    matches = pair.matches
    behind = _share_behind(calibration, matches)
    exchanged = _share_behind(calibration, Matches(matches.second, matches.first))
    if behind < _MOST or exchanged > 1 - _MOST:
        return None
    return Finding(
        SWAPPED,
        msg("the left and the right camera are swapped"),
        msg("exchange the sources of [left] and [right]"),
        {"behind": behind, "behind_if_swapped": exchanged, "matches": len(matches)},
        DISTANCE_M,
        picture=draw_pair(pair.left, pair.right, matches),
        mend=Mend(swapped=True),
    )


def _share_behind(calibration: StereoCalibration, matches: Matches) -> float:
    return float((disparities(calibration, matches)[1] <= 0).mean())


def check_lag(recording: Recording, calibration: StereoCalibration) -> Finding | None:
    """The finding where movement tells another lag than the manifest."""
    told = recording.right_lag or 0
    lag = first_lag(recording)
    if lag is None or lag == told:
        return None
    seconds = abs(lag - told) / recording.fps
    # Whoever walks across has moved on: that is taken for disparity.
    cost = DISTANCE_M * _WALK_M_PER_S * seconds / calibration.baseline_m
    return Finding(
        LAG,
        msg("the right camera is {lag} frames late, not {told}", lag=lag, told=told),
        msg("set lag = {lag} for the right camera in recording.toml", lag=lag),
        {"lag": lag, "told": told, "seconds": float(np.round(seconds, 4))},
        min(DISTANCE_M, cost),
        mend=Mend(lag=lag),
    )
