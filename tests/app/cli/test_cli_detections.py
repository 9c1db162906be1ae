"""`track --detections`: boxes of another program, kept in the session and told."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from pathlib import Path

import h5py
import pytest
from command_line import Trackwright

from app.__main__ import run
from tracking.session import Session

ROWS = "".join(f"{n},-1,{20 + n},40,24,60,{0.9 - n / 1000}\n" for n in range(1, 81))
FRAMES = ("--tracker", "three-part", "--frames", "0:6")


@pytest.fixture
def boxes(recording: Path) -> Path:
    path = recording / "det.txt"
    path.write_text(ROWS)
    return path


@pytest.fixture(scope="module")
def tracked(footage: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session tracked with detections of both cameras; not to be changed."""
    folder = tmp_path_factory.mktemp("tracked")
    recording, right = Path(shutil.copytree(footage, folder / "square")), folder / "right.txt"
    for path in (recording / "det.txt", right):
        path.write_text(ROWS)
    words = ("track", recording, "--detections", recording / "det.txt", "--detections-right", right)
    assert run([str(word) for word in (*words, "-o", folder / "s.h5", *FRAMES)]) == 0
    return folder / "s.h5"


def test_the_session_says_which_detections_were_used(tracked: Path) -> None:
    with closing(Session.open(tracked)) as session:
        made = session.runs[0]
        assert made.settings["detections.file"] == "det.txt"
        assert made.settings["detections.file_right"] == str(tracked.parent / "right.txt")
        assert [one.camera for one in made.detections_input] == ["left", "right"]
        said = "det.txt (MOTChallenge text): 80 of 80 boxes are used"
        assert any(said in note for note in made.notes)
    with h5py.File(tracked) as file:
        kept = {name: column[()].tolist() for name, column in file["detections_input"].items()}
    assert kept["file"] == [b"det.txt", b"right.txt"]
    assert (kept["format"], kept["count"], kept["run"]) == ([b"mot"] * 2, [80, 80], [0, 0])
    assert [len(each) for each in kept["fingerprint"]] == [64, 64]


def test_info_tells_them(trackwright: Trackwright, tracked: Path) -> None:
    (info,) = json.loads(trackwright("info", tracked, "--json")[1])["runs"]
    told = info["detections_input"][0]
    assert (told["file"], told["format"], told["count"]) == ("det.txt", "mot", 80)
    said = f"80 boxes of det.txt (mot, {told['fingerprint'][:12]})"
    assert said in trackwright("info", tracked)[1]


def test_they_stay_with_their_run_when_the_session_is_saved_again(
    tracked: Path, tmp_path: Path
) -> None:
    with closing(Session.open(tracked)) as session:
        given = session.runs[0].detections_input
        session.save(tmp_path / "copy.h5")
    with closing(Session.open(tmp_path / "copy.h5")) as session:
        assert session.detections_input == given
        assert session.runs[0].detections_input == given


def test_without_detections_a_session_has_none(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    assert trackwright("track", recording, "-o", out, *FRAMES)[0] == 0
    with h5py.File(out) as file:
        assert "detections_input" not in file


def test_tracking_again_refuses_other_files_and_those_of_the_cameras_swapped(
    trackwright: Trackwright, recording: Path, boxes: Path, tmp_path: Path
) -> None:
    out, right = tmp_path / "s.h5", recording / "right.txt"
    right.write_text(ROWS.replace("24,60", "25,60"))
    both = ("--detections", boxes, "--detections-right", right)
    assert trackwright("track", recording, *both, "-o", out, *FRAMES)[0] == 0
    again = ("track", "--again", out, "--from", "3", "--until", "6")
    assert trackwright(*again)[0] == 0  # with the same ones
    other = Path(shutil.copy(right, recording / "other.txt"))
    swapped = ("--detections", right, "--detections-right", boxes)
    for name, words in (("other.txt", ("--detections", other)), ("right.txt", swapped)):
        status, _, err = trackwright(*again, *words)
        assert status == 2
        said = f"{name} is not the file of detections that the tracks were made with, det.txt"
        assert said in err
    boxes.write_text(ROWS.replace("24,60", "26,60"))
    status, _, err = trackwright(*again)
    assert status == 2
    assert "det.txt is not the file of detections" in err


def test_tracking_again_reads_no_file_outside_that_only_the_session_names(
    trackwright: Trackwright, recording: Path, boxes: Path, tmp_path: Path
) -> None:
    out, outside = tmp_path / "s.h5", Path(shutil.move(boxes, tmp_path / "det.txt"))
    assert trackwright("track", recording, "--detections", outside, "-o", out, *FRAMES)[0] == 0
    again = ("track", "--again", out, "--from", "3", "--until", "6")
    status, _, err = trackwright(*again)
    assert status != 0
    assert "not in the folder of the recording" in err
    assert trackwright(*again, "--allow-outside")[0] == 0
    assert trackwright(*again, "--detections", outside)[0] == 0


def test_links_on_the_way_from_the_recordings_folder_are_not_followed(
    trackwright: Trackwright, recording: Path, boxes: Path, tmp_path: Path
) -> None:
    elsewhere, out = tmp_path / "elsewhere", tmp_path / "s.h5"
    elsewhere.mkdir()
    shutil.move(boxes, elsewhere / "det.txt")
    (recording / "det").symlink_to(elsewhere)
    named = ("--set", "detections.file=det/det.txt")
    status, _, err = trackwright("track", recording, *named, "-o", out, *FRAMES)
    assert status == 1
    assert "is a link, which is not followed" in err
    assert not out.exists()


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("missing.txt", None, "there is no such file"),
        ("cut.json", '[{"image_id": 1, "bbox": [1', "character"),
    ],
)
def test_what_cannot_be_read_ends_in_one_line_and_makes_no_session(
    trackwright: Trackwright, recording: Path, tmp_path: Path, name: str, text: str | None, said
) -> None:
    path, out = tmp_path / name, tmp_path / "s.h5"
    if text is not None:
        path.write_text(text)
    status, printed, err = trackwright("track", recording, "--detections", path, "-o", out, *FRAMES)
    assert (status, printed) == (1, "")
    (line,) = [line for line in err.splitlines() if line.startswith("error")] or [err.strip()]
    assert said in line
    assert name in line
    assert not out.exists()


def test_detections_of_the_right_camera_alone_or_where_there_is_none_are_refused(
    trackwright: Trackwright, recording: Path, boxes: Path, tmp_path: Path
) -> None:
    words = ("-o", tmp_path / "s.h5", *FRAMES)
    status, _, err = trackwright("track", recording, "--detections-right", boxes, *words)
    assert status != 0
    assert "give those of the left one with --detections" in err
    given = ("--detections", boxes, "--detections-right", boxes)
    status, _, err = trackwright("track", recording / "left.mp4", *given, *words)
    assert status != 0
    assert "has one camera" in err


def test_a_score_report_names_them(
    trackwright: Trackwright, footage: Path, tracked: Path, tmp_path: Path
) -> None:
    words = ("--truth", footage / "truth.txt", "--report", tmp_path / "report")
    assert trackwright("score", tracked, *words)[0] == 0
    pages = (tmp_path / "report").glob("*.html")
    assert any("detections det.txt" in page.read_text() for page in pages)
