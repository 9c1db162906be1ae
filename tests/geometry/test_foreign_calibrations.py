"""Calibration files of other programs and cameras, each read back as the rig it was made of."""

from __future__ import annotations

import contextlib
import json
import re
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tracking.errors import CalibrationError
from tracking.geometry import read_calibration

SIZE = (1280, 720)
LEFT, RIGHT = (700.0, 701.0, 640.5, 350.25), (702.0, 703.0, 630.5, 355.25)
LENS = (-0.1, 0.02, 0.001, -0.002)
ROTATION = np.asarray(cv2.Rodrigues(np.array([0.01, -0.02, 0.005]))[0])
SHIFT = np.array([-0.12, 0.002, 0.001])
WHOLE = np.block([[ROTATION, SHIFT[:, None]], [np.zeros((1, 3)), np.ones((1, 1))]])


def matrix(main: tuple[float, ...]) -> np.ndarray:
    fx, fy, cx, cy = main
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def kalibr() -> dict[str, str]:
    def camera(main: tuple[float, ...]) -> dict[str, object]:
        return {
            "camera_model": "pinhole",
            "intrinsics": list(main),
            "distortion_model": "radtan",
            "distortion_coeffs": list(LENS),
            "resolution": list(SIZE),
        }

    chain = {"cam0": camera(LEFT), "cam1": {**camera(RIGHT), "T_cn_cnm1": WHOLE.tolist()}}
    return {"camchain.yaml": yaml.safe_dump(chain)}


def euroc() -> dict[str, str]:
    body = np.eye(4)
    body[:3, :3], body[:3, 3] = cv2.Rodrigues(np.array([0.3, 0.2, -0.1]))[0], (0.1, 0.2, 0.3)
    poses = {"left": body, "right": body @ np.linalg.inv(WHOLE)}
    return {
        f"{side}.yaml": yaml.safe_dump(
            {
                "sensor_type": "camera",
                "T_BS": {"cols": 4, "rows": 4, "data": poses[side].ravel().tolist()},
                "resolution": list(SIZE),
                "camera_model": "pinhole",
                "intrinsics": list(main),
                "distortion_model": "radial-tangential",
                "distortion_coefficients": list(LENS),
            }
        )
        for side, main in (("left", LEFT), ("right", RIGHT))
    }


def zed() -> dict[str, str]:
    text = ""
    for side, main in (("LEFT", LEFT), ("RIGHT", RIGHT)):
        named = zip(("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"), (*main, *LENS), strict=True)
        text += f"[{side}_CAM_HD]\n" + "".join(f"{name}={value}\n" for name, value in named)
    baseline, ty, tz = -1000 * SHIFT
    text += f"[STEREO]\nBaseline={baseline}\nTY={ty}\nTZ={tz}\n"
    return {"SN1234.conf": text + "RX_HD=0.01\nCV_HD=-0.02\nRZ_HD=0.005\n"}


def oak() -> dict[str, str]:
    def camera(main: tuple[float, ...], turn: np.ndarray, shift: np.ndarray, to: int) -> object:
        return {
            "width": SIZE[0],
            "height": SIZE[1],
            "intrinsicMatrix": matrix(main).tolist(),
            "distortionCoeff": [*LENS, *[0.0] * 10],
            "extrinsics": {
                "rotationMatrix": turn.tolist(),
                "translation": dict(zip("xyz", (100 * shift).tolist(), strict=True)),
                "toCameraSocket": to,
            },
        }

    data = [[1, camera(LEFT, ROTATION, SHIFT, 2)], [2, camera(RIGHT, np.eye(3), SHIFT, 0)]]
    pair = {"leftCameraSocket": 1, "rightCameraSocket": 2}
    return {"calib.json": json.dumps({"cameraData": data, "stereoConfigData": pair})}


def matlab() -> dict[str, str]:
    def camera(main: tuple[float, ...]) -> object:
        one_based = np.add(main, (0, 0, 1, 1))
        return {
            "ImageSize": [SIZE[1], SIZE[0]],
            "IntrinsicMatrix": matrix(tuple(one_based)).T.tolist(),
            "RadialDistortion": list(LENS[:2]),
            "TangentialDistortion": list(LENS[2:]),
        }

    parts = {
        "CameraParameters1": camera(LEFT),
        "CameraParameters2": camera(RIGHT),
        "RotationOfCamera2": ROTATION.T.tolist(),
        "TranslationOfCamera2": (1000 * SHIFT).tolist(),
    }
    return {"stereoParams.json": json.dumps(parts)}


def plain_json() -> dict[str, str]:
    values: dict[str, object] = {"image_size": SIZE, "R": ROTATION.tolist(), "T": SHIFT.tolist()}
    for number, main in (("1", LEFT), ("2", RIGHT)):
        values |= {f"K{number}": matrix(main).tolist(), f"D{number}": LENS}
    return {"rig.json": json.dumps(values)}


def plain_toml() -> dict[str, str]:
    text = f"size = {list(SIZE)}\nR = {ROTATION.tolist()}\nT = {(1000 * SHIFT).tolist()}\n"
    for side, main in (("left", LEFT), ("right", RIGHT)):
        text += f"[{side}]\ncamera_matrix = {matrix(main).tolist()}\ndist_coeffs = {list(LENS)}\n"
    return {"rig.toml": text}


PAIRS: dict[str, Callable[[], dict[str, str]]] = {
    one.__name__: one for one in (kalibr, euroc, zed, oak, matlab, plain_json, plain_toml)
}


def written(folder: Path, files: dict[str, str]) -> list[Path]:
    """The files by their names, in order."""
    for name, text in files.items():
        (folder / name).write_text(text)
    return [folder / name for name in files]


@pytest.mark.parametrize("kind", PAIRS)
def test_a_pair_is_read_as_it_was_written(kind: str, tmp_path: Path) -> None:
    found = read_calibration(written(tmp_path, PAIRS[kind]()), SIZE)
    assert found.right is not None
    for camera, main in ((found.left, LEFT), (found.right, RIGHT)):
        np.testing.assert_allclose(camera.matrix, matrix(main), atol=1e-9)
        np.testing.assert_allclose(camera.distortion[:4], LENS, atol=1e-12)
        assert camera.size == SIZE
    np.testing.assert_allclose(found.rotation, ROTATION, atol=1e-9)
    np.testing.assert_allclose(found.translation, SHIFT, atol=1e-9)


@pytest.mark.parametrize(
    ("line", "focal", "fisheye"),
    [
        ("SIMPLE_RADIAL 1280 720 700 641 350.75 -0.1", (700, 700), False),
        ("OPENCV 1280 720 700 701 641 350.75 -0.1 0.02 0 0", (700, 701), False),
        ("OPENCV_FISHEYE 1280 720 700 701 641 350.75 0.1 0 0 0", (700, 701), True),
    ],
)
def test_a_camera_of_colmap_is_read(
    line: str, focal: tuple[float, float], fisheye: bool, tmp_path: Path
) -> None:
    (path,) = written(tmp_path, {"cameras.txt": f"# Camera list\n1 {line}\n"})
    camera = read_calibration([path]).left
    np.testing.assert_allclose(camera.matrix[[0, 1], [0, 1]], focal)
    np.testing.assert_allclose(camera.matrix[:2, 2], (640.5, 350.25))
    assert camera.fisheye == fisheye


def test_a_zed_is_read_at_sizes_it_has_only(tmp_path: Path) -> None:
    paths = written(tmp_path, zed())
    for size in (None, (640, 480), (1920, 1080)):
        with pytest.raises(CalibrationError, match=r"image size|incomplete"):
            read_calibration(paths, size)


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    kind=st.sampled_from(sorted(PAIRS)),
    place=st.floats(0, 1),
    length=st.integers(0, 40),
    instead=st.text(st.characters(codec="utf-8"), max_size=6),
)
def test_damaged_files_give_a_calibration_or_one_line(
    kind: str, place: float, length: int, instead: str, tmp_path: Path
) -> None:
    files = PAIRS[kind]()
    name = min(files)
    begin = int(place * (len(files[name]) - 1))
    files[name] = files[name][:begin] + instead + files[name][begin + length :]
    paths = written(tmp_path, files)
    told = ""
    try:
        read_calibration(paths, SIZE)
    except CalibrationError as error:
        told = str(error)
    assert "\n" not in told


@pytest.mark.parametrize("kind", PAIRS)
def test_no_number_may_be_too_large_to_hold(kind: str, tmp_path: Path) -> None:
    files = PAIRS[kind]()
    first, text = next(iter(files.items()))
    for number in re.finditer(r"(?<![\w.])-?\d+(\.\d+)?", text):
        paths = written(
            tmp_path, files | {first: f"{text[: number.start()]}1e999{text[number.end() :]}"}
        )
        with contextlib.suppress(CalibrationError):
            assert np.isfinite(read_calibration(paths, SIZE).left.matrix).all()
