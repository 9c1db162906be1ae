"""The floor in recording.toml: written into somebody's text, and read as a pose."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracking.errors import RecordingError
from tracking.geometry import Ground
from tracking.recording.ground_writer import write_ground
from tracking.recording.manifest import parse_manifest, read_manifest

TEXT = """# Our lobby
format = 1

[left]
source = "left.mp4"  # the new camera
"""
OLD = """
[ground]
# measured by hand
height = 2.0
tilt = 30 # about
R = [
  [1, 0, 0],
  [0, 1, 0],
]

[region]
mask = [[0, 0], [9, 0], [9, 9]]
"""


@pytest.mark.parametrize("more", ["", OLD])
def test_the_floor_is_put_into_the_text_and_all_else_stays(more: str, tmp_path: Path) -> None:
    (tmp_path / "recording.toml").write_text(TEXT + more)
    write_ground(tmp_path, Ground(2.4, 31.5, -0.25))
    text = (tmp_path / "recording.toml").read_text()
    assert read_manifest(tmp_path).ground == Ground(2.4, 31.5, -0.25)
    for line in (TEXT + more).splitlines():
        if line.startswith("#") or "source" in line or "mask" in line:
            assert line in text


def test_a_floor_in_a_form_that_cannot_be_replaced_stays_as_it_is(tmp_path: Path) -> None:
    text = 'ground = {height = 2.0, tilt = 30}\n[left]\nsource = "left.mp4"\n'
    (tmp_path / "recording.toml").write_text(text)
    with pytest.raises(RecordingError):
        write_ground(tmp_path, Ground(2.4, 31.5))
    assert (tmp_path / "recording.toml").read_text() == text


def test_a_floor_is_read_from_a_cameras_pose() -> None:
    truth = Ground(2.6, 28.0, 3.0)
    rotation, centre = truth.world_from_camera
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    matrix, shift = rotation.T @ turn, -rotation.T @ centre - rotation.T @ turn @ (4.0, 5.0, 0.0)
    text = f'[left]\nsource = "a.mp4"\n[ground]\nR = {matrix.tolist()}\nt = {shift.tolist()}\n'
    ground = parse_manifest(text, "recording.toml", "a").ground
    assert ground is not None
    assert ground.height_m == pytest.approx(2.6)
    assert ground.tilt_deg == pytest.approx(28.0)
    assert ground.roll_deg == pytest.approx(3.0)


@pytest.mark.parametrize(
    "values", ["R = [[1, 0], [0, 1]]\nt = [0, 0, 0]", "R = 3\nt = 4", "t = [0.0, 0.0, 2.0]"]
)
def test_a_pose_that_is_none_is_refused_in_one_line(values: str) -> None:
    with pytest.raises(RecordingError) as error:
        parse_manifest(f'[left]\nsource = "a.mp4"\n[ground]\n{values}\n', "recording.toml", "a")
    assert "\n" not in str(error.value)
