"""What the doctor takes for the floor where the one that is given is not seen."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.calibration.rendered_boards import CAMERA, pair_of
from tracking.calibration.floor import floor_by_stereo, stereo
from tracking.calibration.floor.empty_scene import EmptyScene
from tracking.calibration.floor.estimate import FloorEstimate
from tracking.doctor import floor_check
from tracking.errors import CalibrationError
from tracking.geometry import Ground, Rectification
from tracking.translation import msg

GIVEN = Ground(2.4, 15.0)
FOUND = FloorEstimate(Ground(3.6, 15.5), "stereo", 0.2, 0.3, 0.3, ())


def recording(ground: Ground | None = GIVEN) -> Any:
    """Two calibrated cameras, and what their manifest says of the floor."""
    return SimpleNamespace(
        calibration=pair_of(CAMERA), ground=ground, is_stereo=True, has_depth=False, path="hall"
    )


def disparities(rectification: Rectification, up: np.ndarray, away_m: float) -> np.ndarray:
    """(height, width) of a plane with this normal in the left camera's axes, so far away."""
    width, height = rectification.size
    axes = rectification.recorded_axes(np.eye(3))
    normal = -(axes.T @ up)
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    cx, cy = rectification.principal
    rays = np.stack(((u - cx), (v - cy), np.full(u.shape, rectification.focal_px)), axis=-1)
    share = rays @ normal
    found = rectification.baseline_m / away_m * share + rectification.disparity_offset_px
    return np.where(share > 0, found, np.nan)


def test_a_wall_before_the_camera_is_no_floor(monkeypatch: pytest.MonkeyPatch) -> None:
    tilt = np.deg2rad(15.0)
    towards = np.array([0.0, np.sin(tilt), -np.cos(tilt)])
    rectification = Rectification(pair_of(CAMERA), None)
    wall = disparities(rectification, towards, 8.0).astype(np.float32)
    monkeypatch.setattr(stereo, "empty_scene", lambda *_: EmptyScene(wall, wall, wall))
    with pytest.raises(CalibrationError, match="no plane below"):
        floor_by_stereo(recording())


def test_a_floor_at_another_height_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(floor_check, "floor_by_stereo", lambda *_: FOUND)
    finding, why = floor_check.check_other_floor(recording())
    assert finding is not None
    assert why is None


@pytest.mark.parametrize(
    "found",
    [
        replace(FOUND, ground=Ground(8.0, 75.1, 179.8)),
        replace(FOUND, ground=Ground(8.0, 40.0)),
        replace(FOUND, notes=(msg("only {share:.0%} of it", share=0.1),)),
        replace(FOUND, height_sigma_m=20.0, tilt_sigma_deg=2.0),
    ],
    ids=["wall", "slope", "doubtful", "unsure"],
)
def test_what_may_be_no_floor_is_not_offered(
    found: FloorEstimate, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(floor_check, "floor_by_stereo", lambda *_: found)
    finding, why = floor_check.check_other_floor(recording())
    assert finding is None
    assert "too few points" in str(why)


def test_the_search_for_a_floor_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[int, int]] = []

    def found(_: Any, tell: Any) -> FloorEstimate:
        tell(5, 15)
        return FOUND

    monkeypatch.setattr(floor_check, "floor_by_stereo", found)
    floor_check.check_other_floor(recording(), lambda *step: told.append(step))
    floor_check.check_depth_floor(recording(), lambda *step: told.append(step))
    assert told == [(5, 15)] * 2
