"""`doctor` names the cure of ten faults: those of Python, screen and sessions are planted here.

The others are in test_installation_faults.py: a second OpenCV or Qt, a full disk, damaged files.
"""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from app.cli import installation, session_faults
from app.cli.installation import Check, check_installation
from app.cli.system_libraries import Machine, this_machine
from tracking.editing import plan_delete
from tracking.session import Session
from tracking.session.session_writer import companions


def said_of(checks: Iterator[Check]) -> dict[str, Check]:
    return {one.name: one for one in checks}


@pytest.fixture
def healthy(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine whose Qt starts, and no sessions: the probe takes seconds."""
    machine = Machine(lambda: "", False, False, lambda _: 0)
    monkeypatch.setattr(installation, "this_machine", lambda: machine)
    monkeypatch.setattr(installation, "recent_sessions", lambda: ())
    monkeypatch.setattr(installation, "find_faults", lambda _: iter(()))


@pytest.mark.usefixtures("healthy")
def test_a_python_that_is_too_old_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation.sys, "version_info", (3, 10, 2))
    check = said_of(check_installation())["python"]
    assert not check.is_well
    assert "install Python 3.11 or newer" in check.said


@pytest.mark.usefixtures("healthy")
def test_no_display_is_told_and_is_not_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation.sys, "platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    check = said_of(check_installation())["display"]
    assert (check.is_well, check.needed) == (False, False)
    assert "the window needs a screen" in check.said


@pytest.mark.usefixtures("healthy")
def test_a_home_that_cannot_be_written_to_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"):
        monkeypatch.setenv(name, str(tmp_path / "home"))
    really = installation.os.access
    refuses = lambda path, mode: tmp_path not in Path(path, "x").parents and really(path, mode)  # noqa: E731
    monkeypatch.setattr(installation.os, "access", refuses)
    checks = said_of(check_installation())
    for name in ("settings folder", "data folder"):
        assert not checks[name].is_well
        assert f"{tmp_path} is not writable; have its owner let you" in checks[name].said


@pytest.mark.slow
def test_a_library_that_screens_need_is_told_with_its_cure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "libxcb-cursor.so.0").write_text("no library")
    monkeypatch.setenv("LD_LIBRARY_PATH", str(tmp_path))
    monkeypatch.setenv("DISPLAY", ":99")
    monkeypatch.setattr(installation, "recent_sessions", lambda: ())
    check = said_of(check_installation())["qt"]
    assert not check.is_well
    assert "libxcb-cursor.so.0" in check.said
    assert "python -m app.cli.system_libraries" in check.said


@pytest.mark.slow
def test_a_system_without_fonts_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "fonts.conf").write_text("<fontconfig></fontconfig>")
    monkeypatch.setenv("FONTCONFIG_FILE", str(tmp_path / "fonts.conf"))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setenv("QT_QPA_FONTDIR", str(tmp_path))
    assert this_machine().missing() == "Qt finds no font to write with"


def edited(session: Path) -> None:
    """Leave an edit in the journal alone."""
    with closing(Session.open(session)) as opened:
        track = opened.tracks.track_ids[0]
        start = int(opened.tracks.of_track(track)["frame"][0])
        opened.apply(plan_delete(opened.tracks, track, start, start + 2))


def test_a_session_that_is_open_is_told_with_who_has_it(
    trackwright: Trackwright, session: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with closing(Session.open(session)):
        status, said, _ = trackwright("doctor", session)
        monkeypatch.setattr(session_faults, "recent_sessions", lambda: (session,))
        (said_too,) = [one[1] for one in session_faults.find_session_faults([session])]
    assert status == 0
    assert "is open in process" in said
    assert "close it there first" in said
    assert str(said_too) in said
    assert "opens as it should" in trackwright("doctor", session)[1]


def test_edits_that_only_the_journal_has_are_told(trackwright: Trackwright, session: Path) -> None:
    edited(session)
    document = json.loads(trackwright("doctor", session, "--json")[1])
    (finding,) = document["findings"]
    assert finding["code"] == "session square.h5"
    assert "1 edit is in its journal alone; open the session and save it" in finding["fix"]


def test_a_journal_of_another_save_is_told_with_what_happens_to_it(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    as_it_was = tmp_path / "before.h5"
    shutil.copy(session, as_it_was)
    edited(session)
    (journal,) = companions(session).glob("*.sqlite")
    with closing(sqlite3.connect(journal)) as base:
        base.execute("UPDATE origin SET save = 'of long ago'")
        base.commit()
    said = trackwright("doctor", session)[1]
    assert "the journal belongs to another session or to another save" in said
    assert "kept aside" in said


def test_a_session_that_cannot_be_read_ends_in_one_line(
    trackwright: Trackwright, session: Path
) -> None:
    session.write_bytes(session.read_bytes()[:2000])
    status, _, told = trackwright("doctor", session)
    assert status == 1
    assert len(told.strip().splitlines()) == 1
