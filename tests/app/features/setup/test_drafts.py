"""What is kept of a set-up, and for how long."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from app.features.setup.drafts import Drafts
from app.features.setup.scene import SetupState
from tracking.geometry import StereoCalibration, read_calibration
from tracking.setup import SetupPlan


@pytest.fixture
def calibration(tiny_recording: Path) -> StereoCalibration:
    return read_calibration([tiny_recording / "calibration.yaml"])


def test_a_calibration_outlives_begin_anew_until_nothing_can_be_undone(
    calibration: StereoCalibration, tmp_path: Path
) -> None:
    drafts, plan = Drafts(tmp_path / "drafts"), SetupPlan(Path("a.mp4"), Path("b.mp4"))
    made = drafts.keep_calibration(plan, calibration)
    drafts.save(SetupState(replace(plan, calibration=(made,))))
    drafts.forget(plan)
    assert drafts.find(plan) is None
    assert made.is_file()
    drafts.close()
    assert not made.exists()


def test_a_calibration_that_undo_named_again_stays(
    calibration: StereoCalibration, tmp_path: Path
) -> None:
    drafts, plan = Drafts(tmp_path / "drafts"), SetupPlan(Path("a.mp4"), Path("b.mp4"))
    made = drafts.keep_calibration(plan, calibration)
    drafts.forget(plan)
    drafts.save(SetupState(replace(plan, calibration=(made,))))
    drafts.close()
    assert made.is_file()
    drafts.forget(plan, for_good=True)
    assert not made.exists()
