"""`trackwright score` from end to end."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from command_line import Trackwright

from app.__main__ import run
from app.cli.score_sources import disagreement
from tracking.recording import open_recording
from tracking.scoring.report import Source
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, Run
from tracking.tracks.columns import empty

TRUTH = "".join(f"{n},1,{10 + n},20,30,60,1,{n / 10},5,0\n" for n in range(1, 21))
RESULT = "".join(f"{n},4,{10 + n},22,30,60,1,{n / 10 + 0.1},5,0\n" for n in range(1, 21))


@pytest.fixture
def pair(tmp_path: Path) -> tuple[str, str]:
    (tmp_path / "truth.txt").write_text(TRUTH)
    (tmp_path / "result.txt").write_text(RESULT)
    return str(tmp_path / "result.txt"), str(tmp_path / "truth.txt")


def test_json_is_the_only_thing_on_stdout(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], "--json"]) == 0
    out, err = capsys.readouterr()
    numbers = json.loads(out)
    assert (numbers["MOTA"], numbers["frames"], numbers["people_kept"]) == (1, 20, 1)
    assert numbers["position_error_m"]["mean"] == pytest.approx(0.1)
    assert err == ""


def test_a_truth_that_hardly_anything_matches_is_asked_about(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    elsewhere = "".join(f"{n},1,{900 + n},20,30,60,1,{n / 10},5,0\n" for n in range(1, 21))
    Path(pair[1]).write_text(elsewhere)
    assert run(["score", pair[0], "--truth", pair[1]]) == 0
    err = capsys.readouterr().err
    asked = "0 of 20 rows match the ground truth: is it of the same recording"
    assert asked in err
    Path(pair[1]).write_text("")
    assert run(["score", pair[0], "--truth", pair[1]]) == 0
    err = capsys.readouterr().err
    assert "has nobody in these frames" in err
    assert "same recording" not in err


def test_people_get_a_table(pair: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["score", pair[0], "--truth", pair[1]]) == 0
    assert "tracking_accuracy" in capsys.readouterr().out


def test_floor_distance_can_be_asked_for(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["score", pair[0], "--truth", pair[1], "--json", "--match", "floor", "--radius"]
    assert run([*command, "0.2"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 0
    assert run([*command, "0.05"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 20


def test_a_recordings_folder_stands_for_its_truth(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["score", pair[0], "--truth", str(Path(pair[1]).parent), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 0


@pytest.mark.parametrize(
    ("options", "status", "reason"),
    [
        (["--match", "sound"], 2, "'sound' is not one of"),
        (["--range", "9:3"], 2, "range 9:3 holds no frames"),
        (["--range", "-1:5"], 2, "--range -1:5: frames count from 0"),
        (["--range", "30:40"], 2, "choose one within 0:20"),
        (["--range", "foo"], 2, "'foo' are not A:B, e.g. --range 100:400"),
        (["--distances", "near"], 2, "e.g. --distances 0,5,10"),
        (["--distances", "5,10"], 2, "distances must grow from 0 on"),
        (["--match", "floor", "--radius", "-1"], 2, "radius -1.0 m is not above 0"),
    ],
)
def test_wrong_options_are_told(
    pair: tuple[str, str],
    capsys: pytest.CaptureFixture[str],
    options: list[str],
    status: int,
    reason: str,
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], *options]) == status
    assert reason in " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("missing.txt", None, "No such file"),
        ("notes.txt", b"dear diary, today\n", "line 1: 2 values"),
        ("picture.png", bytes(range(256)), "not text"),
    ],
)
def test_a_wrong_result_is_one_line_and_status_1(
    pair: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    name: str,
    content: bytes | None,
    reason: str,
) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    assert run(["score", str(tmp_path / name), "--truth", pair[1], "--json"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("trackwright: ")
    assert err.count("\n") == 1
    assert name in err
    assert reason in err


def test_a_folder_without_truth_is_told(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "empty").mkdir()
    assert run(["score", pair[0], "--truth", str(tmp_path / "empty")]) == 1
    assert "has no truth.txt" in capsys.readouterr().err


def test_some_frames_are_measured_as_if_there_were_no_others(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    truth = Path(pair[1])
    late = "".join(f"{n},2,300,20,30,60,1,3,9,0\n" for n in range(11, 21))
    truth.write_text(TRUTH + late)
    found = {}
    for frames in ("0:20", ":", "5:10", ":10", "15:"):
        words = ["score", pair[0], "--truth", pair[1], "--frames", frames, "--json"]
        assert run(words) == 0
        numbers = json.loads(capsys.readouterr().out)
        found[frames] = (numbers["frames"], numbers["truth_people"], numbers["misses"])
    assert found["0:20"] == found[":"] == (20, 2, 10)
    assert (found["5:10"], found[":10"], found["15:"]) == ((5, 1, 0), (10, 1, 0), (5, 2, 5))


@pytest.mark.parametrize(
    ("frames", "reason"),
    [
        ("all", "frames 'all' are not A:B"),
        ("5:5", "frames 5:5 holds no frames"),
        ("9:3", "frames 9:3 holds no frames"),
        ("15:29", "15:29: from frame 20 on there is nothing in result or ground truth; choose "),
        ("25:29", "from frame 25 on there is nothing in result or ground truth"),
        ("25:", "choose a range within 0:20"),
    ],
)
def test_frames_that_are_not_there_are_told(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str], frames: str, reason: str
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], "--frames", frames]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert reason in err


def test_a_session_tracked_in_part_is_scored_in_whole_with_a_note(
    trackwright: Trackwright, recording: Path, tiny_run: Run, tmp_path: Path
) -> None:
    tracks = tiny_run.tracks
    early = {name: column[tracks["frame"] < 60] for name, column in tracks.items()}
    part = replace(tiny_run, frames=(0, 60), tracks=early, signals=empty(SIGNAL_COLUMNS))
    with open_recording(recording) as footage:
        Session.create(footage, [part], tmp_path / "part.h5").close()
    words = ("score", tmp_path / "part.h5", "--truth", recording, "--json")
    _, whole, note = trackwright(*words)
    _, judged, silence = trackwright(*words, "--frames", "0:60")
    assert note.count("\n") == 1
    assert "frames 0:60 of 80 were tracked" in note
    assert "--frames 0:60" in note
    assert silence == ""
    assert json.loads(whole)["frames"] == 80
    assert json.loads(judged)["frames"] == 60
    assert json.loads(judged)["misses"] < json.loads(whole)["misses"]


def test_a_session_tracked_in_whole_is_scored_without_a_note(
    trackwright: Trackwright, session: Path, recording: Path
) -> None:
    assert trackwright("score", session, "--truth", recording, "--json")[2] == ""


def test_a_truth_that_outlasts_the_recording_is_told(
    trackwright: Trackwright, session: Path, recording: Path
) -> None:
    with (recording / "truth.txt").open("a") as truth:
        truth.write("100,1,10,10,20,40,1,1,1,-1\n")
    words = ("score", session, "--truth", recording, "--json")
    _, whole, note = trackwright(*words)
    assert json.loads(whole)["frames"] == 100
    assert note.count("\n") == 1
    assert "goes on to frame 100" in note
    assert "--frames 0:80" in note
    assert trackwright(*words, "--frames", "0:80")[2] == ""


def test_a_radius_without_the_floor_is_refused(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], "--radius", "1"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert "only with --match floor" in err


def test_recordings_that_seem_to_differ_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, fps, text in (("lane", 10, RESULT), ("marks", 15, TRUTH)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "truth.txt").write_text(text)
        manifest = f'format = 1\nname = "{name}"\nfps = {fps}\n[left]\nsource = "left.mp4"\n'
        (tmp_path / name / "recording.toml").write_text(manifest)
    truth = str(tmp_path / "marks")
    assert run(["score", str(tmp_path / "lane" / "truth.txt"), "--truth", truth, "--json"]) == 0
    err = capsys.readouterr().err
    assert "different recordings: named lane and marks; 10 and 15 frames per second" in err
    assert run(["score", str(tmp_path / "marks" / "truth.txt"), "--truth", truth, "--json"]) == 0
    assert "different recordings" not in capsys.readouterr().err


@pytest.mark.parametrize(("frames", "told"), [(100, False), (120, True), (None, False)])
def test_lengths_are_compared_where_both_are_told(frames: int | None, told: bool) -> None:
    why = disagreement(Source("truth.txt", None, 100, 29.97), Source("a.h5", "a", frames, 29.97003))
    assert (why is not None and "120 and 100 frames" in why) == told
