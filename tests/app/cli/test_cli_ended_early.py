"""A tracker that cannot go on: what it found until then is kept, and told."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.errors import OutputError
from tracking.pipeline import Tracking
from tracking.session import Session

BUG = ZeroDivisionError("by nothing")


@pytest.fixture(autouse=True)
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("platformdirs.user_log_dir", lambda *_, **__: str(tmp_path / "log"))
    return tmp_path / "log" / "errors.log"


@pytest.fixture
def ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Trackers end after some frames, the first of them at once where it begins at frame 30."""
    ends_after(monkeypatch, 3, BUG)


def ends_after(monkeypatch: pytest.MonkeyPatch, frames: int, error: Exception) -> None:
    following = Tracking.__next__

    def next_step(tracking: Tracking) -> object:
        if tracking.done == (0 if tracking.frames[0] == 30 else frames):
            raise error
        return following(tracking)

    monkeypatch.setattr(Tracking, "__next__", next_step)


@pytest.mark.usefixtures("ends")
def test_what_a_tracker_found_before_it_failed_is_kept_under_a_name_of_its_own(
    trackwright: Trackwright, recording: Path, tmp_path: Path, log: Path
) -> None:
    out = tmp_path / "street.h5"
    words = ("track", recording, "-o", out, "--tracker", "stereo-colour", "--frames", "5:20")
    status, printed, err = trackwright(*words, "--json")
    kept = tmp_path / "street-partial.h5"
    assert (status, printed) == (1, "")
    said = "trackwright: stereo-colour ended after 3 of 15 frames"
    bug = (
        f"this is a bug in trackwright: ZeroDivisionError: by nothing; please report it with {log}"
    )
    assert err.splitlines()[-1] == f"{said}: {bug}; frames 5:8 are kept in {kept}"
    assert "next_step" in log.read_text()
    assert not out.exists()
    with closing(Session.open(kept)) as session:
        assert session.runs[0].frames == (5, 8)
        assert session.runs[0].notes == ("stereo-colour ended after 3 of 15 frames",)
    assert trackwright(*words)[0] == 1
    assert (tmp_path / "street-partial-2.h5").exists()


@pytest.mark.usefixtures("ends")
def test_of_a_tracker_that_fails_at_once_nothing_is_kept(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    words = ("-o", tmp_path / "s.h5", "--tracker", "stereo-colour", "--frames", "30:33")
    status, _, err = trackwright("track", recording, *words)
    assert status == 1
    assert "ended after" not in err
    assert not list(tmp_path.glob("*.h5"))


def test_why_a_tracker_ended_and_what_to_do_is_told_in_the_same_line(
    trackwright: Trackwright, recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ends_after(monkeypatch, 2, OutputError("the disk is full", "make room"))
    words = ("-o", tmp_path / "s.h5", "--tracker", "stereo-colour", "--frames", "0:9")
    err = trackwright("track", recording, *words)[2]
    assert "ended after 2 of 9 frames: the disk is full; make room; frames 0:2 are kept in" in err


def test_tracking_again_keeps_it_in_a_copy_of_the_session(
    trackwright: Trackwright, recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = tmp_path / "s.h5"
    words = ("--tracker", "stereo-colour", "--frames", "0:4")
    assert trackwright("track", recording, "-o", first, *words)[0] == 0
    before = first.read_bytes()
    ends_after(monkeypatch, 2, BUG)
    status, _, err = trackwright("track", "--again", first, "--from", "3", "--accept")
    kept = tmp_path / "s-partial.h5"
    assert status == 1
    assert err.splitlines()[-1].endswith(f"frames 3:5 are kept in {kept}")
    assert first.read_bytes() == before
    with closing(Session.open(kept)) as session:
        assert [run.frames for run in session.runs] == [(0, 4), (3, 5)]
        assert not len(session.history)


@pytest.mark.usefixtures("ends")
def test_why_it_ended_is_told_also_where_the_system_refuses_what_was_tracked(
    trackwright: Trackwright, recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(13, "Permission denied", "/data/recordings.json")

    monkeypatch.setattr("app.cli.track.remember_place", refuse)
    words = ("track", recording, "-o", tmp_path / "street.h5", "--tracker", "stereo-colour")
    status, _, err = trackwright(*words)
    last = err.splitlines()[-1]
    assert status == 1
    assert "ended after 3 of" in last
    assert "ZeroDivisionError: by nothing" in last
    assert "could not be kept: cannot use /data/recordings.json: Permission denied" in last
