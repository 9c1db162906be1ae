"""One scene in each container gives the same frames, times and calibration."""

from __future__ import annotations

import gzip
import os
import shutil
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import containers_of_scene
import numpy as np
import pytest
from containers_of_scene import (
    BAGS,
    FOLDERS,
    FPS,
    SIZE,
    Footage,
    footage_of_scene,
    messages_of,
    write_euroc,
    write_kitti,
    write_mcap,
    write_oak,
    write_oak_tar,
    write_rosbag1,
    write_zed,
)

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import StereoCalibration
from tracking.recording import (
    OpenOptions,
    Recording,
    open_from_manifest,
    open_recording,
    time_stamps,
)
from tracking.recording.bags import bag_contents
from tracking.recording.bags.messages import stamp_ns
from tracking.recording.bags.rosbag1 import Rosbag1

FLOOR = OpenOptions(height_m=2.4, tilt_deg=30.0)


@pytest.fixture(scope="module")
def footage() -> Footage:
    return footage_of_scene()


def assert_frames(recording: Recording, footage: Footage) -> None:
    assert recording.frame_count == len(footage.left)
    assert recording.size == SIZE
    for number, frame in enumerate(recording.frames()):
        assert (frame.left == footage.left[number]).all()
        if recording.is_stereo:
            assert (frame.right == footage.right[number]).all()


def assert_times(recording: Recording, footage: Footage) -> None:
    times = [recording.time_s(number) for number in range(recording.frame_count)]
    told = [(stamp - footage.stamps_ns[0]) / 1e9 for stamp in footage.stamps_ns]
    assert times == pytest.approx(told, abs=1e-6)
    assert recording.fps == pytest.approx(FPS, rel=1e-3)


def assert_calibration(found: StereoCalibration | None, footage: Footage) -> None:
    assert found is not None
    told = footage.calibration
    assert np.allclose(found.left.matrix, told.left.matrix)
    assert found.left.lens.is_ideal
    if found.right is not None:
        assert np.allclose(found.rotation, told.rotation)
        assert np.allclose(found.translation, told.translation)


@pytest.mark.parametrize("kind", FOLDERS)
def test_a_folder_gives_frames_times_and_calibration(
    kind: str, tmp_path: Path, footage: Footage
) -> None:
    with open_recording(FOLDERS[kind](tmp_path, footage), FLOOR) as recording:
        assert recording.is_stereo
        assert_frames(recording, footage)
        assert_times(recording, footage)
        assert_calibration(recording.calibration, footage)
        assert recording.view is not None
        assert recording.rectification is not None


@pytest.mark.parametrize("compressed", [False, True], ids=["plain", "compressed"])
@pytest.mark.parametrize("kind", BAGS)
def test_a_bag_gives_frames_times_and_calibration(
    kind: str, compressed: bool, tmp_path: Path, footage: Footage
) -> None:
    with open_recording(BAGS[kind](tmp_path, footage, compressed=compressed), FLOOR) as recording:
        assert recording.is_stereo
        assert_frames(recording, footage)
        assert_times(recording, footage)
        assert_calibration(recording.calibration, footage)
        assert (recording.read(3).left == footage.left[3]).all()
        assert recording.view is not None


@pytest.mark.parametrize("kind", BAGS)
def test_a_bag_with_depth_gives_metres(kind: str, tmp_path: Path, footage: Footage) -> None:
    with open_recording(BAGS[kind](tmp_path, footage, depth=True), FLOOR) as recording:
        assert (recording.is_stereo, recording.has_depth) == (False, True)
        assert_frames(recording, footage)
        assert_times(recording, footage)
        for number, frame in enumerate(recording.frames()):
            assert frame.depth is not None
            assert np.allclose(frame.depth, footage.depth[number] * 0.001)
        assert recording.rectification is not None


def test_a_packed_bag_gives_the_cameras_own_times(tmp_path: Path, footage: Footage) -> None:
    with open_recording(write_rosbag1(tmp_path, footage, packed=True)) as recording:
        assert_frames(recording, footage)
        assert_times(recording, footage)


def test_a_bag_without_the_cameras_own_times_is_told(
    tmp_path: Path, footage: Footage, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unstamped(*args: Any, **options: Any) -> Iterator[tuple[str, int, Any]]:
        for topic, time, value in messages_of(*args, **options):
            value.header.stamp.sec = value.header.stamp.nanosec = 0
            yield topic, time, value

    monkeypatch.setattr(containers_of_scene, "messages_of", unstamped)
    with open_recording(write_rosbag1(tmp_path, footage)) as recording:
        assert any("times are those of recording" in str(note) for note in recording.notes)


def test_a_bag_of_ros_1_is_read_where_files_have_no_positioned_reads(
    tmp_path: Path, footage: Footage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(os, "pread", raising=False)  # as on Windows
    bag = Rosbag1(write_rosbag1(tmp_path, footage))
    topic = next(topic for topic in bag.topics if topic.name == "/stereo/left/image_raw")
    with closing(bag._file):
        heads = bag.heads(bag.entries(topic))
    assert heads is not None
    assert [stamp_ns(topic, head) for head in heads] == list(footage.stamps_ns)


def test_a_tar_with_depth_gives_metres(tmp_path: Path, footage: Footage) -> None:
    with open_recording(write_oak_tar(tmp_path, footage, depth=True), FLOOR) as recording:
        assert recording.has_depth
        assert_frames(recording, footage)
        assert_times(recording, footage)
        assert_calibration(recording.calibration, footage)
        depth = recording.read(2).depth
        assert depth is not None
        assert np.allclose(depth, footage.depth[2] * 0.001)


def test_a_packed_tar_is_refused_in_a_line(tmp_path: Path, footage: Footage) -> None:
    path = write_oak_tar(tmp_path, footage)
    path.write_bytes(gzip.compress(path.read_bytes()))
    with pytest.raises(RecordingError, match="cannot be read as a tar that is not packed"):
        open_recording(path)


@pytest.mark.parametrize("kind", ["oak", "zed"])
def test_a_folder_with_depth_gives_metres(kind: str, tmp_path: Path, footage: Footage) -> None:
    if kind == "oak":
        write_oak(tmp_path, footage, depth=True)
    else:
        write_zed(tmp_path, footage)
    with open_recording(tmp_path) as recording:
        assert recording.has_depth
        assert_frames(recording, footage)
        depth = recording.read(2).depth
        assert depth is not None
        assert np.allclose(depth, footage.depth[2] * 0.001)


def test_a_manifest_of_the_floor_alone_stands_in_a_folder(tmp_path: Path, footage: Footage) -> None:
    write_euroc(tmp_path, footage)
    (tmp_path / "recording.toml").write_text("[ground]\nheight = 2.5\ntilt = 31.0\n")
    with open_recording(tmp_path) as recording:
        assert recording.ground is not None
        assert recording.ground.height_m == 2.5
        assert_frames(recording, footage)
        assert_calibration(recording.calibration, footage)


def test_what_was_found_opens_again_by_its_manifest(tmp_path: Path, footage: Footage) -> None:
    path = write_mcap(tmp_path, footage)
    with open_recording(path, FLOOR) as recording:
        place, text, told = recording.folder, recording.manifest_text, recording.fingerprints()
        assert "camera_matrix" in recording.calibration_text
    with open_from_manifest(place, text) as again:
        assert_frames(again, footage)
        assert again.fingerprints() == told
        assert again.calibration is not None


def test_a_kitti_drive_with_a_manifest_of_the_floor_opens_again(
    tmp_path: Path, footage: Footage
) -> None:
    drive = write_kitti(tmp_path, footage)
    (drive / "recording.toml").write_text("[ground]\nheight = 2.5\ntilt = 31.0\n")
    with open_recording(drive) as recording:
        place, text, told = recording.folder, recording.manifest_text, recording.fingerprints()
        assert_calibration(recording.calibration, footage)
        assert recording.name == drive.name
    with open_from_manifest(place, text) as again:
        assert_frames(again, footage)
        assert_times(again, footage)
        assert_calibration(again.calibration, footage)
        assert again.fingerprints() == told
        assert again.ground is not None


def test_topics_are_named_in_a_manifest(tmp_path: Path, footage: Footage) -> None:
    write_rosbag1(tmp_path, footage)
    manifest = '[left]\nsource = "run.bag"\ntopic = "/stereo/right/image_raw"\n'
    (tmp_path / "recording.toml").write_text(manifest)
    with open_recording(tmp_path) as recording:
        assert not recording.is_stereo
        assert (recording.read(1).left == footage.right[1]).all()
        assert recording.calibration is None


def test_an_unknown_topic_is_told_with_those_that_are_there(
    tmp_path: Path, footage: Footage
) -> None:
    write_rosbag1(tmp_path, footage)
    (tmp_path / "recording.toml").write_text('[left]\nsource = "run.bag"\ntopic = "/camera"\n')
    with pytest.raises(RecordingError, match="no images on topic /camera, only on /stereo/left"):
        open_recording(tmp_path)


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("run.bag", b"#ROSBAG V2.0\n"),
        ("run.mcap", b"\x89MCAP0\r\n"),
        ("run.bag", b"x"),
        ("run.db3", b""),
    ],
)
def test_a_damaged_bag_is_refused_in_a_line(name: str, data: bytes, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises(RecordingError) as refused:
        open_recording(tmp_path / name)
    assert str(refused.value).startswith(str(tmp_path / name))
    assert "\n" not in str(refused.value)


def test_a_bag_cut_short_is_refused_or_read(tmp_path: Path, footage: Footage) -> None:
    path = write_rosbag1(tmp_path, footage)
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    with pytest.raises(RecordingError, match="damaged or cut short"):
        open_recording(path)


def test_an_image_that_is_damaged_is_the_one_before(tmp_path: Path, footage: Footage) -> None:
    path = write_rosbag1(tmp_path, footage, compressed=True)
    data = bytearray(path.read_bytes())
    starts = [at for at in range(len(data)) if data[at : at + 8] == b"\x89PNG\r\n\x1a\n"]
    data[starts[4] : starts[4] + 8] = bytes(8)  # the left one of frame 2
    path.write_bytes(data)
    with open_recording(path) as recording:
        frames = list(recording.frames())
        assert (frames[2].left == footage.left[1]).all()
        assert (frames[3].left == footage.left[3]).all()
        assert any("1 broken frame, first 2" in note for note in recording.notes)


def test_without_the_libraries_the_extra_is_named(
    tmp_path: Path, footage: Footage, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_rosbag1(tmp_path / "bag", footage)
    hidden = tmp_path / "hidden" / "rosbags"
    hidden.mkdir(parents=True)
    (hidden / "__init__.py").write_text("raise ImportError('not installed')\n")
    monkeypatch.setenv("PYTHONPATH", str(hidden.parent))
    with pytest.raises(RecordingError, match="the extra bags: pip install rosbags mcap"):
        open_recording(path)


def test_camera_info_is_a_calibration_that_a_manifest_may_name(
    tmp_path: Path, footage: Footage
) -> None:
    write_rosbag1(tmp_path, footage)
    text = '[left]\nsource = "run.bag"\n[calibration]\nfile = "run.bag"\n'
    (tmp_path / "recording.toml").write_text(text)
    with open_recording(tmp_path) as recording:
        assert_calibration(recording.calibration, footage)


def test_a_bag_without_camera_info_has_no_calibration(tmp_path: Path, footage: Footage) -> None:
    path = write_rosbag1(tmp_path, footage)
    data = path.read_bytes()
    path.write_bytes(data.replace(b"sensor_msgs/CameraInfo", b"sensor_msgs/CameraNono"))
    with open_recording(path) as recording:
        assert recording.calibration is None
        assert_frames(recording, footage)
    (tmp_path / "recording.toml").write_text(
        '[left]\nsource = "run.bag"\n[calibration]\nfile = "run.bag"\n'
    )
    with pytest.raises(CalibrationError, match="no camera_info of all its cameras"):
        open_recording(tmp_path)


def test_a_large_bag_opens_again_by_what_is_kept(
    tmp_path: Path, footage: Footage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(bag_contents, "_LEAST_MESSAGES", 1)
    path = write_rosbag1(tmp_path, footage)
    for _ in range(2):
        with open_recording(path, FLOOR) as recording:
            assert_frames(recording, footage)
            assert_times(recording, footage)
            assert_calibration(recording.calibration, footage)
        assert len(list((tmp_path / "cache" / "trackwright" / "bags").iterdir())) == 1
    kept = next((tmp_path / "cache" / "trackwright" / "bags").iterdir())
    kept.write_bytes(kept.read_bytes()[:500])
    with open_recording(path) as recording:
        assert_frames(recording, footage)


@pytest.mark.parametrize("place", ["above", "linked"])
def test_times_are_read_inside_the_recording_alone(
    place: str, tmp_path: Path, footage: Footage
) -> None:
    drive = write_kitti(tmp_path / "strange", footage)
    folder = tmp_path / "run"
    shutil.copytree(drive / "image_02" / "data", folder if place == "above" else folder / "left")
    source = "*.png" if place == "above" else "left/*.png"
    (folder / "recording.toml").write_text(f'[left]\nsource = "{source}"\n')
    times = drive / "image_02" / "timestamps.txt"
    if place == "above":
        shutil.copy(times, tmp_path)
    else:
        (folder / "timestamps.txt").symlink_to(times)
    with pytest.raises(RecordingError, match="do not say how fast"):
        open_recording(folder)


def test_times_of_images_in_a_tar_are_those_of_their_names(
    tmp_path: Path, footage: Footage, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_oak_tar(tmp_path, footage)
    asked: list[Path] = []
    monkeypatch.setattr(time_stamps, "_text", lambda path: asked.append(path))
    with open_recording(path) as recording:
        assert_times(recording, footage)
    assert asked == []


def test_images_beside_a_metadata_of_another_program_open(tmp_path: Path, footage: Footage) -> None:
    folder = write_oak(tmp_path, footage) / "left"
    (folder / "metadata.yaml").write_text("camera: left\n# no rosbag2_bagfile_information:\n")
    with open_recording(folder) as recording:
        assert_frames(recording, footage)


def test_a_number_of_many_digits_is_no_time(tmp_path: Path, footage: Footage) -> None:
    write_euroc(tmp_path, footage)
    table = tmp_path / "mav0" / "cam0" / "data.csv"
    table.write_text(table.read_text().replace("17000", "1" * 5000, 1))
    with open_recording(tmp_path) as recording:
        assert_frames(recording, footage)
