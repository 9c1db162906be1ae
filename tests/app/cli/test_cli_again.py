"""`track --again`: from a frame of a corrected session on."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright

from app.core.document.document_loader import open_path
from tracking.editing import apply_change, plan_mark_reviewed, plan_move_box, plan_swap
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, Labels, Run, TrackTable, empty

CUT = 40


@pytest.fixture
def swapped(session: Path) -> tuple[Path, int, int]:
    """A session in which somebody let two people change over from a frame on; and who they are."""
    with closing(Session.open(session)) as opened:
        table = opened.tracks
        there = [t for t in table.track_ids if {CUT - 1, CUT} <= set(table.frames_of_track(t))]
        opened.apply(plan_swap(table, there[0], there[1], CUT))
        opened.save()
    return session, there[0], there[1]


def bytes_of(path: Path) -> bytes:
    return path.read_bytes()


@pytest.fixture
def mistaken(footage: Path, tiny_run: Run, tmp_path: Path) -> tuple[Path, int, int]:
    """A session whose tracker took two people for each other; and who they are."""
    table = TrackTable(tiny_run.tracks)
    there = [t for t in table.track_ids if {CUT - 1, CUT} <= set(table.frames_of_track(t))]
    apply_change(table, Labels(), plan_swap(table, there[0], there[1], CUT))
    tracks = {name: table.columns()[name] for name in tiny_run.tracks}
    path = tmp_path / "mistaken.h5"
    with open_recording(footage) as recording:
        run = replace(tiny_run, tracks=tracks, signals=empty(SIGNAL_COLUMNS))
        Session.create(recording, [run], path).close()
    return path, there[0], there[1]


def test_it_tells_what_would_change_and_keeps_nothing(
    trackwright: Trackwright, footage: Path, mistaken: tuple[Path, int, int]
) -> None:
    path, a, b = mistaken
    before = bytes_of(path)
    status, out, _ = trackwright("track", footage, "--again", path, "--from", CUT - 5, "--json")
    assert status == 0
    told = json.loads(out)
    assert (told["session"], told["taken"], told["frames"]) == (None, None, [CUT - 5, 80])
    (over,) = (each for each in told["differences"] if each["kind"] == "identity")
    assert (over["track"], over["other"], over["protected"]) == (min(a, b), max(a, b), False)
    assert abs(over["start"] - CUT) <= 2
    assert f"{min(a, b)} and {max(a, b)} are swapped from frame" in over["text"]
    assert bytes_of(path) == before


def test_a_swap_somebody_made_holds_when_tracked_again_from_before_it(
    trackwright: Trackwright, footage: Path, swapped: tuple[Path, int, int]
) -> None:
    path, *_ = swapped
    told = trackwright("track", footage, "--again", path, "--from", CUT - 1, "--json")[1]
    assert [each for each in json.loads(told)["differences"] if each["kind"] == "identity"] == []


def test_accepting_takes_what_is_not_protected(
    trackwright: Trackwright, footage: Path, swapped: tuple[Path, int, int]
) -> None:
    path, a, _ = swapped
    with closing(Session.open(path)) as session:
        session.apply(plan_mark_reviewed(session.labels, a, 60, 70))
        session.apply(plan_move_box(session.tracks, a, 75, (9.0, 9.0, 20.0, 40.0), (1.0, 2.0)))
        before = {frame: session.tracks.of_frame(frame) for frame in range(80)}
    status, _, err = trackwright("track", footage, "--again", path, "--from", CUT, "--accept")
    assert status == 0
    assert f"saved in {path}" in err
    with closing(Session.open(path)) as session:
        assert len(session.runs) == 2
        assert session.history.entries[-1].kind == "take"
        assert "as tracked again by stereo-direction" in session.history.entries[-1].text
        for frame in (*range(CUT), *range(60, 70), 75):
            rows = session.tracks.of_track(a, frame, frame + 1)
            mine = before[frame]["track"] == a
            for name, column in rows.items():
                assert column.tobytes() == before[frame][name][mine].tobytes()
        session.undo()
        for frame, rows in before.items():
            for name, column in session.tracks.of_frame(frame).items():
                np.testing.assert_array_equal(column, rows[name])


def test_with_a_name_of_its_own_the_session_stays_as_it_was(
    trackwright: Trackwright, footage: Path, swapped: tuple[Path, int, int], tmp_path: Path
) -> None:
    path, a, _ = swapped
    with closing(Session.open(path)) as session:
        session.apply(plan_mark_reviewed(session.labels, a, 0, 5))
    before, out = bytes_of(path), tmp_path / "again.h5"
    words = ["--from", "50", "--until", "60", "-o", out, "--set", "particles=100", "--json"]
    status, printed, _ = trackwright("track", footage, "--again", path, *words)
    assert (status, json.loads(printed)["session"]) == (0, str(out))
    assert bytes_of(path) == before
    with closing(Session.open(path)) as session:
        assert (session.recovered, len(session.runs)) == (1, 1)
    with closing(open_path(out)) as opened:
        copy = opened.document.session
        assert copy is not None
        assert len(copy.history) == 2
        assert (copy.runs[1].frames, copy.runs[1].settings["particles"]) == ((50, 60), 100)
        assert copy.runs[1].known_tracks == copy.tracks.highest_track


def test_a_run_made_again_knows_the_tracks_after_reopening(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    assert trackwright("track", footage, "--again", session, "--from", "70", "--accept")[0] == 0
    with closing(Session.open(session)) as opened:
        assert opened.runs[0].known_tracks == 0
        assert opened.runs[1].known_tracks > 0


def test_settings_that_had_other_names_in_the_sessions_version_are_taken_over(
    trackwright: Trackwright, footage: Path, tiny_run: Run, tmp_path: Path
) -> None:
    path, out = tmp_path / "old.h5", tmp_path / "again.h5"
    settings = {"agility": 2.0, "remember_s": 3.0, "particles": 100}
    with open_recording(footage) as recording:
        old = replace(tiny_run, tracker="stereo-joint", settings=settings)
        Session.create(recording, [old], path).close()
    words = ["--from", "50", "--until", "55", "-o", out, "--set", "coast_s=4"]
    assert trackwright("track", footage, "--again", path, *words)[0] == 0
    with closing(Session.open(out)) as session:
        named = {name: session.runs[1].settings[name] for name in ("process_noise", "coast_s")}
        assert named == {"process_noise": 2.0, "coast_s": 4.0}
        assert "agility" not in session.runs[1].settings


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--from", "80"], "frame 80: tracking again goes on from one of the frames 0 to 79"),
        (["--from", "50", "--until", "40"], "within 0:80"),
        (["--from", "50", "--tracker", "psychic"], "available are stereo-joint"),
    ],
)
def test_a_wrong_wish_is_told_in_a_line(
    trackwright: Trackwright, footage: Path, session: Path, words: list[str], reason: str
) -> None:
    status, out, err = trackwright("track", footage, "--again", session, *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert reason in err


@pytest.mark.parametrize(
    "words",
    [
        ["--again", "s.h5"],
        ["--from", "5"],
        ["--accept", "-o", "s.h5"],
        ["--again", "s.h5", "--from", "5", "--frames", "3:9"],
        ["x"],
    ],
)
def test_options_that_do_not_go_together_are_told(
    trackwright: Trackwright, words: list[str]
) -> None:
    assert trackwright("track", *words)[0] == 2


@pytest.mark.parametrize(
    ("words", "option"),
    [
        (["--right", "r.mp4"], "--right"),
        (["--height", "0"], "--height"),
        (["--fps", "20"], "--fps"),
        (["--layout", "top-bottom"], "--layout"),
        (["elsewhere", "--left", "l.mp4"], "--left"),
    ],
)
def test_what_the_session_says_of_its_recording_is_not_said_again(
    trackwright: Trackwright, words: list[str], option: str
) -> None:
    status, out, err = trackwright("track", "--again", "s.h5", "--from", "5", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert option in err
    assert "the session of --again says what its recording is; leave it out" in err


def test_what_is_no_session_is_told(trackwright: Trackwright, footage: Path) -> None:
    status, _, err = trackwright("track", "--again", footage, "--from", "5")
    assert status == 1
    assert "is no session; make one with track -o NAME.h5 first" in err


def test_a_recording_that_is_not_found_is_asked_for(
    trackwright: Trackwright, session: Path
) -> None:
    status, _, err = trackwright("track", "--again", session, "--from", "5")
    assert status == 1
    assert "name its place (track RECORDING --again ...)" in err


def test_another_recording_than_the_sessions_is_refused(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path
) -> None:
    beside = Path(shutil.copytree(footage, tmp_path / "real" / "square"))
    session = Path(shutil.copy(made, tmp_path / "real" / "square.h5"))
    other = Path(shutil.copytree(footage, tmp_path / "other"))
    images = sorted(file for file in other.rglob("*") if file.suffix in (".avi", ".mp4", ".mkv"))
    images[0].write_bytes(images[-1].read_bytes())
    words = ["--again", session, "--from", "78"]
    assert trackwright("track", beside, *words)[0] == 0
    words += ["-o", tmp_path / "x.h5"]
    status, out, err = trackwright("track", other, *words)
    note, why = err.splitlines()
    assert (status, out) == (1, "")
    assert "has moved; it was found at" in note
    assert f"{other} is not the recording of {session}" in why
    assert not (tmp_path / "x.h5").exists()


def test_a_recording_named_by_its_manifest_or_its_parent_is_known_again(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    for named in (footage / "recording.toml", footage.parent):
        assert trackwright("track", named, "--again", session, "--from", "78")[0] == 0


def test_a_missing_recording_is_refused_though_the_session_would_find_its_own(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path
) -> None:
    assert trackwright("track", footage, "--again", session, "--from", "78")[0] == 0
    status, out, err = trackwright("track", tmp_path / "no", "--again", session, "--from", "78")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert f"there is nothing at {tmp_path / 'no'}; check the path" in err


def test_everything_can_be_tracked_again(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    words = ["--from", "0", "--until", "3", "--json"]
    status, out, _ = trackwright("track", footage, "--again", session, *words)
    assert (status, json.loads(out)["frames"]) == (0, [0, 3])
