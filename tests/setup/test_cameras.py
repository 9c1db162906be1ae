"""Cameras found by their names and by what they show; recording.toml written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.errors import RecordingError
from tracking.geometry import Camera, Ground, StereoCalibration, write_calibration
from tracking.recording import open_recording, read_manifest
from tracking.setup import SetupPlan, cameras, find_cameras, pair_by_name, plan_of, write_setup
from tracking.setup.plan import options_of_plan
from tracking.synthesis import render_recording

Images = list[np.ndarray]


@pytest.fixture(scope="module")
def views(tmp_path_factory: pytest.TempPathFactory) -> tuple[Images, Images]:
    """A few frames of a rendered pair, left and right."""
    folder = tmp_path_factory.mktemp("clips") / "lobby"
    with open_recording(render_recording(folder, "lobby", 2.0, 2, 5)) as recording:
        frames = [recording.read(number) for number in range(0, recording.frame_count, 8)]
    return [frame.left for frame in frames], [f.right for f in frames if f.right is not None]


@pytest.fixture
def write(tmp_path: Path) -> Callable[[str, Images], Path]:
    """Writes images as a folder of that name."""

    def written(name: str, images: Images) -> Path:
        folder = tmp_path / name
        folder.mkdir()
        for number, image in enumerate(images):
            cv2.imwrite(str(folder / f"{number:04}.png"), image)
        return folder

    return written


@pytest.mark.parametrize(
    ("names", "sides_told"),
    [
        (("left.mp4", "right.mp4"), True),
        (("lobby_L.mp4", "lobby_R.mp4"), True),
        (("cam0.avi", "cam1.avi"), False),
        (("2024-05-01 camera1.mp4", "2024-05-01 camera2.mp4"), False),
        (("GX010034.MP4", "GX010187.MP4"), False),
    ],
)
def test_pairs_are_told_by_their_names(names: tuple[str, str], sides_told: bool) -> None:
    for given in (names, names[::-1]):
        pair = pair_by_name([Path(name) for name in given])
        assert pair is not None
        assert (pair.left.name, pair.right.name, pair.sides_told) == (*names, sides_told)


@pytest.mark.parametrize("names", [("lobby.mp4", "street.mp4"), ("a1.mp4", "a2.mp4", "a3.mp4")])
def test_files_that_are_no_pair_by_name_are_none(names: tuple[str, ...]) -> None:
    assert pair_by_name([Path(name) for name in names]) is None


def test_which_camera_is_left_is_found_from_the_images(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    left, right = write("a", views[0]), write("b", views[1])
    for given in ((left, right), (right, left)):
        found = find_cameras(*given)
        assert (found.left, found.right) == (left, right)
        assert found.swapped == (given[0] == right)
        assert found.doubts == ()


def test_names_of_sides_count_where_the_images_do_not_tell_them_for_sure(
    views: tuple[Images, Images],
    write: Callable[[str, Images], Path],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(cameras, "_is_swapped", lambda _: (True, False))
    left, right = write("L_0001", views[0]), write("R_0001", views[1])
    for given in ((left, right), (right, left)):
        found = find_cameras(*given)
        assert (found.left, found.right) == (left, right)
        (doubt,) = found.doubts
        assert f"{left.name} is taken; as the names say" in doubt
        assert "is the left camera" not in " ".join(found.notes)
    one, other = write("a", views[0]), write("b", views[1])
    found = find_cameras(one, other)
    assert (found.left, found.swapped) == (other, True)
    assert "exchange them if that is wrong" in found.doubts[0]


def test_a_height_that_was_likely_typed_in_centimetres_is_told(tmp_path: Path) -> None:
    plan = SetupPlan(tmp_path / "a.mp4", ground=Ground(240.0, 30.0))
    assert any("give 2.4 m" in note for note in plan.notes)
    assert replace(plan, ground=Ground(2.4, 30.0)).notes == ()


@pytest.mark.parametrize(
    ("layout", "first"),
    [("side-by-side", "left"), ("side-by-side", "right"), ("top-bottom", "left")],
)
def test_both_cameras_in_one_image_are_found(
    layout: str, first: str, views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    axis = 1 if layout == "side-by-side" else 0
    sides = views if first == "left" else views[::-1]
    both = [np.concatenate(pair, axis=axis) for pair in zip(*sides, strict=True)]
    found = find_cameras(write("both", both), None)
    assert (found.layout, found.left_first) == (layout, first == "left")


@pytest.mark.parametrize("first", ["left", "right"])
@pytest.mark.parametrize("layout", ["row-interleaved", "frame-sequential"])
def test_both_cameras_by_turns_are_found(
    layout: str, first: str, views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    both: list[np.ndarray] = []
    for one, other in zip(*(views if first == "left" else views[::-1]), strict=True):
        if layout == "frame-sequential":
            both += [one, other]
        else:
            rows = one.copy()
            rows[1::2] = other[1::2]
            both.append(rows)
    found = find_cameras(write("both", both), None)
    assert (found.layout, found.left_first) == (layout, first == "left")


def test_one_camera_is_one(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    assert find_cameras(write("one", views[0]), None).layout is None


def test_a_camera_upside_down_or_mirrored_is_told(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    left = write("left", views[0])
    turned = find_cameras(left, write("turned", [image[::-1, ::-1] for image in views[1]]))
    assert any("turned by" in str(doubt) for doubt in turned.doubts)
    mirrored = find_cameras(left, write("mirrored", [image[:, ::-1] for image in views[1]]))
    assert any("mirrored" in str(doubt) for doubt in mirrored.doubts)


def test_two_of_different_scenes_are_told(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    random = np.random.default_rng(1)
    noise = [cv2.resize(random.integers(0, 255, (30, 40, 3), np.uint8), (640, 480))] * 4
    found = find_cameras(write("left", views[0]), write("noise", noise))
    assert found.same_scene is False


def test_cameras_of_different_sizes_are_refused(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    small = [image[:100, :100] for image in views[1]]
    with pytest.raises(RecordingError, match="a pair has one size"):
        find_cameras(write("left", views[0]), write("small", small))


def test_what_is_written_opens_and_is_read_back(
    views: tuple[Images, Images], write: Callable[[str, Images], Path], tmp_path: Path
) -> None:
    left, right = write("left", views[0]), write("right", views[1])
    plan = SetupPlan(left, right, "Hall, north", lag=1, fps=20.0, ground=Ground(2.4, 30.0))
    path = write_setup(plan)
    assert path == tmp_path / "recording.toml"
    with open_recording(tmp_path) as recording:
        assert (recording.name, recording.right_lag) == ("Hall, north", 1)
    assert plan_of(tmp_path) == replace(plan, at=tmp_path)
    with pytest.raises(RecordingError, match="--force"):
        write_setup(plan)
    write_setup(plan, replace_old=True)


def test_a_camera_that_is_black_at_first_is_told(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    black = [np.zeros_like(views[0][0])] * 3
    found = find_cameras(write("left", black + views[0]), write("right", [*black, *views[1]]))
    told = [str(note) for note in found.notes]
    assert sum("is black at first, until frame 5" in note for note in told) == 2


def test_a_calibration_from_elsewhere_is_written_beside_and_nothing_there_is_replaced(
    views: tuple[Images, Images], write: Callable[[str, Images], Path], tmp_path: Path
) -> None:
    left = write("left", views[0])
    elsewhere = tmp_path.parent / f"{tmp_path.name}-elsewhere"
    elsewhere.mkdir()
    file = elsewhere / "mine.yaml"
    matrix = np.array([[500.0, 0, 320], [0, 500, 240], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), views[0][0].shape[1], views[0][0].shape[0])
    write_calibration(file, StereoCalibration.of_one(camera))
    (tmp_path / "calibration.yaml").write_text("of somebody else")
    write_setup(SetupPlan(left, fps=20.0, calibration=(file,)))
    assert read_manifest(tmp_path).calibration == ("calibration-2.yaml",)
    assert (tmp_path / "calibration.yaml").read_text() == "of somebody else"
    with open_recording(tmp_path) as recording:
        assert recording.calibration is not None
    write_setup(SetupPlan(left, fps=25.0, calibration=(file,)), replace_old=True)
    assert read_manifest(tmp_path).calibration == ("calibration-2.yaml",)
    assert not (tmp_path / "calibration-3.yaml").exists()
    write_calibration(
        file, StereoCalibration.of_one(replace(camera, matrix=matrix * [[1.1], [1.1], [1.0]]))
    )
    write_setup(SetupPlan(left, fps=25.0, calibration=(file,)), replace_old=True)
    assert read_manifest(tmp_path).calibration == ("calibration-3.yaml",)


def test_a_lag_that_was_found_counts_before_it_is_written(
    views: tuple[Images, Images], write: Callable[[str, Images], Path]
) -> None:
    plan = SetupPlan(write("left", views[0]), write("right", views[1]), lag=2, fps=20.0)
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        assert recording.right_lag == 2


def test_somebodys_own_text_is_kept_where_it_is_set_up_again(
    views: tuple[Images, Images], write: Callable[[str, Images], Path], tmp_path: Path
) -> None:
    write_setup(SetupPlan(write("left", views[0]), ground=Ground(2.0, 30.0)))
    path = tmp_path / "recording.toml"
    text = path.read_text().replace("tilt = 30.0", 'tilt = 30.0 # by level\npole = "[x]"')
    path.write_text(text + "\n[extra.table]\nlist = [1,\n  2]\n")
    plan = plan_of(tmp_path)
    write_setup(replace(plan, ground=Ground(2.5, 31.0)), replace_old=True)
    text = path.read_text()
    assert "tilt = 31.0  # by level" in text
    assert 'pole = "[x]"' in text
    assert "[extra.table]\nlist = [1,\n  2]" in text
    write_setup(replace(plan, ground=None), replace_old=True)
    assert plan_of(tmp_path).ground is None
    assert '# [ground] pole = "[x]"' in path.read_text()


def test_no_calibration_is_replaced_where_all_names_are_taken(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    names = ["calibration", *(f"calibration-{number}" for number in range(2, 100))]
    for name in names:
        (home / f"{name}.yaml").write_text("of somebody else")
    plan = SetupPlan(home / "left.mp4", calibration=(tmp_path / "mine.yaml",))
    with pytest.raises(RecordingError, match="99 calibrations lie there"):
        write_setup(plan)
    assert not (home / "recording.toml").exists()
