"""`track`, `export` and what they do about files in their way."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import h5py
import numpy as np
import pytest
from command_line import Trackwright

import app.cli.track
from app.core.document.document_loader import open_path
from tracking.editing import plan_delete
from tracking.formats import read_mot
from tracking.geometry import Ground
from tracking.session import Session


def test_track_makes_a_session(trackwright: Trackwright, footage: Path, tmp_path: Path) -> None:
    out = tmp_path / "square.h5"
    words = ["--tracker", "stereo-colour", "--set", "particles=100", "--frames", "10:60", "--json"]
    status, printed, _ = trackwright("track", footage, "-o", out, *words)
    assert status == 0
    assert json.loads(printed)["session"] == str(out)
    with closing(Session.open(out)) as session:
        run = session.runs[0]
        assert (run.tracker, run.frames, run.seed) == ("stereo-colour", (10, 60), 0)
        assert run.settings["particles"] == 100
    facts = json.loads(trackwright("info", out, "--json")[1])
    assert (facts["kind"], facts["frames"], facts["edits"]) == ("session", 80, 0)
    assert facts["duration"] == 10


def test_the_same_seed_tracks_the_same(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path
) -> None:
    asked = ("-o", tmp_path / "again.h5", "--tracker", "stereo-direction")
    assert trackwright("track", footage, *asked)[0] == 0
    with (
        closing(Session.open(made)) as first,
        closing(Session.open(tmp_path / "again.h5")) as second,
    ):
        assert len(first.tracks) > 0
        for name, column in first.tracks.columns().items():
            np.testing.assert_array_equal(column, second.tracks.columns()[name])


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--tracker", "psychic"], "available are stereo-joint"),
        (["--tracker", "sphere"], "did you mean spheroid? Available are"),
        (["--set", "particles=many"], "particles=many"),
        (["--set", "particles=-5"], "particles=-5"),
        (["--set", "particels=5"], "did you mean particles?"),
        (["--set", "particles"], "is not KEY=VALUE"),
        (["--set", "particles=10", "--set", "particles=20"], "particles is given twice, as 10 and"),
        (["--frames", "10"], "are not A:B"),
        (["--frames", "50:10"], "holds no frames"),
        (["--frames", "0:9999"], "within 0:80"),
        (["--frames", "0:99999999999999999999999"], "not all there: choose a range within 0:80"),
        (["--frames", "-5:10"], "frames -5:10 are not all there: choose a range within 0:80"),
    ],
)
def test_a_wrong_order_is_told_before_any_work(
    trackwright: Trackwright, footage: Path, tmp_path: Path, words: list[str], reason: str
) -> None:
    status, out, err = trackwright("track", footage, "-o", tmp_path / "s.h5", *words)
    assert (status, out) == (2, "")
    assert err.count("\n") == 1
    assert reason in err
    assert list(tmp_path.iterdir()) == []


def test_a_session_in_the_place_of_a_recording_is_told_with_what_to_name(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    status, out, err = trackwright("track", session, "-o", tmp_path / "again.h5")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert f"{session} is a session, not a recording" in err
    assert f"--again {session}" in err


def test_other_hdf5_in_the_place_of_a_recording_is_not_called_a_session(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    hollow = tmp_path / "hollow.h5"
    h5py.File(hollow, "w").close()
    status, out, err = trackwright("track", hollow, "-o", tmp_path / "s.h5")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert f"{hollow} is an HDF5 file, neither a recording nor a session; name a recording" in err
    with h5py.File(hollow, "a") as file:
        file.attrs.update(format="trackwright-session", format_version="99.0")
    status, _, err = trackwright("track", hollow, "-o", tmp_path / "s.h5")
    assert (status, err.count("\n")) == (1, 1)
    assert "made by a newer trackwright; update to open it" in err
    with h5py.File(hollow, "w") as file:  # of a kind that NumPy has not
        h5py.h5a.create(file.id, b"format", h5py.h5t.UNIX_D32LE, h5py.h5s.create(h5py.h5s.SCALAR))
    status, _, err = trackwright("track", hollow, "-o", tmp_path / "s.h5")
    assert (status, err.count("\n")) == (1, 1)
    assert "neither a recording nor a session" in err


def test_a_session_of_bare_videos_opens_whole(
    trackwright: Trackwright, recording: Path, tmp_path: Path, own_folder: Path
) -> None:
    left = (recording / "left.mp4").rename(tmp_path / "l.mp4")
    right = (recording / "right.mp4").rename(recording / "r.mp4")
    (recording / "recording.toml").unlink()
    words = ["--left", left, "--right", right, "--calibration", recording / "calibration.yaml"]
    words += ["--height", "6.4", "--tilt", "60", "--frames", "0:5"]
    out = tmp_path / "results" / "s.h5"
    out.parent.mkdir()
    assert trackwright("track", *words, "-o", out)[0] == 0
    document = open_path(out).document
    assert document.session is not None
    with closing(document.session), document.recording as found:
        assert found.rectification is not None
        assert found.ground == Ground(6.4, 60.0)
        assert found.frame_count == 80
    facts = json.loads(trackwright("info", out, "--json")[1])
    assert (facts["stereo"], facts["calibrated"]) == (True, True)


def test_a_tracker_of_people_whole_takes_no_detector(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    words = ["-o", tmp_path / "s.h5", "--detector", "d.h5"]
    status, _, err = trackwright("track", footage, *words)
    assert status == 2
    assert "tracker stereo-joint knows no detector" in err


@pytest.mark.parametrize(("line", "reason"), [("[calibration]", "calib"), ("[ground]", "floor")])
def test_metres_need_a_calibration_and_a_floor(
    trackwright: Trackwright, recording: Path, tmp_path: Path, line: str, reason: str
) -> None:
    manifest = recording / "recording.toml"
    parts = manifest.read_text().split("\n\n")
    manifest.write_text("\n\n".join(part for part in parts if not part.startswith(line)))
    words = ["-o", tmp_path / "s.h5", "--tracker", "stereo-direction"]
    status, _, err = trackwright("track", recording, *words)
    assert status == 1
    assert reason in err
    assert not (tmp_path / "s.h5").exists()


@pytest.mark.parametrize("place", ["missing/s.h5", "file/s.h5", "folder.h5"])
def test_a_place_that_cannot_be_written_is_told_before_any_work(
    trackwright: Trackwright,
    footage: Path,
    tmp_path: Path,
    place: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        app.cli.track, "track_recording", lambda *_: pytest.fail("it began to work")
    )
    (tmp_path / "file").touch()
    (tmp_path / "folder.h5").mkdir()
    status, _, err = trackwright("track", footage, "-o", tmp_path / place)
    assert status == 1
    assert err.count("\n") == 1


def test_an_interrupted_track_leaves_nothing(
    trackwright: Trackwright, footage: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("tracking.pipeline.Tracking.run", interrupted)
    status, out, err = trackwright("track", footage, "-o", tmp_path / "s.h5", "--frames", "0:5")
    assert (status, out) == (130, "")
    assert err.endswith("trackwright: interrupted; nothing half-done was kept\n")
    assert list(tmp_path.iterdir()) == []


def test_distances_that_exclude_each_other_are_refused_before_any_work(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    far = ["--set", "stereo.nearest_m=20", "--set", "stereo.farthest_m=2"]
    status, _, err = trackwright("track", footage, "-o", tmp_path / "s.h5", *far)
    assert status == 2
    assert err.splitlines()[-1].startswith("trackwright: settings stereo.nearest_m=20")
    assert list(tmp_path.iterdir()) == []


def test_a_session_nobody_worked_on_is_replaced(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    assert trackwright("track", footage, "-o", session, "--frames", "0:5")[0] == 0
    with closing(Session.open(session)) as replaced:
        assert replaced.runs[0].frames == (0, 5)


def test_corrections_are_not_overwritten(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    with closing(Session.open(session)) as worked_on:
        track = worked_on.tracks.track_ids[0]
        worked_on.apply(plan_delete(worked_on.tracks, track, 0, 80))
        worked_on.save()
    before = session.read_bytes()
    status, _, err = trackwright("track", footage, "-o", session)
    assert status == 1
    assert "--force" in err
    assert session.read_bytes() == before
    assert trackwright("track", footage, "-o", session, "--frames", "0:5", "--force")[0] == 0


@pytest.mark.parametrize("content", [b"my diary", b"\x89HDF\r\n\x1a\n" + bytes(500)])
def test_another_file_is_not_overwritten(
    trackwright: Trackwright, footage: Path, tmp_path: Path, content: bytes
) -> None:
    (tmp_path / "diary.h5").write_bytes(content)
    status, _, err = trackwright("track", footage, "-o", tmp_path / "diary.h5")
    assert status == 1
    assert "--force" in err
    assert (tmp_path / "diary.h5").read_bytes() == content


@pytest.mark.parametrize("words", [(), ("--again", "s.h5", "--from", "0")])
def test_a_session_by_a_name_that_does_not_say_so_is_refused(
    trackwright: Trackwright, footage: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    status, _, err = trackwright("track", footage, *words, "-o", tmp_path / "y.txt")
    assert status == 2
    assert "a session's name ends in .h5: give y.h5" in " ".join(err.split())
    assert list(tmp_path.iterdir()) == []


def test_export_writes_what_the_session_scores(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path
) -> None:
    out = tmp_path / "tracks.txt"
    status, printed, _ = trackwright("export", made, "-o", out, "--format", "mot", "--json")
    assert status == 0
    assert json.loads(printed)["rows"] == len(read_mot(out)["frame"])
    of_session = trackwright("score", made, "--truth", footage, "--json")[1]
    of_text = trackwright("score", out, "--truth", footage, "--json")[1]
    # The text does not say how long the recording is, and its rows all count in full.
    differs = {"frames", "track_map"}
    assert {k: v for k, v in json.loads(of_text).items() if k not in differs} == {
        k: v for k, v in json.loads(of_session).items() if k not in differs
    }


def test_corrected_tracks_keep_their_confidence_but_as_ground_truth(
    trackwright: Trackwright, made: Path, tmp_path: Path
) -> None:
    with closing(Session.open(made)) as session:
        sure = session.tracks.columns()["confidence"]
    assert (sure[np.isfinite(sure)] < 1).any()
    out, truth = tmp_path / "t.txt", tmp_path / "yard" / "gt" / "gt.txt"
    truth.parent.mkdir(parents=True)
    words = ["export", made, "--format", "mot16", "-o"]
    assert trackwright(*words, out)[0] == 0
    np.testing.assert_allclose(read_mot(out)["confidence"], sure, atol=2e-6)
    for path, more in ((truth, []), (tmp_path / "any.txt", ["--ground-truth"])):
        assert trackwright(*words, path, *more)[0] == 0
        assert set(read_mot(path)["confidence"]) == {1.0}


@pytest.mark.parametrize("name", ["csv", "coco", "pedpy-txt", "labels"])
def test_ground_truth_is_asked_for_only_where_it_is_another_thing(
    trackwright: Trackwright, made: Path, tmp_path: Path, name: str
) -> None:
    words = ["export", made, "-o", tmp_path / "out", "--format", name, "--ground-truth"]
    status, _, err = trackwright(*words)
    assert (status, "--ground-truth" in err) == (2, True)
    assert list(tmp_path.iterdir()) == []


def test_what_a_format_does_not_hold_is_told(
    trackwright: Trackwright, made: Path, tmp_path: Path
) -> None:
    words = ["export", made, "--format", "coco", "-o", tmp_path / "t.json"]
    _, printed, err = trackwright(*words, "--json")
    (note,) = json.loads(printed)["notes"]
    assert "places on the floor, velocities, visibility" in note
    assert f"note: {note}" in err
    assert "visibility" not in trackwright(*words[:3], "csv", *words[4:])[2]


def test_a_run_can_be_exported(trackwright: Trackwright, made: Path, tmp_path: Path) -> None:
    words = ["export", made, "-o", tmp_path / "t.txt", "--format", "mot", "--run"]
    assert trackwright(*words, "0")[0] == 0
    status, _, err = trackwright(*words, "1")
    assert status == 1
    assert "no run 1" in err


def test_a_session_is_not_overwritten_by_an_export(trackwright: Trackwright, session: Path) -> None:
    before = session.read_bytes()
    status, _, err = trackwright("export", session, "-o", session, "--format", "mot")
    assert status == 1
    assert "would be lost" in err
    assert session.read_bytes() == before


@pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")
def test_no_command_writes_through_a_link_or_into_a_pipe(
    trackwright: Trackwright, session: Path, footage: Path, tmp_path: Path
) -> None:
    victim, link, pipe = (tmp_path / name for name in ("victim.txt", "link.txt", "pipe.h5"))
    victim.write_text("precious")
    link.symlink_to(victim)
    os.mkfifo(pipe)
    for words in (
        ["export", session, "--format", "mot", "-o", link],
        ["export", session, "--format", "mot", "-o", pipe],
        ["log", session, "--csv", link],
        ["count", session, "--line", "a:0,1:2,3", "--csv", pipe],
        ["track", footage, "--force", "-o", pipe],
    ):
        status, out, err = trackwright(*words)
        assert (status, out, err.count("\n")) == (1, "", 1), words
        assert "it is a " in err
    assert (victim.read_text(), link.is_symlink(), pipe.is_fifo()) == ("precious", True, True)


@pytest.mark.skipif(sys.platform == "win32", reason="links of POSIX")
def test_track_writes_through_a_link_to_a_session_only(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    (tmp_path / "victim.txt").write_text("precious")
    for leads_to in ("victim.txt", "nowhere.h5"):
        link = tmp_path / f"to-{Path(leads_to).stem}.h5"
        link.symlink_to(tmp_path / leads_to)
        status, out, err = trackwright("track", footage, "--force", "-o", link)
        assert (status, out, err.count("\n")) == (1, "", 1)
        assert "it is a link that leads to no session; name the file it leads to" in err
    assert (tmp_path / "victim.txt").read_text() == "precious"
    assert not (tmp_path / "nowhere.h5").exists()


def test_an_export_replaces_text_and_no_video(
    trackwright: Trackwright, session: Path, footage: Path, tmp_path: Path
) -> None:
    video = tmp_path / "victim.mp4"
    before = (footage / "left.mp4").read_bytes()
    video.write_bytes(before)
    status, out, err = trackwright("export", session, "-o", video, "--format", "mot")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert f"{video} is not a text file and would be lost; choose another name with -o, or" in err
    assert video.read_bytes() == before
    text = tmp_path / "t.txt"
    text.write_text("an older export\n")
    assert trackwright("export", session, "-o", text, "--format", "mot", "--force")[0] == 0
    assert "older" not in text.read_text()


def test_an_unknown_format_is_told(trackwright: Trackwright, made: Path, tmp_path: Path) -> None:
    words = ["export", made, "-o", tmp_path / "t.txt", "--format", "mpeg"]
    status, _, err = trackwright(*words)
    assert status == 2
    assert "choose one of: mot" in err


@pytest.mark.parametrize("command", ["info", "score", "export"])
@pytest.mark.parametrize("damage", ["truncated", "empty", "of another program", "missing"])
def test_a_broken_session_is_one_line_and_status_1(
    trackwright: Trackwright, session: Path, tmp_path: Path, command: str, damage: str
) -> None:
    if damage == "truncated":
        session.write_bytes(session.read_bytes()[: session.stat().st_size // 2])
    elif damage == "empty":
        session.write_bytes(b"")
    elif damage == "missing":
        session.unlink()
    else:
        with h5py.File(session, "w") as file:
            file["spectrum"] = np.arange(5)
    more = {"score": ["--truth", session], "export": ["-o", tmp_path / "t", "--format", "mot"]}
    status, out, err = trackwright(command, session, *more.get(command, []))
    assert (status, out) == (1, "")
    assert err.count("\n") == 1
    assert "square.h5" in err
    assert "bug" not in err
    assert not (tmp_path / "t").exists()


@pytest.mark.parametrize("command", ["synth", "track", "export"])
def test_a_full_disk_leaves_what_was_there(
    footage: Path, made: Path, tmp_path: Path, command: str
) -> None:
    resource = pytest.importorskip("resource")

    def limited() -> None:
        """As good as a full disk: no file may grow past a few thousand bytes."""
        resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

    words: dict[str, list[str | Path]] = {
        "synth": [
            "synth",
            tmp_path / "new",
            "--scene",
            "lobby",
            "--seconds",
            "0.2",
            "--people",
            "0",
        ],
        "track": ["track", footage, "-o", tmp_path / "s.h5", "--frames", "0:70", "--force"],
        "export": ["export", made, "-o", tmp_path / "t.txt", "--format", "mot"],
    }
    (tmp_path / "s.h5").write_bytes(b"old")
    (tmp_path / "t.txt").write_bytes(b"old")
    done = subprocess.run(
        [sys.executable, "-m", "app", *map(str, words[command])],
        capture_output=True,
        text=True,
        preexec_fn=limited,
    )
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].startswith("trackwright: ")
    assert "bug" not in done.stderr
    assert (tmp_path / "s.h5").read_bytes() == b"old"
    assert (tmp_path / "t.txt").read_bytes() == b"old"
    assert not (tmp_path / "new").exists()
