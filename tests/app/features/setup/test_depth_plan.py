"""Plans with depth open, before they are written, as the recording does that they will be."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from app.features.setup import cameras_presenter, floor_presenter, trial
from app.features.setup.drafts import Drafts
from app.features.setup.scene import SetupState
from tracking.geometry import Camera, StereoCalibration, write_calibration
from tracking.progress import no_progress
from tracking.recording import open_recording
from tracking.recording.recording import Recording
from tracking.setup import SetupPlan, plan_of, write_setup
from tracking.setup.plan import options_of_plan

_COUNT, _WIDTH, _HEIGHT = 3, 96, 72
_SCALE_M = 0.002


@pytest.fixture
def plan(tmp_path: Path) -> SetupPlan:
    """Camera and depth in folders of their own."""
    home = tmp_path / "hall"
    left, depth = home / "camera" / "left", home / "deep" / "images"
    for folder, shade in ((left, np.uint8(90)), (depth, np.uint16(2500))):
        folder.mkdir(parents=True)
        for number in range(_COUNT):
            image = np.full((_HEIGHT, _WIDTH), shade)
            cv2.imwrite(str(folder / f"{number:06d}.png"), image)
    matrix = np.array([[80.0, 0, _WIDTH / 2], [0, 80, _HEIGHT / 2], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), _WIDTH, _HEIGHT)
    write_calibration(home / "calibration.yaml", StereoCalibration.of_one(camera))
    return SetupPlan(
        left,
        depth=depth,
        depth_scale_m=_SCALE_M,
        fps=10.0,
        calibration=(home / "calibration.yaml",),
    )


def test_a_plan_with_depth_opens_with_it_and_is_written(plan: SetupPlan) -> None:
    assert plan.folder == plan.left.parents[1]
    assert trial.check(plan).problem == ""
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        depth = recording.read(0).depth
        assert depth is not None
        assert depth[0, 0] == pytest.approx(2500 * _SCALE_M)
    write_setup(plan)
    assert plan_of(plan.folder) == replace(plan, name="hall", at=plan.folder)


def test_depth_and_topics_are_kept_in_a_draft(plan: SetupPlan, tmp_path: Path) -> None:
    state = SetupState(replace(plan, topics=("/a", "/b", "/c")))
    drafts = Drafts(tmp_path / "drafts")
    drafts.save(state)
    assert state.plan is not None
    assert drafts.find(state.plan) == state


def test_topics_reach_the_recording(plan: SetupPlan) -> None:
    options = options_of_plan(replace(plan, topics=("/a", "", "/c")))
    with open_recording(plan.folder, options) as recording:
        assert 'topic = "/a"' in recording.manifest_text
        assert 'topic = "/c"' in recording.manifest_text


def test_the_floor_is_measured_by_depth(plan: SetupPlan, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[bool] = []

    def find(recording: Recording, _progress: object) -> object:
        seen.append(recording.has_depth)
        return object()

    monkeypatch.setattr(floor_presenter, "floor_by_stereo", find)
    floor_presenter.measured(SetupState(plan), no_progress)
    assert seen == [True]


def test_both_cameras_in_one_image_leave_depth_out(plan: SetupPlan) -> None:
    changed = cameras_presenter.with_arrangement(SetupState(plan), "side-by-side").plan
    assert changed is not None
    assert changed.depth is None
