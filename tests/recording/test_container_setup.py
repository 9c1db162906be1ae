"""Bags and tars are set up as they say themselves what they hold."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from containers_of_scene import (
    Footage,
    footage_of_scene,
    write_euroc,
    write_kitti,
    write_mcap,
    write_oak,
    write_oak_tar,
    write_rosbag2_mcap,
    write_zed,
)

from app.features.setup import cameras_presenter, trial
from tracking.progress import no_progress
from tracking.recording import OpenOptions, open_recording
from tracking.setup import find_cameras, write_setup
from tracking.setup.plan import plan_of_container, plan_of_known


@pytest.fixture(scope="module")
def scene() -> Footage:
    return footage_of_scene()


@pytest.mark.parametrize("write", [write_mcap, write_oak_tar])
def test_a_container_becomes_a_recording_that_opens(
    write: object, tmp_path: Path, scene: Footage
) -> None:
    path = write(tmp_path, scene)  # type: ignore[operator]
    found = find_cameras(path, None)
    assert (found.left, found.right) == (path, path)
    plan = plan_of_container(path, OpenOptions(fps=10.0))
    written = write_setup(plan)
    with open_recording(written.parent) as opened, open_recording(path, OpenOptions()) as bare:
        assert opened.is_stereo
        assert opened.frame_count == bare.frame_count
        assert (opened.read(1).left == bare.read(1).left).all()


@pytest.mark.parametrize(
    "write", [write_euroc, write_kitti, write_oak, write_zed, write_rosbag2_mcap]
)
def test_a_known_folder_becomes_a_recording_that_opens_the_same(
    write: Callable[[Path, Footage], Path], tmp_path: Path, scene: Footage
) -> None:
    path = write(tmp_path, scene)
    with open_recording(path) as bare:
        seen, told = bare.read(1).left, (bare.frame_count, bare.is_stereo, bare.has_depth)
        focal = None if bare.calibration is None else bare.calibration.left.matrix[0, 0]
    plan = plan_of_known(path)
    assert plan is not None
    assert write_setup(plan) == path / "recording.toml"
    with open_recording(path) as opened:
        assert opened.own_manifest
        assert (opened.frame_count, opened.is_stereo, opened.has_depth) == told
        assert (opened.read(1).left == seen).all()
        if focal is not None:
            assert opened.calibration is not None
            assert opened.calibration.left.matrix[0, 0] == pytest.approx(focal)


def test_a_folder_whose_recording_toml_says_the_floor_alone_is_set_up_with_it(
    tmp_path: Path, scene: Footage
) -> None:
    drive = write_kitti(tmp_path, scene)
    (drive / "recording.toml").write_text("# mine\n[ground]\nheight = 2.5\ntilt = 31.0\n")
    plan = plan_of_known(drive)
    assert plan is not None
    assert plan.ground is not None
    write_setup(plan, replace_old=True)
    assert "# mine" in (drive / "recording.toml").read_text()
    with open_recording(drive) as opened:
        assert opened.own_manifest
        assert opened.ground is not None
        assert opened.ground.tilt_deg == 31.0


def test_the_window_keeps_what_a_container_says(tmp_path: Path, scene: Footage) -> None:
    tar = write_oak_tar(tmp_path, scene, depth=True)
    state = cameras_presenter.look(cameras_presenter.plan_of_paths([tar]), no_progress)
    assert state.plan is not None
    assert state.plan.depth == tar
    assert state.plan.calibration == (tar,)
    assert state.found == (f"{tar.name} holds one camera and depth.",)
    assert trial.check(state.plan).problem == ""


@pytest.mark.parametrize("write", [write_zed, write_rosbag2_mcap])
def test_the_window_takes_a_known_folder(
    write: Callable[[Path, Footage], Path], tmp_path: Path, scene: Footage
) -> None:
    path = write(tmp_path, scene)
    state = cameras_presenter.look(cameras_presenter.plan_of_paths([path]), no_progress)
    assert state.plan is not None
    checked = trial.check(state.plan)
    assert checked.problem == ""
    assert checked.places.endswith(f"{path / 'recording.toml'}")
