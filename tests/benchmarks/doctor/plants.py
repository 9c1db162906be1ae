"""Faults put into the files of a recording, one at a time."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, StereoCalibration, read_calibration, write_calibration
from tracking.recording import Manifest, read_manifest, write_manifest

Edit = Callable[[StereoCalibration, Manifest], tuple[StereoCalibration, Manifest]]
Frame = NDArray[np.uint8]


@dataclass(frozen=True)
class Plant:
    """One fault.

    Attributes:
        kind: what it is called in the table. amount: how large, in words.
        codes: findings that name it.
        edit: of calibration and manifest; None: they stay.
        side, video: the camera whose video is filmed anew, and how; see `_film`.
    """

    kind: str
    amount: str
    codes: tuple[str, ...]
    edit: Edit | None = None
    side: str = ""
    video: Callable[[int, int, Frame], Frame | None] | None = None

    def put(self, recording: Path, folder: Path) -> Path:
        """A copy of the recording, with the fault, in the folder."""
        out = folder / "planted"
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir(parents=True)
        manifest = read_manifest(recording)
        for file in recording.iterdir():
            if file.is_file() and not file.name.startswith("truth"):
                shutil.copyfile(file, out / file.name)
        calibration = read_calibration((recording / manifest.calibration[0],))
        if self.edit is not None:
            calibration, manifest = self.edit(calibration, manifest)
            write_calibration(out / manifest.calibration[0], calibration)
        if self.video is not None:
            source = manifest.left if self.side == "left" else manifest.right
            assert source is not None
            _film(recording / source, out / f"{self.side}-planted.avi", self.video)
            manifest = replace(manifest, **{self.side: f"{self.side}-planted.avi"})
        write_manifest(out, manifest)
        return out


def _film(source: Path, out: Path, change: Callable[[int, int, Frame], Frame | None]) -> None:
    """The video once more; change(number, count, frame) gives each frame, None leaves it out."""
    video = cv2.VideoCapture(str(source))
    fps, count = video.get(cv2.CAP_PROP_FPS), int(video.get(cv2.CAP_PROP_FRAME_COUNT))
    size = (int(video.get(cv2.CAP_PROP_FRAME_WIDTH)), int(video.get(cv2.CAP_PROP_FRAME_HEIGHT)))
    writer = cv2.VideoWriter(str(out), cv2.VideoWriter.fourcc(*"MJPG"), fps, size)
    number = 0
    while True:
        there, frame = video.read()
        if not there:
            break
        changed = change(number, count, np.asarray(frame, np.uint8))
        if changed is not None:
            writer.write(changed)
        number += 1
    writer.release()
    video.release()


def _rotated(axis: int, degrees: float) -> Edit:
    def edit(rig: StereoCalibration, manifest: Manifest) -> tuple[StereoCalibration, Manifest]:
        turn = np.zeros(3)
        turn[axis] = np.deg2rad(degrees)
        matrix = np.asarray(cv2.Rodrigues(turn)[0], float)
        return replace(
            rig, rotation=matrix @ rig.rotation, translation=matrix @ rig.translation
        ), manifest

    return edit


def _baseline(share: float) -> Edit:
    return lambda rig, manifest: (
        replace(rig, translation=rig.translation * (1 + share)), manifest,
    )  # fmt: skip


def _focal(camera: Camera, share: float) -> Camera:
    matrix = camera.matrix.copy()
    matrix[:2, :2] *= 1 + share
    return replace(camera, matrix=matrix)


def _focal_of_both(share: float) -> Edit:
    def edit(rig: StereoCalibration, manifest: Manifest) -> tuple[StereoCalibration, Manifest]:
        assert rig.right is not None
        return replace(rig, left=_focal(rig.left, share), right=_focal(rig.right, share)), manifest

    return edit


def _focal_of_left(share: float) -> Edit:
    return lambda rig, manifest: (replace(rig, left=_focal(rig.left, share)), manifest)


def _shifted(columns: float, rows: float) -> Edit:
    def edit(rig: StereoCalibration, manifest: Manifest) -> tuple[StereoCalibration, Manifest]:
        assert rig.right is not None
        matrix = rig.right.matrix.copy()
        matrix[:2, 2] += columns, rows
        return replace(rig, right=replace(rig.right, matrix=matrix)), manifest

    return edit


def _ground(height: float = 0.0, tilt_deg: float = 0.0) -> Edit:
    def edit(rig: StereoCalibration, manifest: Manifest) -> tuple[StereoCalibration, Manifest]:
        was = manifest.ground
        assert was is not None
        told = Ground(was.height_m * (1 + height), was.tilt_deg + tilt_deg, was.roll_deg)
        return rig, replace(manifest, ground=told)

    return edit


def _swapped(rig: StereoCalibration, manifest: Manifest) -> tuple[StereoCalibration, Manifest]:
    assert manifest.right is not None
    return rig, replace(manifest, left=manifest.right, right=manifest.left)


def _late(frames: int) -> Callable[[int, int, Frame], Frame | None]:
    return lambda number, _count, frame: None if number < frames else frame


def _knocked(axis: int, degrees: float, when: float) -> Callable[[int, int, Frame], Frame | None]:
    """The camera turned about its centre: what it films is warped by K R K^-1."""

    def change(number: int, count: int, frame: Frame) -> Frame:
        if number < when * count:
            return frame
        height, width = frame.shape[:2]
        matrix = np.array([[_FOCAL_PX, 0, width / 2], [0, _FOCAL_PX, height / 2], [0, 0, 1]])
        turn = np.zeros(3)
        turn[axis] = np.deg2rad(degrees)
        warp = matrix @ cv2.Rodrigues(turn)[0] @ np.linalg.inv(matrix)
        warped = cv2.warpPerspective(frame, warp, (width, height), borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(warped, np.uint8)

    return change


_FOCAL_PX = 510.0
"""Of the rendered recordings' cameras."""
_COLUMNS = ("right-shifted-columns",)
BOTH_WAYS = (1, -1)


def plants(tilt_deg: float, signs: Sequence[int] = BOTH_WAYS) -> list[Plant]:
    """Every fault. tilt_deg: of the recording's camera. signs: ways that a number is off."""
    found = []
    for sign in signs:
        for axis, code in enumerate(("right-tilted", "right-turned", "right-rolled")):
            kind = f"right camera rotated about {'xyz'[axis]}"
            found.append(
                Plant(kind, f"{sign * 0.5:+} degrees", (code,), _rotated(axis, sign * 0.5))
            )
        found += [
            Plant("baseline", f"{sign:+} %", ("scale",), _baseline(sign * 0.01)),
            Plant("focal length of both", f"{2 * sign:+} %", ("focal-both",),
                  _focal_of_both(sign * 0.02)),
            Plant("focal length of the left", f"{2 * sign:+} %", ("focal-one",),
                  _focal_of_left(sign * 0.02)),
            Plant("right image shifted by columns", f"{3 * sign:+} px", _COLUMNS,
                  _shifted(3 * sign, 0)),
            Plant("right image shifted by rows", f"{3 * sign:+} px", ("right-shifted-rows",),
                  _shifted(0, 3 * sign)),
            Plant("height", f"{10 * sign:+} %", ("scale",), _ground(height=sign * 0.1)),
        ]  # fmt: skip
        off_deg = 2 * sign if tilt_deg + 2 * sign <= _STRAIGHT_DEG else -2
        found.append(
            Plant("tilt", f"{off_deg:+} degrees", ("ground-tilt",), _ground(tilt_deg=off_deg))
        )
    step, moved = ("cameras-out-of-step",), ("camera-moved",)
    return [
        *found,
        Plant("cameras swapped", "", ("cameras-swapped",), _swapped),
        Plant("lag", "left 2 frames late", step, side="right", video=_late(2)),
        Plant("lag", "right 2 frames late", step, side="left", video=_late(2)),
        Plant("left camera knocked midway", "0.5 degrees", moved,
              side="left", video=_knocked(0, 0.5, 0.5)),
        Plant("right camera knocked midway", "0.5 degrees", moved,
              side="right", video=_knocked(1, 0.5, 0.6)),
    ]  # fmt: skip


_STRAIGHT_DEG = 90.0


def cut(recording: Path, folder: str, begin: float, end: float) -> Path:
    """A part of the recording, from a share of its frames to another, filmed anew."""

    def change(number: int, count: int, frame: Frame) -> Frame | None:
        return frame if begin * count <= number < end * count else None

    halves = (Plant("", "", (), side=side, video=change) for side in ("left", "right"))
    place = recording
    for number, half in enumerate(halves):
        place = half.put(place, Path(folder) / str(number))
    return place
