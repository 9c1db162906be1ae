"""Faults in a rendered recording are named, and mended in its files."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.doctor import Examination, Finding, examine, mend, mend_undoably, undo_mend
from tracking.errors import RecordingError
from tracking.geometry import StereoCalibration, read_calibration, write_calibration
from tracking.recording import Manifest, open_recording, read_manifest, write_manifest
from tracking.synthesis import SCENES, render_recording

SECONDS = 3.0


@pytest.fixture(scope="module")
def lobby(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("doctor") / "lobby"
    render_recording(folder, SCENES["lobby"], SECONDS, 3, 11)
    return folder


@pytest.fixture
def copied(lobby: Path, tmp_path: Path) -> Path:
    for file in lobby.iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    return tmp_path


def calibration_of(folder: Path) -> StereoCalibration:
    return read_calibration((folder / read_manifest(folder).calibration[0],))


def rewrite(folder: Path, calibration: StereoCalibration) -> None:
    write_calibration(folder / read_manifest(folder).calibration[0], calibration)


def rewrite_manifest(folder: Path, **changes: object) -> Manifest:
    manifest = replace(read_manifest(folder), **changes)
    write_manifest(folder, manifest)
    return manifest


def examined(folder: Path) -> Examination:
    with open_recording(folder) as recording:
        return examine(recording)


def mended(folder: Path) -> None:
    """The dearest finding put right."""
    with open_recording(folder) as recording:
        mend(recording, examine(recording).findings[0])


def codes(folder: Path) -> list[str]:
    return [finding.code for finding in examined(folder).findings]


def turn_right(folder: Path, axis: int, degrees: float) -> StereoCalibration:
    rig, vector = calibration_of(folder), np.zeros(3)
    vector[axis] = math.radians(degrees)
    turn = cv2.Rodrigues(vector)[0]
    rewrite(folder, replace(rig, rotation=turn @ rig.rotation, translation=turn @ rig.translation))
    return rig


def test_nothing_is_said_of_a_sound_recording(lobby: Path) -> None:
    examination = examined(lobby)
    assert not examination.findings
    assert not examination.unchecked


@pytest.mark.parametrize("times", [0.1, 0.17, 0.33, 0.5, 2.0, 3.0, 6.0, 10.0])
def test_a_height_in_other_units_is_told_with_the_floor_that_is_seen(
    copied: Path, times: float
) -> None:
    truth = read_manifest(copied).ground
    assert truth is not None
    rewrite_manifest(copied, ground=replace(truth, height_m=truth.height_m * times))
    examination = examined(copied)
    (finding,) = examination.findings
    assert finding.code == "other-floor"
    assert "floor" in examination.checked
    with open_recording(copied) as recording:
        mend(recording, finding)
    mended_ground = read_manifest(copied).ground
    assert mended_ground is not None
    assert mended_ground.height_m == pytest.approx(truth.height_m, rel=0.02)
    assert mended_ground.tilt_deg == pytest.approx(truth.tilt_deg, abs=0.5)


AXES = list(enumerate(("right-tilted", "right-turned", "right-rolled")))


@pytest.mark.parametrize(("axis", "code"), AXES)
def test_a_turned_right_camera_is_named_by_its_axis(copied: Path, axis: int, code: str) -> None:
    turn_right(copied, axis, 0.5)
    assert codes(copied) == [code]


def test_a_mend_brings_back_the_rotation_within_a_fiftieth_of_a_degree(copied: Path) -> None:
    rig = turn_right(copied, 0, 0.5)
    mended(copied)
    left = calibration_of(copied).rotation @ rig.rotation.T
    assert np.rad2deg(np.linalg.norm(cv2.Rodrigues(left)[0])) < 0.02


def test_a_mended_file_is_kept_as_it_was(copied: Path) -> None:
    turn_right(copied, 2, 0.5)
    before = (copied / "calibration.yaml").read_bytes()
    mended(copied)
    assert (copied / "calibration.yaml.bak").read_bytes() == before


def test_a_wrong_height_is_named_and_mended(copied: Path) -> None:
    ground = read_manifest(copied).ground
    assert ground is not None
    rewrite_manifest(copied, ground=replace(ground, height_m=ground.height_m * 1.1))
    assert codes(copied) == ["scale"]
    mended(copied)
    found = read_manifest(copied).ground
    assert found is not None
    assert found.height_m == pytest.approx(ground.height_m, rel=0.01)


def test_a_mended_floor_leaves_comments_in_the_manifest(copied: Path) -> None:
    path = copied / "recording.toml"
    told = path.read_text(encoding="utf-8") + "# hung by Ada\n"
    ground = read_manifest(copied).ground
    assert ground is not None
    high = told.replace(f"height = {ground.height_m}", f"height = {ground.height_m * 1.2}")
    path.write_text(high, encoding="utf-8")
    mended(copied)
    assert "# hung by Ada" in path.read_text(encoding="utf-8")
    assert (copied / "recording.toml.bak").read_text(encoding="utf-8") == high


def test_a_wrong_tilt_costs_metres_and_is_named(copied: Path) -> None:
    ground = read_manifest(copied).ground
    assert ground is not None
    rewrite_manifest(copied, ground=replace(ground, tilt_deg=ground.tilt_deg + 3))
    (finding,) = examined(copied).findings
    assert finding.code == "ground-tilt"
    assert 0.05 < finding.cost_m < 1.0
    assert finding.picture is not None


def test_swapped_cameras_are_named_and_mended(copied: Path) -> None:
    manifest = read_manifest(copied)
    assert manifest.right is not None
    rewrite_manifest(copied, left=manifest.right, right=manifest.left)
    assert codes(copied) == ["cameras-swapped"]
    mended(copied)
    assert read_manifest(copied) == manifest


def test_a_focal_length_is_named_alone_or_in_a_group_and_not_mended(copied: Path) -> None:
    rig = calibration_of(copied)
    assert rig.right is not None
    left, right = (
        replace(camera, matrix=camera.matrix * [[1.03, 1, 1], [1, 1.03, 1], [1, 1, 1]])
        for camera in (rig.left, rig.right)
    )
    rewrite(copied, replace(rig, left=left, right=right))
    (finding,) = examined(copied).findings
    assert "focal-both" in (finding.code, *finding.alike)


def test_a_camera_knocked_midway_is_named_with_the_frames(tmp_path: Path) -> None:
    from tracking.synthesis import Disturbances

    folder = tmp_path / "bumped"
    render_recording(
        folder, SCENES["lobby"], SECONDS, 3, 12, disturbances=Disturbances(bumped_s=1.5)
    )
    finding = next(one for one in examined(folder).findings if one.code == "camera-moved")
    after, before = finding.evidence["after_frame"], finding.evidence["before_frame"]
    assert int(after) < 1.5 * SCENES["lobby"].fps <= int(before)
    assert finding.mend is None


def test_what_pictures_cannot_say_is_refused_in_words(copied: Path) -> None:
    with open_recording(copied) as recording:
        finding = examine_with_no_mend(recording.folder)
        with pytest.raises(RecordingError, match="pictures do not say"):
            mend(recording, finding)


def examine_with_no_mend(folder: Path) -> Finding:
    turn_right(folder, 0, 0.5)
    return replace(examined(folder).findings[0], mend=None)


def test_one_camera_is_checked_for_having_moved_only(copied: Path) -> None:
    rewrite_manifest(copied, right=None)
    examination = examined(copied)
    assert examination.checked == ("camera-moved",)
    assert "floor" in examination.unchecked
    assert examination.is_partial


def test_a_mend_of_cameras_keeps_the_text_and_is_taken_back(copied: Path) -> None:
    path = copied / "recording.toml"
    manifest = read_manifest(copied)
    rewrite_manifest(copied, left=manifest.right, right=manifest.left)
    text = "# from the east\n" + path.read_text().replace("[right]", "[right]  # new lens")
    path.write_text(text)
    with open_recording(copied) as recording:
        (finding,) = examine(recording).findings
        done = mend_undoably(recording, finding)
    assert read_manifest(copied).left == manifest.left
    assert "# from the east" in path.read_text()
    assert "[right]  # new lens" in path.read_text()
    assert undo_mend(done) == (path,)
    assert path.read_text() == text


def test_a_mend_is_not_taken_back_over_what_was_written_since(copied: Path) -> None:
    turn_right(copied, 0, 0.5)
    with open_recording(copied) as recording:
        done = mend_undoably(recording, examine(recording).findings[0])
    later = turn_right(copied, 1, 0.1)
    with pytest.raises(RecordingError, match="has changed since it was mended"):
        undo_mend(done)
    assert later is not None
