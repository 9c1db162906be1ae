"""Depth beside the left camera: read, refused, and tracked by."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from small_recordings import COUNT, rig, write_images

from tracking.errors import RecordingError
from tracking.geometry import Ground, write_calibration
from tracking.recording import Manifest, OpenOptions, Recording, open_recording, write_manifest
from tracking.trackers import best_tracker

SIZE = (96, 128)


def write_depth(folder: Path, numbers: range, shape: tuple[int, ...] = SIZE) -> None:
    folder.mkdir()
    for number in numbers:
        cv2.imwrite(str(folder / f"{number:06d}.png"), np.full(shape, 1000 + number, np.uint16))


def recording_of(folder: Path, manifest: Manifest | None = None) -> Recording:
    write_images(folder / "left", range(COUNT))
    write_calibration(folder / "calibration.yaml", rig())
    write_manifest(
        folder,
        manifest
        or Manifest(
            "Hall",
            "left/*.png",
            depth="depth/*.png",
            fps=10.0,
            calibration=("calibration.yaml",),
            ground=Ground(2.4, 30.0),
        ),
    )
    return open_recording(folder)


def test_each_frame_has_its_depth_in_metres(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT))
    with recording_of(tmp_path) as recording:
        assert recording.has_depth
        assert not recording.is_stereo
        depths = [frame.depth for frame in recording.frames()]
        assert [round(float(d[5, 5]), 4) for d in depths if d is not None] == [
            round(1 + n / 1000, 4) for n in range(COUNT)
        ]
        assert recording.read(3).depth is not None
        assert best_tracker(recording) == "stereo-joint"
        assert recording.sources == (tmp_path / "left", tmp_path / "depth")
        assert len(recording.fingerprints()) == 2


def test_depth_stays_where_a_calibration_from_elsewhere_is_given(tmp_path: Path) -> None:
    home, elsewhere = tmp_path / "home", tmp_path / "elsewhere.yaml"
    home.mkdir()
    write_depth(home / "depth", range(COUNT))
    recording_of(home).close()
    write_calibration(elsewhere, rig())
    with open_recording(home, OpenOptions(calibration=(elsewhere,))) as recording:
        assert recording.folder == tmp_path
        assert recording.read(0).depth is not None


def test_unknown_depth_is_zero(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT))
    units = np.full(SIZE, 0xFFFF, np.uint16)
    units[0, 0] = 0
    units[1, 1] = 2500
    cv2.imwrite(str(tmp_path / "depth" / "000004.png"), units)
    with recording_of(tmp_path) as recording:
        depth = recording.read(4).depth
        assert depth is not None
        assert (depth[0, 0], depth[9, 9], depth[1, 1]) == (0, 0, 2.5)


def test_a_broken_depth_image_is_unknown_and_told(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT))
    (tmp_path / "depth" / "000004.png").write_bytes(b"nothing")
    with recording_of(tmp_path) as recording:
        depth = recording.read(4).depth
        assert depth is not None
        assert not depth.any()
        assert recording.notes == (
            "depth/*.png: 1 depth image broken or of another size, first 4; "
            "no depth is known there",
        )


def test_depth_of_another_size_is_refused(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT), (48, 64))
    with pytest.raises(RecordingError, match="64 x 48 px, the left camera 128 x 96"):
        recording_of(tmp_path)


def test_depth_of_8_bits_is_refused(tmp_path: Path) -> None:
    write_images(tmp_path / "depth", range(COUNT))
    with pytest.raises(RecordingError, match="one channel of 16 bits, this image has 3 of 8"):
        recording_of(tmp_path)


def test_missing_depth_images_are_refused(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT - 2))
    with pytest.raises(RecordingError, match=f"has {COUNT - 2} images, the left camera {COUNT}"):
        recording_of(tmp_path)


def test_no_depth_images_are_refused(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no folder"):
        recording_of(tmp_path)


@pytest.mark.parametrize("scale", ["0", "-0.001", "nan", "inf", "2.0"])
def test_a_scale_that_is_none_is_refused(tmp_path: Path, scale: str) -> None:
    write_depth(tmp_path / "depth", range(COUNT))
    write_images(tmp_path / "left", range(COUNT))
    text = f'fps = 10\n[left]\nsource = "left"\n[depth]\nsource = "depth"\nscale = {scale}\n'
    (tmp_path / "recording.toml").write_text(text)
    with pytest.raises(RecordingError, match=r"\[depth\] scale must be 1e-06 to 1 m per unit"):
        open_recording(tmp_path)


def test_depth_beside_a_right_camera_is_refused(tmp_path: Path) -> None:
    text = '[left]\nsource = "a"\n[right]\nsource = "b"\n[depth]\nsource = "depth"\n'
    (tmp_path / "recording.toml").write_text(text)
    with pytest.raises(RecordingError, match="stands beside a right camera"):
        open_recording(tmp_path)


def test_depth_that_leads_outside_is_refused(tmp_path: Path) -> None:
    manifest = Manifest("Hall", "left/*.png", depth="../depth/*.png", fps=10.0)
    with pytest.raises(RecordingError, match="outside the folder"):
        recording_of(tmp_path, manifest)


def test_depth_without_calibration_opens_as_one_camera(tmp_path: Path) -> None:
    write_depth(tmp_path / "depth", range(COUNT))
    manifest = Manifest("Hall", "left/*.png", depth="depth/*.png", fps=10.0)
    with recording_of(tmp_path, manifest) as recording:
        assert recording.rectification is None
        assert best_tracker(recording) == "three-part"
