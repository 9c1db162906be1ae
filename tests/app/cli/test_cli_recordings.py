"""`info`, `synth` and `trackers`, and what they say of broken recordings."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import Trackwright

import tracking
from app.cli.commands import SCENE_NAMES
from tracking.recording import open_recording
from tracking.synthesis import SCENES, render_recording


def test_info_says_what_a_recording_holds(trackwright: Trackwright, footage: Path) -> None:
    status, out, err = trackwright("info", footage, "--json")
    assert (status, err) == (0, "")
    facts = json.loads(out)
    assert (facts["kind"], facts["frames"], facts["fps"]) == ("recording", 80, 8)
    assert (facts["size"], facts["duration"]) == ([320, 240], 10)
    assert (facts["stereo"], facts["calibrated"]) == (True, True)
    assert (facts["tracks"], facts["edits"]) == (0, 0)


def test_info_is_readable(trackwright: Trackwright, footage: Path) -> None:
    status, out, _ = trackwright("info", footage)
    assert status == 0
    assert re.search(r"stereo +yes", out)
    said = dict(re.split(" {2,}", line, maxsplit=1) for line in out.splitlines())
    assert (said["size"], said["duration"]) == ("320 x 240 px", "10 s")
    assert said["frame rate"] == "8 frames per second"
    assert said["ground"] == "height 6.4 m, tilt 60 degrees, roll 0 degrees"


def test_bare_videos_open_with_options(trackwright: Trackwright, footage: Path) -> None:
    words = ["info", "--json", "--left", footage / "left.mp4", "--right", footage / "right.mp4"]
    words += ["--calibration", footage / "calibration.yaml", "--height", "6.4", "--tilt", "60"]
    facts = json.loads(trackwright(*words)[1])
    assert (facts["stereo"], facts["calibrated"]) == (True, True)
    assert facts["ground"] == {"height": 6.4, "tilt": 60, "roll": 0}


def test_a_bare_video_is_a_recording(trackwright: Trackwright, footage: Path) -> None:
    facts = json.loads(trackwright("info", footage / "left.mp4", "--json")[1])
    assert (facts["frames"], facts["stereo"], facts["calibrated"]) == (80, False, False)


@pytest.mark.parametrize(
    "words",
    [["info"], ["info", "--right", "r.mp4"], ["info", "--layout", "diagonal", "--left", "a.mp4"]],
)
def test_a_recording_must_be_named(trackwright: Trackwright, words: list[str]) -> None:
    assert trackwright(*words)[0] == 2


def _without(name: str) -> Callable[[Path], object]:
    return lambda folder: (folder / name).unlink()


def _filled(name: str, content: bytes) -> Callable[[Path], object]:
    return lambda folder: (folder / name).write_bytes(content)


def _changed(name: str, old: str, new: str) -> Callable[[Path], object]:
    def change(folder: Path) -> None:
        text = (folder / name).read_text()
        assert old in text
        (folder / name).write_text(text.replace(old, new))

    return change


@pytest.mark.parametrize(
    ("damage", "reason"),
    [
        (_without("left.mp4"), "left.mp4"),
        (_filled("left.mp4", b""), "left.mp4"),
        (_filled("right.mp4", bytes(range(256)) * 64), "right.mp4"),
        (_without("calibration.yaml"), "calibration.yaml"),
        (_filled("calibration.yaml", b"%YAML:1.0\n---\nM1: 3\n"), "M1"),
        (_changed("calibration.yaml", "image_width: 320", "image_width: 640"), "320"),
        (_filled("recording.toml", b"format = "), "recording.toml"),
        (_changed("recording.toml", "format = 1", "format = 99"), "format 99"),
        (_changed("recording.toml", '"left.mp4"', '"../left.mp4"'), "left.mp4"),
        (_filled("truth.txt", b"1,1,one,2,3,4,1,-1,-1,-1\n"), "truth.txt, line 1"),
    ],
    ids=[
        *("no left video", "empty left video", "noise for a right video"),
        *("no calibration file", "broken calibration", "calibration of another size"),
        *("broken manifest", "manifest of tomorrow", "path that climbs out", "broken truth"),
    ],
)
def test_a_broken_recording_is_one_line_and_status_1(
    trackwright: Trackwright, recording: Path, damage: Callable[[Path], object], reason: str
) -> None:
    damage(recording)
    status, out, err = trackwright("info", recording, "--json")
    assert (status, out) == (1, "")
    assert err.startswith("trackwright: ")
    assert err.count("\n") == 1
    assert reason in err
    assert "bug" not in err


def test_cameras_of_different_size_are_told(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    other = render_recording(tmp_path / "other", "lobby", 0.5, 0, 3, size=(160, 120))
    (other / "right.mp4").replace(recording / "right.mp4")
    status, _, err = trackwright("info", recording)
    assert status == 1
    assert "cameras differ in size" in err


@pytest.mark.parametrize("name", ["nowhere", "empty"])
def test_what_is_no_recording_is_told(trackwright: Trackwright, tmp_path: Path, name: str) -> None:
    (tmp_path / "empty").mkdir()
    status, _, err = trackwright("info", tmp_path / name)
    assert status == 1
    assert err.count("\n") == 1
    assert name in err


def test_synth_renders_a_recording(trackwright: Trackwright, tmp_path: Path) -> None:
    words = ["--scene", "lobby", "--seconds", "0.2", "--people", "0", "--seed", "5", "--json"]
    status, out, err = trackwright("synth", tmp_path / "new" / "lobby", *words)
    assert (status, err) == (0, "rendering lobby ...\n")
    assert json.loads(out) == {"recording": str(tmp_path / "new" / "lobby")}
    assert json.loads(trackwright("info", tmp_path / "new" / "lobby", "--json")[1])["frames"] == 4


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--scene", "moon"], "lobby, plaza"),
        (["--scene", "lobby", "--seconds", "-1"], "seconds is -1"),
        (["--scene", "lobby", "--seconds", "0"], "seconds is 0; give more than 0 and up to 3600"),
        (["--scene", "lobby", "--seconds", "nan"], "seconds is nan; give more than 0"),
        (["--scene", "lobby", "--seconds", "1e300"], "seconds is 1e+300; give more than 0"),
        (["--scene", "lobby", "--people", "100000"], "people is 100000"),
        (["--scene", "marks", "--people", "3"], "people is 3; the scene marks is for 1"),
        (["--scene", "lobby", "--begin", "30"], "begin is 30, but the scene lobby lasts 30"),
        (["--scene", "lobby", "--begin", "nan"], "begin is nan; give 0 to 3600 seconds"),
        (["--scene", "lobby", "--bump", "-2"], "bumped is -2; give 0 to 3600 seconds"),
    ],
)
def test_impossible_scenes_are_told(
    trackwright: Trackwright, tmp_path: Path, words: list[str], reason: str
) -> None:
    status, out, err = trackwright("synth", tmp_path / "new", *words)
    assert (status, out) == (2, "")
    assert reason in err
    assert err.count("\n") == 1  # and not that rendering begins
    assert list(tmp_path.iterdir()) == []


def test_a_scene_for_one_camera_is_rendered_with_one_at_its_own_rate(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    words = ["--scene", "marks", "--begin", "4", "--seconds", "0.2", "--dim", "0", "--bump", "0.1"]
    assert trackwright("synth", tmp_path / "new", *words)[0] == 0
    told = json.loads(trackwright("info", tmp_path / "new", "--json")[1])
    assert (told["frames"], told["fps"]) == (3, 15.0)
    assert not (tmp_path / "new" / "right.mp4").exists()
    assert (tmp_path / "new" / "truth.txt").read_text().startswith("1,1,")


def test_help_of_synth_names_all_scenes(trackwright: Trackwright) -> None:
    assert set(SCENE_NAMES) == set(SCENES)
    page = re.sub(r"-\s+", "-", trackwright("synth", "--help")[1])  # names that a line ends in
    assert all(name in page for name in SCENES)


def test_a_seed_no_session_can_hold_is_told(trackwright: Trackwright, tmp_path: Path) -> None:
    words = ["synth", tmp_path / "new", "--scene", "lobby", "--seed", str(10**26)]
    status, _, err = trackwright(*words)
    assert status == 2
    assert "give --seed 0 to 9223372036854775807" in err


def test_the_version_is_told(trackwright: Trackwright) -> None:
    assert trackwright("--version") == (0, f"trackwright {tracking.__version__}\n", "")


def test_synth_never_writes_into_a_folder_with_something_in_it(
    trackwright: Trackwright, recording: Path
) -> None:
    before = sorted(recording.iterdir())
    status, _, err = trackwright("synth", recording, "--scene", "lobby", "--seconds", "0.1")
    assert status == 1
    assert "not an empty folder" in err
    assert sorted(recording.iterdir()) == before


def test_trackers_are_listed_with_all_their_settings(trackwright: Trackwright) -> None:
    status, out, _ = trackwright("trackers", "--json")
    assert status == 0
    found = {tracker["name"]: tracker for tracker in json.loads(out)["trackers"]}
    assert {"stereo-colour", "stereo-direction"} <= set(found)
    for field in found["stereo-direction"]["settings"]:
        assert set(field) == {"name", "type", "default", "unit", "range", "help", "expert"}
        assert field["help"]
    readable = trackwright("trackers", "stereo-direction", "--expert")[1]
    plain, heading, expert = readable.partition("  expert settings:\n")
    assert heading
    for field in found["stereo-direction"]["settings"]:
        assert f"  {field['name']}=" in (expert if field["expert"] else plain)


def test_a_list_of_trackers_has_the_settings_that_are_offered_and_counts_the_others(
    trackwright: Trackwright,
) -> None:
    lines = trackwright("trackers")[1].splitlines()
    found = json.loads(trackwright("trackers", "--json")[1])["trackers"]
    offered = [one["name"] for each in found for one in each["settings"] if not one["expert"]]
    assert [line.split("=")[0].strip() for line in lines if re.match(r"  [\w.]+=", line)] == offered
    for each in found:
        expert = sum(one["expert"] for one in each["settings"])
        assert len(each["settings"]) - expert <= 20
        assert f"  {expert} expert settings: trackers {each['name']} --expert" in lines
    (share,) = (line for line in lines[: lines.index("")] if "report_s=" in line)
    assert share.endswith("(0.05 to 60 s)")


def test_one_tracker_is_listed_by_its_name(trackwright: Trackwright) -> None:
    status, out, _ = trackwright("trackers", "flow", "--json")
    assert (status, [one["name"] for one in json.loads(out)["trackers"]]) == (0, ["flow"])
    status, _, err = trackwright("trackers", "flaw")
    assert (status, "tracker flaw is unknown: did you mean flow?" in err) == (2, True)


def test_people_are_looked_for_in_the_region_that_is_typed(
    trackwright: Trackwright, footage: Path
) -> None:
    status, out, _ = trackwright("info", footage, "--region", "0,0:63,0:63,9999:0,9999", "--json")
    with open_recording(footage) as opened:
        width = opened.size[0]
    assert (status, json.loads(out)["region"]) == (0, round(64 / width, 4))
    assert json.loads(trackwright("info", footage, "--json")[1])["region"] is None


@pytest.mark.parametrize(
    ("option", "typed", "problem"),
    [
        ("--region", "1,2:3,4", "fewer than three corners"),
        ("--mask", "1,2:3,x:5,6", "'1,2:3,x:5,6' is no outline; type x,y:x,y:x,y in pixels"),
    ],
)
def test_an_outline_that_is_none_is_refused(
    trackwright: Trackwright, footage: Path, option: str, typed: str, problem: str
) -> None:
    status, _, err = trackwright("info", footage, option, typed)
    assert (status, problem in err, option in err) == (2, True, True)


def test_info_warns_of_a_camera_so_flat_that_metres_mean_little(
    trackwright: Trackwright, recording: Path
) -> None:
    said = trackwright("info", recording, "--height", "0.8", "--tilt", "5")[1]
    assert "the camera is low or looks flat" in said
    assert "low or looks flat" not in trackwright("info", recording)[1]
    cut = "0,450:640,450:640,480:0,480"
    told = trackwright("info", recording, "--height", "0.8", "--tilt", "5", "--region", cut)[1]
    assert "low or looks flat" not in told
