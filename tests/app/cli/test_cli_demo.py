"""`demo` and `open`, with and without a screen."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import pytest
from command_line import Trackwright

from app.core.document.document_loader import open_path
from tracking.editing import plan_delete
from tracking.session import Session


@pytest.fixture(autouse=True)
def quick_recording(footage: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The demo's recording is a copy of a small one; gives the places it was made at."""
    made: list[Path] = []

    def copied(folder: Path, *_: object, **__: object) -> Path:
        made.append(folder)
        return Path(shutil.copytree(footage, folder))

    monkeypatch.setattr("app.features.files.demonstration.render_recording", copied)
    return made


@dataclass(frozen=True)
class Shown:
    """A window that was opened."""

    path: Path | None
    play: bool
    save_at: Path | None


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> list[Shown]:
    """A screen is there; gives what windows were opened."""
    windows: list[Shown] = []

    def run(
        path: Path | None, _: object = None, *, play: bool = False, save_at: Path | None = None
    ) -> int:
        windows.append(Shown(path, play, save_at))
        return 0

    monkeypatch.setattr("app.shell.application.run", run)
    monkeypatch.setattr("app.cli.demo.has_display", lambda: True)
    monkeypatch.setattr("app.cli.open_window.why_no_window", lambda: "")
    monkeypatch.setattr("app.cli.demo.why_no_window", lambda: "")
    return windows


@pytest.fixture
def corrected(footage: Path, made: Path, tmp_path: Path) -> Path:
    """A demo's folder whose session somebody has worked on."""
    shutil.copytree(footage, tmp_path / "recording")
    shutil.copy(made, tmp_path / "session.h5")
    with closing(Session.open(tmp_path / "session.h5")) as session:
        session.apply(plan_delete(session.tracks, session.tracks.track_ids[0], 0, 80))
        session.save()
    return tmp_path


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
    assert quick_recording == [folder / "recording"]


def test_the_demo_is_made_once_and_tracked_anew(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path, no_picture: None,
    quick_recording: list[Path],
) -> None:  # fmt: skip
    shutil.copytree(footage, tmp_path / "recording")
    shutil.copy(made, tmp_path / "session.h5")
    before = (tmp_path / "session.h5").read_bytes()
    status, out, _ = trackwright("demo", "--out", tmp_path, "--no-gui")
    assert status == 0
    assert str(tmp_path / "window.png") in out
    assert quick_recording == []
    assert (tmp_path / "session.h5").read_bytes() != before


def test_corrections_in_the_demo_are_kept(
    trackwright: Trackwright, corrected: Path, no_picture: None
) -> None:
    before = (corrected / "session.h5").read_bytes()
    status, _, err = trackwright("demo", "--out", corrected, "--no-gui", "--json")
    assert status == 0
    assert "is kept" in err
    assert (corrected / "session.h5").read_bytes() == before


def test_with_a_screen_the_window_plays_the_recording_and_proposes_a_place_for_the_session(
    trackwright: Trackwright, tmp_path: Path, shown: list[Shown]
) -> None:
    assert trackwright("demo", "--out", tmp_path)[0] == 0
    assert shown == [Shown(tmp_path / "recording", True, tmp_path / "session.h5")]


def test_with_a_screen_the_window_goes_on_with_corrections(
    trackwright: Trackwright, corrected: Path, shown: list[Shown]
) -> None:
    assert trackwright("demo", "--out", corrected)[0] == 0
    assert shown == [Shown(corrected / "session.h5", True, corrected / "session.h5")]


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
    trackwright: Trackwright, footage: Path, shown: list[Shown]
) -> None:
    assert trackwright("open")[0] == 0
    assert trackwright("open", footage)[0] == 0
    assert trackwright("open", "--left", footage / "left.mp4")[0] == 0
    paths = [None, footage, footage / "left.mp4"]
    assert shown == [Shown(path, False, None) for path in paths]


@pytest.mark.parametrize("name", ["nope.h5", "nope"])
def test_a_path_that_holds_nothing_is_told_before_any_window(
    trackwright: Trackwright, tmp_path: Path, shown: list[Shown], name: str
) -> None:
    status, _, err = trackwright("open", tmp_path / name)
    assert status == 1
    assert err.count("\n") == 1
    assert "check the path" in err
    assert not shown


def test_a_session_that_is_gone_is_opened_where_there_are_backups(
    trackwright: Trackwright, session: Path, shown: list[Shown]
) -> None:
    with closing(Session.open(session)) as opened:
        opened.apply(plan_delete(opened.tracks, opened.tracks.track_ids[0], 0, 80))
        opened.save()
    session.unlink()
    assert trackwright("open", session)[0] == 0
    assert shown


def test_open_needs_a_screen(
    trackwright: Trackwright, footage: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    status, _, err = trackwright("open", footage)
    assert status == 1
    assert "no display" in err


def test_a_moved_recording_can_be_named(
    trackwright: Trackwright, session: Path, footage: Path, tmp_path: Path, shown: list[Shown]
) -> None:
    status, _, err = trackwright("open", session, "--recording", tmp_path / "nowhere")
    assert status == 1
    assert "--recording" in err
    assert trackwright("open", session, "--recording", footage)[0] == 0
    assert shown == [Shown(session, False, None)]
    document = open_path(session).document
    assert document.recording.path == footage
    document.recording.close()
    assert document.session is not None
    document.session.close()
