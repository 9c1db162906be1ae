"""`setup`: from files to a recording that opens, and wrong input."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.recording import open_recording


@pytest.fixture
def files(recording: Path, tmp_path: Path) -> Path:
    """The cameras' files and the calibration, named as a camera names them; no recording.toml."""
    folder = tmp_path / "card"
    folder.mkdir()
    for side, name in (("left", "GX010035"), ("right", "GX010034")):
        source = next(recording.glob(f"{side}*"))
        target = folder / (name + source.suffix)
        (shutil.copytree if source.is_dir() else shutil.copyfile)(source, target)
    shutil.copyfile(recording / "calibration.yaml", folder / "calibration.yaml")
    return folder


def test_two_files_become_a_recording_with_metres(trackwright: Trackwright, files: Path) -> None:
    calibration = ("--calibration", files / "calibration.yaml")
    status, printed, _ = trackwright("setup", files, *calibration, "--floor", "stereo", "--json")
    assert status == 0
    document = json.loads(printed)
    assert Path(document["left"]).stem == "GX010035"
    with open_recording(files) as opened:
        assert opened.is_stereo
        assert opened.view is not None
        assert opened.notes == ()


def test_a_calibration_beside_the_files_is_taken(trackwright: Trackwright, files: Path) -> None:
    status, printed, _ = trackwright("setup", files)
    assert (status, 'file = "calibration.yaml"' in printed) == (0, True)


def test_a_calibration_beside_is_not_taken_where_nothing_is_to_be_found(
    trackwright: Trackwright, files: Path
) -> None:
    left, right = sorted(files.glob("GX*"), reverse=True)
    given = ("--left", left, "--right", right, "--as-given")
    status, printed, _ = trackwright("setup", *given, "--fps", "20")
    assert (status, "calibration.yaml" in printed) == (0, False)


def test_a_recording_that_is_there_is_not_replaced(trackwright: Trackwright, files: Path) -> None:
    (files / "recording.toml").write_text("mine")
    status, _, said = trackwright("setup", "--left", next(files.glob("GX010035*")))
    assert status == 1
    assert "--force" in said
    assert (files / "recording.toml").read_text() == "mine"


def test_a_recording_that_is_replaced_is_kept_beside(trackwright: Trackwright, files: Path) -> None:
    (files / "recording.toml").write_text("mine")
    left, right = sorted(files.glob("GX*"), reverse=True)
    status, _, said = trackwright("setup", "--left", left, "--right", right, "--force")
    assert status == 0, said
    assert (files / "recording.toml.bak").read_text() == "mine"
    assert "GX010035" in (files / "recording.toml").read_text()


def test_files_in_two_folders_are_told_where_the_recording_stands(
    trackwright: Trackwright, files: Path
) -> None:
    left, right = sorted(files.glob("GX*"), reverse=True)
    (files / "other").mkdir()
    moved = right.rename(files / "other" / right.name)
    status, _, said = trackwright("setup", "--left", left, "--right", moved)
    assert status == 0, said
    assert "the files lie in 2 folders" in said
    assert (files / "recording.toml").is_file()


def test_nothing_to_set_up_is_told(trackwright: Trackwright, tmp_path: Path) -> None:
    assert trackwright("setup")[0] == 2
    status, _, said = trackwright("setup", tmp_path / "none.mp4")
    assert (status, "no such file" in said) == (1, True)
    status, _, said = trackwright("setup", tmp_path)
    assert (status, "no videos or images" in said) == (1, True)


def test_the_floor_is_printed_with_its_uncertainty_and_the_next_command(
    trackwright: Trackwright, files: Path
) -> None:
    status, printed, said = trackwright("setup", files)
    assert status == 0
    assert f"next: trackwright floor {files} --write" in said
    status, printed, said = trackwright("setup", files, "--floor", "stereo", "--force")
    assert status == 0
    assert "give or take" in printed
    assert f"next: trackwright open {files}" in said
    assert said.count("next:") == 1


def test_without_a_calibration_the_next_commands_make_one_and_take_it(
    trackwright: Trackwright, files: Path
) -> None:
    made = (files / "calibration.yaml").rename(files.parent / "made.yaml")
    status, _, said = trackwright("setup", files)
    assert status == 0
    assert "next, for metres: trackwright calibrate, from a board or with --rough" in said
    assert f"-o {files / 'calibration.yaml'}; then trackwright setup {files} --floor stereo" in said
    shutil.copyfile(made, files / "calibration.yaml")
    status, printed, said = trackwright("setup", files, "--floor", "stereo", "--force")
    assert status == 0, said
    assert 'file = "calibration.yaml"' in printed


def test_two_videos_in_place_of_a_recording_are_told_how_they_become_one(
    trackwright: Trackwright, files: Path
) -> None:
    left, right = sorted(files.glob("GX*"))
    for command in ("info", "open", "track"):
        status, printed, said = trackwright(command, left, right)
        assert (status, printed) == (2, "")
        assert f"trackwright setup {left} {right}" in said
        assert len(said.splitlines()) == 1
    status, _, said = trackwright("info", files)
    assert (status, f"make one: trackwright setup {files}" in said) == (1, True)
    status, _, said = trackwright("info", left, files / "calibration.yaml")
    assert (status, "unexpected extra argument" in said) == (2, True)


def test_a_layout_typed_for_a_recording_that_is_set_up_again_counts(
    trackwright: Trackwright, files: Path
) -> None:
    source = next(files.glob("GX010035*"))
    alone = ("setup", source, "--layout", "side-by-side", "--fps", "20", "--force")
    (files / "calibration.yaml").unlink()  # it is of one camera's images
    status, _, said = trackwright(*alone)
    assert status == 0, said
    again = ("--layout", "top-bottom", "--first", "right", "--force")
    status, printed, _ = trackwright("setup", files, *again)
    assert status == 0
    assert 'layout = "top-bottom"' in printed
    assert 'first = "right"' in printed


def test_a_layout_of_two_sources_is_refused(trackwright: Trackwright, files: Path) -> None:
    assert trackwright("setup", files)[0] == 0
    status, _, said = trackwright("setup", files, "--layout", "top-bottom", "--force")
    assert status == 1
    assert "has a source for each camera; leave --layout and --first out" in said


def test_what_is_no_calibration_is_told_and_left_out(trackwright: Trackwright, files: Path) -> None:
    (files / "calibration.yaml").rename(files / "camchain.yaml")
    (files / "calib.txt").write_text("Notes of the calibration: board 9x6, Tuesday\n")
    status, printed, said = trackwright("setup", files)
    assert status == 0, said
    assert said.count("not used, as it is no calibration") == 1
    assert "calib.txt: M1 is missing" in said
    assert 'file = "camchain.yaml"' in printed
