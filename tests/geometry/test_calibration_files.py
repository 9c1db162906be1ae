"""Calibration files of OpenCV, KITTI and ROS; broken and hostile ones."""

from __future__ import annotations

import os
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import CalibrationError, OutputError
from tracking.geometry import Camera, StereoCalibration, read_calibration, write_calibration

MATRIX = np.array([[510.5, 0.0, 322.3], [0.0, 511.25, 238.1], [0.0, 0.0, 1.0]])
ROTATION, _ = cv2.Rodrigues(np.array([0.01, -0.02, 0.005]))
TRANSLATION = np.array([-0.1201, 0.0013, -1e-05])


def rig(rotation: np.ndarray = ROTATION, distortion: float = -0.1) -> StereoCalibration:
    left = Camera(MATRIX, np.array([distortion, 1e-05, 0, 0, 0]), 640, 480)
    right = Camera(MATRIX + np.diag([3.0, 3.0, 0.0]), np.zeros(5), 640, 480)
    return StereoCalibration(left, right, rotation, TRANSLATION)


def opencv_values(calibration: StereoCalibration) -> dict[str, np.ndarray]:
    assert calibration.right is not None
    return {
        "M1": calibration.left.matrix,
        "D1": calibration.left.distortion[None],
        "M2": calibration.right.matrix,
        "D2": calibration.right.distortion[None],
        "R": calibration.rotation,
        "T": calibration.translation[:, None],
    }


def write_opencv(path: Path, values: dict[str, np.ndarray], size: bool = True) -> Path:
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    for name, value in values.items():
        storage.write(name, value)
    if size:
        storage.write("image_width", 640)
        storage.write("image_height", 480)
    storage.release()
    return path


def assert_same(found: StereoCalibration, expected: StereoCalibration, atol: float = 0.0) -> None:
    assert found.right is not None
    assert expected.right is not None
    np.testing.assert_allclose(found.left.matrix, expected.left.matrix, atol=atol)
    np.testing.assert_allclose(found.left.distortion, expected.left.distortion, atol=atol)
    np.testing.assert_allclose(found.right.matrix, expected.right.matrix, atol=atol)
    np.testing.assert_allclose(found.rotation, expected.rotation, atol=max(atol, 1e-12))
    np.testing.assert_allclose(found.translation, expected.translation, atol=atol)
    assert found.left.size == expected.left.size


@pytest.mark.parametrize("name", ["both.yaml", "both.yml", "both.xml"])
def test_what_opencv_writes_is_read(tmp_path: Path, name: str) -> None:
    path = write_opencv(tmp_path / name, opencv_values(rig()))
    assert_same(read_calibration([path]), rig())


def test_the_old_yaml_header_is_read(tmp_path: Path) -> None:
    path = write_opencv(tmp_path / "old.yml", opencv_values(rig()))
    text = path.read_text().partition("\n")[2]
    path.write_text("%YAML:1.0\n" + text)
    assert_same(read_calibration([path]), rig())


def test_an_intrinsics_and_extrinsics_pair_is_read(tmp_path: Path) -> None:
    values = opencv_values(rig())
    inner = {name: values.pop(name) for name in ("M1", "D1", "M2", "D2")}
    pair = [
        write_opencv(tmp_path / "intrinsics.yml", inner, size=False),
        write_opencv(tmp_path / "extrinsics.yml", values, size=False),
    ]
    assert_same(read_calibration(pair, size=(640, 480)), rig())


def test_one_camera_is_read(tmp_path: Path, shared_data: Path) -> None:
    calibration = read_calibration([shared_data / "pets-s2l1-real" / "calibration.yaml"])
    assert calibration.right is None
    assert calibration.left.size == (768, 576)


@given(st.floats(0.05, 0.5), st.floats(-0.3, 0.3), st.floats(200, 2000))
@settings(deadline=None, max_examples=30)
def test_a_written_calibration_reads_back_exactly(
    tmp_path_factory: pytest.TempPathFactory, baseline: float, k1: float, focal: float
) -> None:
    camera = Camera(
        np.array([[focal, 0, 300.1], [0, focal, 200.2], [0, 0, 1]]), np.array([k1, 0, 0, 0, 0]),
        640, 480,
    )  # fmt: skip
    written = StereoCalibration(camera, camera, np.eye(3), np.array([-baseline, 0, 0]))
    path = tmp_path_factory.mktemp("written") / "calibration.yaml"
    write_calibration(path, written)
    assert_same(read_calibration([path]), written)


def test_opencv_reads_what_is_written(tmp_path: Path) -> None:
    path = tmp_path / "calibration.yaml"
    write_calibration(path, rig())
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
    np.testing.assert_array_equal(storage.getNode("M1").mat(), MATRIX)
    assert storage.getNode("image_width").real() == 640


def test_a_calibration_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        write_calibration(tmp_path / "missing" / "calibration.yaml", rig())
    assert list(tmp_path.iterdir()) == []


KITTI = """P0: 721.5 0 609.5 0 0 721.5 172.8 0 0 0 1 0
P1: 721.5 0 609.5 -387.5 0 721.5 172.8 0 0 0 1 0
P2: 721.5 0 609.5 44.85 0 721.5 172.8 0.21 0 0 1 0.0027
P3: 721.5 0 609.5 -339.5 0 721.5 172.8 2.19 0 0 1 0.0027
Tr_velo_to_cam: 1 0 0 0 0 1 0 0 0 0 1 0
"""


def test_kitti_gives_cameras_two_and_three(tmp_path: Path) -> None:
    path = tmp_path / "calib.txt"
    path.write_text(KITTI)
    calibration = read_calibration([path], size=(1242, 375))
    assert calibration.right is not None
    assert calibration.translation == pytest.approx((-(44.85 + 339.5) / 721.5, 0, 0))
    assert calibration.left.matrix[0, 0] == 721.5
    assert calibration.left.size == (1242, 375)


def test_kitti_grey_cameras_serve_where_the_colour_ones_are_missing(tmp_path: Path) -> None:
    path = tmp_path / "calib.txt"
    path.write_text("\n".join(KITTI.splitlines()[:2]))
    assert read_calibration([path], size=(1242, 375)).baseline_m == pytest.approx(387.5 / 721.5)


def ros_text(rotation: np.ndarray, offset: float, model: str = "plumb_bob") -> str:
    def block(name: str, values: np.ndarray) -> str:
        numbers = ", ".join(f"{value:.17g}" for value in values.ravel())
        return (
            f"{name}:\n  rows: {values.shape[0]}\n  cols: {values.shape[1]}\n  data: [{numbers}]\n"
        )

    projection = np.array([[500, 0, 320, offset], [0, 500, 240, 0], [0, 0, 1, 0.0]])
    return (
        f"image_width: 640\nimage_height: 480\ncamera_name: eye\ndistortion_model: {model}\n"
        + block("camera_matrix", MATRIX)
        + block("distortion_coefficients", np.array([[-0.1, 0.01, 0, 0, 0]]))
        + block("rectification_matrix", rotation)
        + block("projection_matrix", projection)
    )


def test_a_pair_of_ros_camera_infos_gives_rotation_and_baseline(tmp_path: Path) -> None:
    right_rotation, _ = cv2.Rodrigues(np.array([0.0, 0.03, 0.0]))
    (tmp_path / "left.yaml").write_text(ros_text(ROTATION, 0.0))
    (tmp_path / "right.yaml").write_text(ros_text(right_rotation, -60.0))
    calibration = read_calibration([tmp_path / "left.yaml", tmp_path / "right.yaml"])
    np.testing.assert_allclose(calibration.rotation, right_rotation.T @ ROTATION, atol=1e-9)
    # The right camera stands 0.12 m along the common rectified row.
    np.testing.assert_allclose(
        ROTATION @ (-calibration.rotation.T @ calibration.translation), (0.12, 0, 0), atol=1e-9
    )


def test_an_unknown_lens_model_is_refused_by_name(tmp_path: Path) -> None:
    path = tmp_path / "left.yaml"
    path.write_text(ros_text(ROTATION, 0.0, model="double_sphere"))
    with pytest.raises(CalibrationError, match="double_sphere"):
        read_calibration([path])


def test_a_fisheye_of_ros_with_other_than_four_coefficients_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "left.yaml"
    path.write_text(ros_text(ROTATION, 0.0, model="equidistant"))
    with pytest.raises(CalibrationError, match="5 distortion coefficients"):
        read_calibration([path])


def _matrix(rows: object, cols: object, data: str) -> str:
    return f"M1: !!opencv-matrix\n   rows: {rows}\n   cols: {cols}\n   dt: d\n   data: {data}\n"


HOSTILE = {
    "nothing": "",
    "binary": "\x00\x01\x02",
    "no mapping": "%YAML:1.0\n---\n- 1\n- 2\n",
    "no M1": "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n",
    "M1 no matrix": "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\nM1: 3\n",
    "too few numbers": _matrix(3, 3, "[1., 2.]"),
    "huge matrix": _matrix(10**9, 10**9, "[1.]"),
    "negative rows": _matrix(-3, -3, "[1., 0., 0., 0., 1., 0., 0., 0., 1.]"),
    "rows are words": _matrix("three", 3, "[1.]"),
    "not finite": _matrix(3, 3, "[.nan, 0., 0., 0., 1., 0., 0., 0., 1.]")
    + "image_width: 640\nimage_height: 480\n",
    "deep": "a: " + "[" * 50_000,
    "deep mapping": "".join(f"{' ' * i}a:\n" for i in range(400)),
    "references": "a: &a [1, 2]\nb: &b [*a, *a]\nc: [*b, *b]\n",
    "python object": "M1: !!python/object/apply:os.system ['true']\n",
    "size without height": _matrix(3, 3, "[9., 0., 1., 0., 9., 1., 0., 0., 1.]")
    + "image_width: 640\n",
    "no size": _matrix(3, 3, "[9., 0., 1., 0., 9., 1., 0., 0., 1.]"),
    "only half a rig": _matrix(3, 3, "[9., 0., 1., 0., 9., 1., 0., 0., 1.]")
    + "image_width: 640\nimage_height: 480\n"
    + _matrix(3, 1, "[-0.1, 0., 0.]").replace("M1", "T"),
    "huge number": "a: " + "9" * 50_000,
    "a date for a key": "2020-13-45: 1\n",
    "endless width": _matrix(3, 3, "[9., 0., 1., 0., 9., 1., 0., 0., 1.]")
    + "image_width: .inf\nimage_height: 480\n",
    "endless rows": _matrix(".inf", 1, "[1.]"),
    "a number beyond floats": _matrix(1, 1, f"[1{'0' * 400}]"),
    "a truth that is none": "a: !!bool maybe\n",
    "an empty number": 'a: !!int ""\n',
    "a time that is none": "a: !!timestamp soon\n",
    "ros with an endless width": "camera_matrix: {rows: 3, cols: 3, data: "
    "[9, 0, 1, 0, 9, 1, 0, 0, 1]}\nimage_width: .inf\n"
    "distortion_coefficients: {rows: 1, cols: 1, data: [0]}\n",
    "xml bomb": '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY b "bb">]><opencv_storage>&b;'
    "</opencv_storage>",
    "other xml": "<?xml version='1.0'?><svg/>",
    "xml with a broken matrix": "<opencv_storage><M1 type_id='opencv-matrix'><rows>3</rows>"
    "<cols>x</cols><data>1</data></M1></opencv_storage>",
    "xml cut short": "<opencv_storage><M1>",
    "kitti of words": "P2: a b c\n",
    "kitti too short": "P2: 1 2 3\n",
    "kitti without colour or grey": "P1: 1 0 0 0 0 1 0 0 0 0 1 0\n",
    "kitti without focal length": "P2: 0 0 0 0 0 0 0 0 0 0 1 0\n",
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_a_broken_or_hostile_file_ends_in_one_line_that_names_it(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "calibration.yaml"
    path.write_text(HOSTILE[kind])
    with pytest.raises(CalibrationError) as caught:
        read_calibration([path])
    assert "calibration.yaml" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 600


@pytest.mark.parametrize("head", ["", "%YAML:1.0\n---\n", "%YAML:1.0\r\n---\r\n"])
def test_a_broken_line_is_told_as_an_editor_numbers_it(tmp_path: Path, head: str) -> None:
    path = tmp_path / "calibration.yaml"
    path.write_bytes(f"{head}image_width: 640\nM1: 3\n\timage_height: 480\n".encode())
    line = head.count("\n") + 3
    with pytest.raises(CalibrationError, match=rf", line {line}\)"):
        read_calibration([path])


@given(st.binary(max_size=400))
@settings(deadline=None, max_examples=60)
def test_no_bytes_whatever_make_the_reader_fail_otherwise(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    path = tmp_path_factory.mktemp("any") / "calibration.yaml"
    path.write_bytes(content)
    with pytest.raises(CalibrationError):
        read_calibration([path])


def test_a_file_too_large_for_a_calibration_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "calibration.yaml"
    path.write_text("#" * 300_000)
    with pytest.raises(CalibrationError, match="too large"):
        read_calibration([path])


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(CalibrationError, match="check the path"):
        read_calibration([tmp_path / "calibration.yaml"])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_a_pipe_is_no_calibration(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "calibration.yaml")
    for path in (tmp_path, tmp_path / "calibration.yaml"):
        with pytest.raises(CalibrationError, match="not a file"):
            read_calibration([path])
