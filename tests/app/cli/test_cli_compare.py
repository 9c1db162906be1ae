"""`trackwright compare` from end to end."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from app.features.comparison.agreement import read_other
from tracking.editing import plan_delete, plan_swap
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Run


@pytest.fixture
def swapped(session: Path, tmp_path: Path) -> Path:
    """A second person's session of the same recording, with two ids swapped from frame 60 on."""
    path = Path(shutil.copy(session, tmp_path / "other.h5"))
    with closing(Session.open(path)) as other:
        a, b = other.tracks.of_frame(60)["track"].tolist()[:2]
        other.apply(plan_swap(other.tracks, a, b, 60))
        other.save()
    return path


def test_a_session_agrees_with_a_copy_of_itself(trackwright: Trackwright, session, swapped):
    status, out, err = trackwright("compare", session, session, "--json")
    figures = json.loads(out)
    assert (status, err) == (0, "")
    assert (figures["IDF1"], figures["kappa"], figures["disagreements"]) == (1.0, 1.0, [])


def test_disagreements_are_counted_as_in_the_window(trackwright, session, tmp_path):
    path = Path(shutil.copy(session, tmp_path / "gaps.h5"))
    with closing(Session.open(path)) as other:
        gone = int(other.tracks.of_frame(60)["track"][0])
        for frame in (58, 61, 64):  # one miss to a person, with two frames between
            other.apply(plan_delete(other.tracks, gone, frame, frame + 1))
        other.save()
    with closing(Session.open(session)) as own:
        seen = read_other(path, own, own.tracks.snapshot(), lambda *_: None).agreement
    figures = json.loads(trackwright("compare", session, path, "--json")[1])
    assert len(figures["disagreements"]) == len(seen.disagreements) == 1


def test_a_swap_is_where_two_sessions_disagree(trackwright: Trackwright, session, swapped):
    figures = json.loads(trackwright("compare", session, swapped, "--json")[1])
    back = json.loads(trackwright("compare", swapped, session, "--json")[1])
    assert 0 < figures["kappa"] < figures["IDF1"] < 1
    assert (back["IDF1"], back["kappa"]) == (figures["IDF1"], figures["kappa"])
    first = figures["disagreements"][0]
    assert (first["kind"], first["start"]) == ("identity", 60)
    status, out, _ = trackwright("compare", session, swapped)
    assert status == 0
    assert "frames 60 to" in out


@pytest.mark.parametrize("match", ["box", "floor"])
def test_boxes_alone_or_the_floor_alone_can_be_asked_for(
    trackwright: Trackwright, session, swapped, match
):
    status, out, _ = trackwright("compare", session, swapped, "--match", match, "--json")
    assert status == 0
    assert json.loads(out)["disagreements"][0]["start"] == 60


def test_sessions_of_different_recordings_are_refused_in_one_line(
    trackwright: Trackwright, session, recording: Path, tiny_run: Run, tmp_path: Path
):
    video = recording / "left.mp4"
    video.write_bytes(video.read_bytes() + b"\0" * 64)
    with open_recording(recording) as footage:
        Session.create(footage, [tiny_run], tmp_path / "elsewhere.h5").close()
    status, out, err = trackwright("compare", session, tmp_path / "elsewhere.h5")
    assert (status, out) == (1, "")
    assert "is of another recording (plaza 3, too, but its files are others)" in err
    assert err.count("\n") == 1
