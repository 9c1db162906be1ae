"""Every kind of recording opens; what is wrong with one is told in a line."""

from __future__ import annotations

import shutil
from math import inf, nan
from pathlib import Path

import cv2
import numpy as np
import pytest
from numbered_videos import number_in, numbered_picture, write_video
from small_recordings import (
    COUNT,
    RIGHT_OFFSET,
    numbers_of,
    ones,
    pairs,
    rig,
    write_images,
    write_pair,
)

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import StereoCalibration, write_calibration
from tracking.recording import (
    Manifest,
    OpenOptions,
    open_from_manifest,
    open_recording,
    parse_manifest,
    write_manifest,
)


def test_two_videos(tmp_path: Path) -> None:
    write_pair(tmp_path)
    write_manifest(tmp_path, Manifest("Hall", "left.mp4", "right.mp4"))
    with open_recording(tmp_path) as recording:
        assert recording.is_stereo
        assert (recording.name, recording.fps, recording.size) == ("Hall", 25.0, (128, 96))
        assert recording.duration_s == pytest.approx(COUNT / 25)
        assert recording.calibration is None
        assert recording.notes == ()
        assert numbers_of(recording) == pairs()
        frame = recording.read(7)
        assert frame.right is not None
        assert (frame.number, frame.time_s) == (7, pytest.approx(7 / 25))
        assert (number_in(frame.left), number_in(frame.right)) == (7, 7 + RIGHT_OFFSET)


def test_two_image_folders_by_glob(tmp_path: Path) -> None:
    write_images(tmp_path / "left", range(COUNT))
    write_images(tmp_path / "right", range(COUNT), RIGHT_OFFSET)
    write_manifest(tmp_path, Manifest("Hall", "left/*.png", "right/*.png", fps=10.0))
    with open_recording(tmp_path) as recording:
        assert numbers_of(recording) == pairs()
        assert recording.sources == (tmp_path / "left", tmp_path / "right")


@pytest.mark.parametrize("first", ["left", "right"])
@pytest.mark.parametrize(("layout", "axis"), [("side-by-side", 1), ("top-bottom", 0)])
def test_one_video_with_both_cameras(tmp_path: Path, layout: str, first: str, axis: int) -> None:
    both = []
    for number in range(COUNT):
        cameras = [numbered_picture(number), numbered_picture(number + RIGHT_OFFSET)]
        both.append(np.concatenate(cameras if first == "left" else cameras[::-1], axis))
    write_video(tmp_path / "both.mp4", [], pictures=both)
    (tmp_path / "recording.toml").write_text(
        f'[stereo]\nsource = "both.mp4"\nlayout = "{layout}"\nfirst = "{first}"\n'
    )
    with open_recording(tmp_path) as recording:
        assert recording.size == (128, 96)
        assert numbers_of(recording) == pairs()
        assert number_in(recording.read(5).left) == 5


def by_turns(layout: str, left: np.ndarray, right: np.ndarray) -> list[np.ndarray]:
    """The images of one instant in a video that holds both cameras."""
    if layout == "frame-sequential":
        return [left, right]
    both = left.copy()
    both[1::2] = right[1::2]
    return [both]


@pytest.mark.parametrize("first", ["left", "right"])
@pytest.mark.parametrize("layout", ["row-interleaved", "frame-sequential"])
def test_one_video_with_both_cameras_by_turns(tmp_path: Path, layout: str, first: str) -> None:
    both: list[np.ndarray] = []
    for number in range(COUNT):
        cameras = [numbered_picture(number), numbered_picture(number + RIGHT_OFFSET)]
        both += by_turns(layout, *(cameras if first == "left" else cameras[::-1]))
    for number, image in enumerate(both):
        cv2.imwrite(str(tmp_path / f"{number:03}.png"), image)
    (tmp_path / "recording.toml").write_text(
        f'fps = 10\n[stereo]\nsource = "*.png"\nlayout = "{layout}"\nfirst = "{first}"\n'
    )
    with open_recording(tmp_path) as recording:
        assert recording.size == (128, 96)
        assert recording.frame_count == COUNT
        assert numbers_of(recording) == pairs()
        assert number_in(recording.read(5).left) == 5
        late = [frame.right for frame in recording.frames(2, 6, lag=1)]
        assert [number_in(right) - RIGHT_OFFSET for right in late] == [3, 4, 5, 6]


def test_frames_by_turns_come_half_as_often(tmp_path: Path) -> None:
    video = write_video(tmp_path / "v.mp4", range(COUNT), fps=20)
    with open_recording(video, OpenOptions(layout="frame-sequential")) as recording:
        assert recording.fps == pytest.approx(10.0)
        assert recording.read(2).time_s == pytest.approx(0.2)
        assert len(recording.sources) == 1


def test_a_bare_video_and_one_with_both_cameras_by_option(tmp_path: Path) -> None:
    video = write_video(tmp_path / "v.mp4", range(COUNT))
    with open_recording(video) as recording:
        assert recording.name == "v"
        assert not recording.is_stereo
        assert numbers_of(recording) == ones()
    with open_recording(video, OpenOptions(layout="top-bottom")) as recording:
        assert recording.is_stereo
        assert recording.size == (128, 48)


def test_an_image_folder_needs_to_be_told_its_rate(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "images", range(COUNT))
    with pytest.raises(RecordingError, match="fps"):
        open_recording(folder)
    with open_recording(folder, OpenOptions(fps=5.0)) as recording:
        assert numbers_of(recording) == ones()
        assert recording.read(3).time_s == pytest.approx(0.6)


def test_a_folder_with_left_and_right_needs_no_manifest(tmp_path: Path) -> None:
    write_pair(tmp_path)
    with open_recording(tmp_path) as recording:
        assert numbers_of(recording) == pairs()


@pytest.mark.parametrize("tree", ["raw", "odometry", "tracking"])
def test_kitti_sequences(tmp_path: Path, tree: str) -> None:
    calib = "P2: 100 0 64 0 0 100 48 0 0 0 1 0\nP3: 100 0 64 -54 0 100 48 0 0 0 1 0\n"
    left, right, text, opened = {
        "raw": ("image_02/data", "image_03/data", "calib.txt", ""),
        "odometry": ("image_2", "image_3", "calib.txt", ""),
        "tracking": ("image_02/0000", "image_03/0000", "calib/0000.txt", "image_02/0000"),
    }[tree]
    write_images(tmp_path / left, range(COUNT))
    write_images(tmp_path / right, range(COUNT), RIGHT_OFFSET)
    (tmp_path / text).parent.mkdir(exist_ok=True)
    (tmp_path / text).write_text(calib)
    with open_recording(tmp_path / opened) as recording:
        assert numbers_of(recording) == pairs()
        assert recording.fps == 10
        assert recording.rectification is not None
        assert recording.rectification.baseline_m == pytest.approx(0.54)
        assert "P2" in recording.calibration_text


def test_the_rate_taken_for_granted_of_kitti_is_told_unless_the_user_says_it(
    tmp_path: Path,
) -> None:
    write_images(tmp_path / "image_02", range(COUNT))
    with open_recording(tmp_path) as recording:
        assert any("10, as KITTI has" in note for note in recording.notes)
    with open_recording(tmp_path, OpenOptions(fps=5)) as recording:
        assert recording.notes == ()


@pytest.mark.parametrize("half", ["", "training"])
def test_the_only_sequence_of_a_kitti_tree_opens(tmp_path: Path, half: str) -> None:
    write_images(tmp_path / half / "image_02" / "0007", range(COUNT))
    with open_recording(tmp_path) as recording:
        assert (recording.name, recording.frame_count) == ("0007", COUNT)


def test_of_several_kitti_sequences_one_must_be_named(tmp_path: Path) -> None:
    for name in ("0000", "0001"):
        write_images(tmp_path / "training" / "image_02" / name, range(2))
    with pytest.raises(RecordingError, match=r"2 KITTI sequences; open one of them, .*0000"):
        open_recording(tmp_path)


def test_bare_files_with_options(tmp_path: Path) -> None:
    write_pair(tmp_path)
    write_calibration(tmp_path / "c.yaml", rig())
    options = OpenOptions(
        left=tmp_path / "left.mp4",
        right=tmp_path / "right.mp4",
        calibration=(tmp_path / "c.yaml",),
        height_m=2.4,
        tilt_deg=30.0,
    )
    with open_recording(tmp_path, options) as recording:
        assert numbers_of(recording) == pairs()
        assert recording.view is not None
        assert recording.ground is not None
        assert recording.ground.height_m == 2.4
        assert recording.rectification is not None
        assert 'source = "right.mp4"' in recording.manifest_text
        assert "height = 2.4" in recording.manifest_text


def test_options_overrule_the_manifest(tmp_path: Path) -> None:
    write_pair(tmp_path)
    (tmp_path / "recording.toml").write_text(
        '[left]\nsource = "left.mp4"\n[ground]\nheight = 2\ntilt = 20\nroll = 3\n'
    )
    with open_recording(tmp_path, OpenOptions(tilt_deg=45.0, fps=50.0)) as recording:
        assert recording.ground is not None
        assert recording.ground.tilt_deg == 45
        assert (recording.ground.height_m, recording.ground.roll_deg) == (2, 3)
        assert recording.fps == 50


@pytest.mark.parametrize("fps", [nan, -1.0, 0.0, 1e99, inf])
def test_a_rate_no_camera_has_is_refused_among_the_options_as_in_the_manifest(
    tmp_path: Path, fps: float
) -> None:
    video = write_video(tmp_path / "v.mp4", range(3))
    wanted = "fps must be 0.001 to 10000 frames per second$"
    with pytest.raises(RecordingError, match=f"^--{wanted}"):
        open_recording(video, OpenOptions(fps=fps))
    with pytest.raises(RecordingError, match=f"^recording.toml: {wanted}"):
        parse_manifest(f'fps = {fps!r}\n[left]\nsource = "v.mp4"\n', "recording.toml", "v")


@pytest.mark.parametrize("height_m", [1e99, 3e5, 1000.5, nan, 0.0])
def test_a_camera_higher_than_any_is_refused_among_the_options(
    tmp_path: Path, height_m: float
) -> None:
    video = write_video(tmp_path / "v.mp4", range(3))
    with pytest.raises(CalibrationError, match="give the camera's height above the floor"):
        open_recording(video, OpenOptions(height_m=height_m, tilt_deg=30.0))


def test_half_a_floor_among_the_options_is_refused(tmp_path: Path) -> None:
    video = write_video(tmp_path / "v.mp4", range(3))
    with pytest.raises(RecordingError, match="--tilt"):
        open_recording(video, OpenOptions(height_m=2.0))


def test_a_calibration_of_another_resolution_is_scaled_and_told(tmp_path: Path) -> None:
    write_pair(tmp_path)
    write_calibration(tmp_path / "c.yaml", rig((640, 480)))
    options = OpenOptions(calibration=(tmp_path / "c.yaml",))
    with open_recording(tmp_path, options) as recording:
        calibration = recording.calibration
        assert calibration is not None
        assert calibration.left.size == (128, 96)
        assert calibration.left.matrix[0, 0] == pytest.approx(rig((640, 480)).left.matrix[0, 0] / 5)
        assert any("scaled" in str(note) for note in recording.notes)


def test_a_calibration_of_the_wrong_size_is_refused(tmp_path: Path) -> None:
    write_pair(tmp_path)
    write_calibration(tmp_path / "c.yaml", rig((640, 400)))
    with pytest.raises(CalibrationError, match=r"640 x 400.*128 x 96"):
        open_recording(tmp_path, OpenOptions(calibration=(tmp_path / "c.yaml",)))


def test_one_camera_takes_the_left_camera_of_a_rig_and_two_cameras_need_both(
    tmp_path: Path,
) -> None:
    write_pair(tmp_path)
    write_calibration(tmp_path / "both.yaml", rig())
    write_calibration(tmp_path / "one.yaml", StereoCalibration.of_one(rig().left))
    one_camera = OpenOptions(calibration=(tmp_path / "both.yaml",), height_m=2.0, tilt_deg=30.0)
    with open_recording(tmp_path / "left.mp4", one_camera) as recording:
        assert recording.view is not None
        assert recording.rectification is None
    with open_recording(tmp_path, OpenOptions(calibration=(tmp_path / "one.yaml",))) as recording:
        assert recording.rectification is None
        assert any("no depth" in note for note in recording.notes)


def test_a_recording_opens_from_its_folder_and_the_manifest_a_session_keeps(
    tmp_path: Path,
) -> None:
    write_pair(tmp_path)
    options = OpenOptions(left=tmp_path / "left.mp4", right=tmp_path / "right.mp4", fps=5.0)
    with open_recording(tmp_path, options) as first:
        text, folder = first.manifest_text, first.folder
    with open_from_manifest(folder, text) as again:
        assert numbers_of(again) == pairs()
        assert again.fps == 5


def test_a_kept_manifest_leads_to_pictures_by_another_name(tmp_path: Path) -> None:
    options = OpenOptions(fps=5.0)
    with open_recording(write_video(tmp_path / "v.mp4", range(COUNT)), options) as first:
        text = first.manifest_text
        assert not first.own_manifest
    renamed = (tmp_path / "v.mp4").rename(tmp_path / "w.mp4")
    with open_from_manifest(renamed, text) as again:
        assert (numbers_of(again), again.fps) == (ones(), 5)
        assert again.path == renamed
        text = again.manifest_text
    with open_from_manifest(tmp_path, text) as again:
        assert again.path == renamed


def test_a_manifest_made_of_options_never_climbs_out_of_its_folder(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "recording"
    folder.mkdir(parents=True)
    write_pair(folder)
    write_manifest(folder, Manifest("Hall", "left.mp4", "right.mp4"))
    write_calibration(tmp_path / "rigs.yaml", rig())
    with open_recording(folder) as own:
        assert own.own_manifest
    with open_recording(folder, OpenOptions(calibration=(tmp_path / "rigs.yaml",))) as recording:
        assert not recording.own_manifest
        assert (recording.path, recording.folder) == (folder, tmp_path)
        assert ".." not in recording.manifest_text
        text = recording.manifest_text
    with open_from_manifest(tmp_path, text) as again:
        assert again.rectification is not None
        assert again.name == "Hall"


def test_a_closed_recording_says_so(tmp_path: Path) -> None:
    recording = open_recording(write_video(tmp_path / "v.mp4", range(5)))
    recording.close()
    with pytest.raises(RecordingError, match="closed"):
        recording.read(0)


def test_frames_out_of_range_are_told(tmp_path: Path) -> None:
    with open_recording(write_video(tmp_path / "v.mp4", range(5))) as recording:
        with pytest.raises(RecordingError, match="only 0 to 4"):
            recording.read(5)
        with pytest.raises(RecordingError, match="not within 0 to 5"):
            next(recording.frames(3, 9))


def test_a_fingerprint_knows_a_source_again_and_sees_its_ends_change(tmp_path: Path) -> None:
    write_pair(tmp_path)
    first = open_recording(tmp_path).fingerprints()
    assert [f.source for f in first] == ["left.mp4", "right.mp4"]
    assert first[0].size_bytes == (tmp_path / "left.mp4").stat().st_size
    copied = shutil.copytree(tmp_path, tmp_path.with_name("copied"))
    assert open_recording(copied).fingerprints() == first
    with (copied / "left.mp4").open("ab") as file:
        file.write(b"\x00" * 8)
    second = open_recording(copied).fingerprints()
    assert second[0] != first[0]
    assert second[1] == first[1]


@pytest.mark.parametrize(
    ("name", "count", "fps", "stereo", "on_the_floor"),
    [
        ("rendered-lobby", 600, 20, True, True),
        ("rendered-plaza", 600, 20, True, True),
        ("overhead-real", 627, 30, True, True),
        ("pets-s2l1-real", 795, 7, False, True),
        ("tud-campus-real", 71, 25, False, False),
    ],
)
def test_the_test_recordings_open_and_seek(
    shared_data: Path, name: str, count: int, fps: float, stereo: bool, on_the_floor: bool
) -> None:
    with open_recording(shared_data / name) as recording:
        assert (recording.frame_count, recording.fps) == (count, fps)
        assert recording.is_stereo == stereo
        assert (recording.view is not None) == on_the_floor
        assert (recording.rectification is not None) == stereo
        for frame in recording.frames(count - 40, count - 36):
            np.testing.assert_array_equal(recording.read(frame.number).left, frame.left)


def test_the_oddities_of_the_test_recordings_are_told(shared_data: Path) -> None:
    with open_recording(shared_data / "overhead-real") as recording:
        assert sum("letterboxed" in note for note in recording.notes) == 2
    with open_recording(shared_data / "pets-s2l1-real") as recording:
        assert any("recording.toml says 7" in note for note in recording.notes)
        assert recording.truth_path == shared_data / "pets-s2l1-real" / "truth.txt"
    with open_recording(shared_data / "rendered-lobby") as recording:
        assert recording.notes == ()
