"""Recordings as folders."""

from __future__ import annotations

import csv
import tomllib
from pathlib import Path

import av
import numpy as np
import pytest

from tracking.errors import CancelledError, OutputError, SettingsError
from tracking.formats import read_mot
from tracking.geometry import read_calibration
from tracking.recording import open_recording
from tracking.synthesis import SCENES, Scene, render_recording

SMALL = (160, 120)


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("rendered") / "plaza"
    return render_recording(folder, "plaza", 5.0, 5, 7, size=SMALL)


def _decoded(path: Path) -> list[np.ndarray]:
    with av.open(str(path)) as video:
        return [frame.to_ndarray(format="bgr24") for frame in video.decode(video=0)]


def test_the_folder_holds_what_a_rendered_recording_holds(
    recording: Path, shared_data: Path
) -> None:
    reference = shared_data / "rendered-plaza"
    assert {p.name for p in recording.iterdir()} == {p.name for p in reference.iterdir()}
    for name in ("truth_parts.csv", "visibility.csv"):
        ours, theirs = ((f / name).read_text().splitlines()[0] for f in (recording, reference))
        assert ours == theirs


def test_the_videos_show_the_scene_s_frames(recording: Path) -> None:
    scene = Scene(SCENES["plaza"], 5, 7, seconds=5.0, size=SMALL)
    left, right = _decoded(recording / "left.mp4"), _decoded(recording / "right.mp4")
    assert len(left) == len(right) == 100
    frame, _ = scene.frame(90)
    assert frame.right is not None
    for shown, drawn in ((left, frame.left), (right, frame.right)):
        away = [np.abs(shown[n].mean(axis=2) - drawn.mean(axis=2)).mean() for n in range(85, 95)]
        assert int(np.argmin(away)) == 5
        assert away[5] < 3.0


def test_the_manifest_and_calibration_say_what_the_camera_is(recording: Path) -> None:
    manifest = tomllib.loads((recording / "recording.toml").read_text())
    assert manifest["format"] == 1
    assert manifest["fps"] == 20.0
    assert (manifest["ground"]["height"], manifest["ground"]["tilt"]) == (6.4, 60.0)
    calibration = read_calibration([recording / manifest["calibration"]["file"]])
    assert calibration.left.size == SMALL
    assert calibration.translation[0] == pytest.approx(-0.12)


def test_it_opens_as_a_recording(recording: Path) -> None:
    with open_recording(recording) as opened:
        assert (opened.frame_count, opened.fps, opened.size) == (100, 20.0, SMALL)
        assert opened.is_stereo
        assert opened.notes == ()
        assert opened.truth_path == recording / "truth.txt"
        assert opened.rectification is not None
        assert opened.rectification.identity
        shown = opened.read(77)
    drawn, _ = Scene(SCENES["plaza"], 5, 7, seconds=5.0, size=SMALL).frame(77)
    assert np.abs(shown.left.astype(float) - drawn.left).mean() < 4.0


def test_the_truth_text_is_the_scene_s_truth(recording: Path) -> None:
    columns = read_mot(recording / "truth.txt")
    _, truth = Scene(SCENES["plaza"], 5, 7, seconds=5.0, size=SMALL).frame(90)
    rows = columns["frame"] == 90
    assert np.array_equal(columns["track"][rows], truth.track)
    for column, name in enumerate(("left", "top", "width", "height")):
        assert columns[name][rows] == pytest.approx(truth.box[:, column], abs=0.006)
    assert columns["x"][rows] == pytest.approx(truth.position[:, 0], abs=1e-4)
    assert (columns["z"] == 0).all()


def test_who_is_hardly_seen_is_a_don_t_care(recording: Path) -> None:
    columns = read_mot(recording / "truth.txt")
    with (recording / "visibility.csv").open() as stream:
        shares = [float(row["visibility"]) for row in csv.DictReader(stream)]
    assert len(shares) == len(columns["frame"])
    assert np.array_equal(columns["confidence"] > 0, np.array(shares) >= 0.3)


def test_a_cancelled_recording_leaves_nothing(tmp_path: Path) -> None:
    asked = iter([False] * 5 + [True] * 99)
    with pytest.raises(CancelledError):
        render_recording(
            tmp_path / "out", "lobby", 2.0, 2, 1, cancelled=lambda: next(asked), size=SMALL
        )
    assert list(tmp_path.iterdir()) == []


def test_folders_made_on_the_way_to_a_cancelled_recording_go_again(tmp_path: Path) -> None:
    with pytest.raises(CancelledError):
        render_recording(
            tmp_path / "a" / "b" / "out", "lobby", 2.0, 2, 1, cancelled=lambda: True, size=SMALL
        )
    assert list(tmp_path.iterdir()) == []


def test_a_failure_on_the_way_leaves_nothing(tmp_path: Path) -> None:
    def fails(done: int, total: int) -> None:
        if done == 3:
            raise OSError(28, "No space left on device")

    with pytest.raises(OutputError, match="No space left"):
        render_recording(tmp_path / "out", "lobby", 2.0, 2, 1, fails, size=SMALL)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_with_something_in_it_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(OutputError, match="not an empty folder"):
        render_recording(tmp_path, "lobby", 1.0, 1, 1, size=SMALL)
    assert [p.name for p in tmp_path.iterdir()] == ["mine.txt"]


def test_an_empty_folder_is_filled_and_progress_told(tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    folder = tmp_path / "out"
    folder.mkdir()
    render_recording(folder, "ceiling", 0.5, 1, 1, lambda *done: told.append(done), size=SMALL)
    assert told == [(n, 10) for n in range(1, 11)]
    assert (folder / "recording.toml").is_file()


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"scene": "attic"}, "choose one of lobby"),
        ({"seconds": 0.0}, "seconds"),
        ({"people": -1}, "people"),
        ({"size": (321, 240)}, "even"),
        ({"fps": 0.0}, "fps"),
    ],
)
def test_numbers_out_of_range_are_refused(
    tmp_path: Path, wrong: dict[str, object], told: str
) -> None:
    asked = {"scene": "lobby", "seconds": 1.0, "people": 1, **wrong}
    with pytest.raises(SettingsError, match=told):
        render_recording(tmp_path / "out", **asked)
    assert list(tmp_path.iterdir()) == []
