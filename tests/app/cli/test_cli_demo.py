"""`demo` and `open`, with and without a screen."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_delete
from tracking.session import Session


@pytest.fixture(autouse=True)
def quick_recording(footage: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The demo's recording is a copy of a small one; gives the places it was made at."""
    made: list[Path] = []

    def copied(folder: Path, *_: object) -> Path:
        made.append(folder)
        return Path(shutil.copytree(footage, folder))

    monkeypatch.setattr("app.cli.demo.render_recording", copied)
    return made


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> list[Path | None]:
    """A screen is there; gives what windows were opened on."""
    paths: list[Path | None] = []

    def run(path: Path | None, options: object = None) -> int:
        paths.append(path)
        return 0

    monkeypatch.setattr("app.views.application.run", run)
    monkeypatch.setattr("app.cli.demo.has_display", lambda: True)
    monkeypatch.setattr("app.cli.open_window.has_display", lambda: True)
    return paths


@pytest.fixture
def no_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    """Saves the time of drawing the window where it is not looked at."""
    monkeypatch.setattr("app.cli.demo._picture", lambda _, place: place)


def test_the_demo_ends_in_a_session_a_score_and_a_picture(
    trackwright: Trackwright, tmp_path: Path, quick_recording: list[Path]
) -> None:
    folder = tmp_path / "new" / "demo"
    status, out, _ = trackwright("demo", "--out", folder, "--no-gui", "--json")
    assert status == 0
    result = json.loads(out)
    assert result["recording"] == str(folder / "recording")
    assert result["session"] == str(folder / "session.h5")
    assert Path(result["picture"]).read_bytes().startswith(b"\x89PNG")
    assert result["score"]["frames"] == 80
    again = trackwright("demo", "--out", folder, "--no-gui")
    assert again[0] == 0
    assert str(folder / "window.png") in again[1]
    assert quick_recording == [folder / "recording"]


def test_corrections_in_the_demo_are_kept(
    trackwright: Trackwright, tmp_path: Path, no_picture: None
) -> None:
    words = ["demo", "--out", tmp_path, "--no-gui", "--json"]
    assert trackwright(*words)[0] == 0
    with closing(Session.open(tmp_path / "session.h5")) as session:
        session.apply(plan_delete(session.tracks, session.tracks.track_ids[0], 0, 80))
        session.save()
    before = (tmp_path / "session.h5").read_bytes()
    status, _, err = trackwright(*words)
    assert status == 0
    assert "is kept" in err
    assert (tmp_path / "session.h5").read_bytes() == before


def test_with_a_screen_the_window_opens_on_the_recording(
    trackwright: Trackwright, tmp_path: Path, shown: list[Path | None]
) -> None:
    assert trackwright("demo", "--out", tmp_path)[0] == 0
    assert shown == [tmp_path / "recording"]


def test_a_damaged_demo_says_how_to_mend_it(trackwright: Trackwright, tmp_path: Path) -> None:
    (tmp_path / "recording").mkdir()
    status, _, err = trackwright("demo", "--out", tmp_path, "--no-gui")
    assert status == 1
    assert "is made anew" in err


def test_a_demo_that_cannot_be_written_is_told(trackwright: Trackwright, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    status, _, err = trackwright("demo", "--out", tmp_path / "file" / "demo", "--no-gui")
    assert status == 1
    assert err.count("\n") == 1
    assert "file" in err


def test_open_shows_what_is_named(
    trackwright: Trackwright, footage: Path, shown: list[Path | None]
) -> None:
    assert trackwright("open")[0] == 0
    assert trackwright("open", footage)[0] == 0
    assert trackwright("open", "--left", footage / "left.mp4")[0] == 0
    assert shown == [None, footage, footage / "left.mp4"]


def test_open_needs_a_screen(
    trackwright: Trackwright, footage: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.cli.open_window.has_display", lambda: False)
    status, _, err = trackwright("open", footage)
    assert status == 1
    assert "no display" in err


def test_a_moved_recording_can_be_named(
    trackwright: Trackwright, tmp_path: Path, shown: list[Path | None], no_picture: None
) -> None:
    assert trackwright("demo", "--out", tmp_path / "demo", "--no-gui")[0] == 0
    (tmp_path / "demo" / "recording").rename(tmp_path / "elsewhere")
    session = tmp_path / "demo" / "session.h5"
    status, _, err = trackwright("open", session, "--recording", tmp_path / "nowhere")
    assert status == 1
    assert "--recording" in err
    assert trackwright("open", session, "--recording", tmp_path / "elsewhere")[0] == 0
    assert shown == [session]
