"""Sessions saved elsewhere, opened twice, and journals that do not fit."""

from __future__ import annotations

import errno
import os
import shutil
import sqlite3
from pathlib import Path

import h5py
import pytest
from made_up_sessions import crashed, edit, make_recording, make_run, make_session, state_of

from tracking.editing import Change, State, plan_split
from tracking.errors import OutputError, SessionError
from tracking.session import Session, find_backups
from tracking.session.journal import Journal
from tracking.session.journal_rows import number_rows
from tracking.session.journal_schema import SELECT
from tracking.session.session_writer import companions
from tracking.session.store import Store


def test_saving_under_another_name_goes_on_there(session: Session, tmp_path: Path) -> None:
    edit(session)
    first = session.path
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    session.save(elsewhere / "copy.h5")
    assert session.path == elsewhere / "copy.h5"
    assert session.recording.path == "../recording"
    session.apply(plan_split(session.tracks, 1, 20))
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()
    assert first is not None
    old = Session.open(first)
    assert (len(old.history), old.read_only) == (0, False)
    old.close()


def test_a_session_never_saved_is_saved_where_it_is_told(tmp_path: Path) -> None:
    made = Session.create(make_recording(tmp_path / "recording"), [make_run()])
    edit(made)
    with pytest.raises(SessionError, match="name one"):
        made.save()
    made.save(tmp_path / "s.h5")
    edit(made)
    again = Session.open(crashed(made, tmp_path / "after"))
    assert state_of(again) == state_of(made)
    again.close()
    made.close()


def test_a_second_opener_reads_only_and_is_told(session: Session) -> None:
    edit(session)
    assert session.path is not None
    second = Session.open(session.path)
    assert second.read_only
    assert "open in process" in second.notes[0]
    assert "not shown" in second.notes[1]
    with pytest.raises(SessionError, match="another name"):
        edit(second)
    with pytest.raises(SessionError, match="another name"):
        second.save()
    second.close()
    assert not session.read_only
    edit(session)


def test_a_session_open_for_reading_can_be_saved_elsewhere(
    session: Session, tmp_path: Path
) -> None:
    assert session.path is not None
    second = Session.open(session.path)
    second.save(tmp_path / "mine.h5")
    assert not second.read_only
    edit(second)
    second.close()


def test_nobody_saves_over_a_session_that_is_open(session: Session, tmp_path: Path) -> None:
    other = make_session(tmp_path / "other")
    with pytest.raises(SessionError, match="close it there first"):
        other.save(session.path)
    assert other.path == tmp_path / "other" / "s.h5"
    other.close()


def test_a_journal_that_cannot_be_moved_yet_does_not_undo_a_save_over_its_session(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = make_session(tmp_path / "other")
    edit(other, swaps=3)
    theirs, path = state_of(other), other.path
    other.close()
    assert path is not None
    rename = Path.replace

    def fails(file: Path, target: Path) -> Path:
        if file.name.startswith("journal.sqlite"):
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return rename(file, target)

    with monkeypatch.context() as failing:
        failing.setattr(Path, "replace", fails)
        assert session.save(path) == session.path == path
        before = state_of(session)
        with pytest.raises(OutputError, match="cannot be kept aside"):
            edit(session)
        assert state_of(session) == before
    with pytest.raises(SessionError, match="kept-aside-1"):  # said once
        edit(session)
    edit(session)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert (state_of(again), again.damage) == (state_of(session), ())
    again.close()
    was = tmp_path / "was"  # what stood there before, with its edits
    (was / companions(path).name).mkdir(parents=True)
    shutil.copy(find_backups(path)[0], was / path.name)
    for file in companions(path).glob("kept-aside-1.sqlite*"):
        ending = file.name.removeprefix("kept-aside-1.sqlite")
        shutil.copy(file, was / companions(path).name / f"journal.sqlite{ending}")
    found = Session.open(was / path.name)
    assert (state_of(found), found.damage) == (theirs, ())
    found.close()


def test_a_save_that_cannot_begin_locks_nobody_out(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = make_session(tmp_path / "other")
    other.close()
    assert other.path is not None

    def fails(*_: object) -> None:
        raise SessionError("its runs are out of reach")

    with monkeypatch.context() as failing:
        failing.setattr(Session, "_as_it_is", fails)
        with pytest.raises(SessionError, match="out of reach"):
            session.save(other.path)
    again = Session.open(other.path)
    assert not again.read_only
    again.close()


def test_the_journal_of_another_save_is_kept_aside(session: Session, tmp_path: Path) -> None:
    old = tmp_path / "old.h5"
    assert session.path is not None
    shutil.copy(session.path, old)
    edit(session)
    session.save()
    edit(session)
    after = crashed(session, tmp_path / "after")
    shutil.copy(old, after)  # the user put an older file in its place
    again = Session.open(after)
    assert len(again.history) == 0
    assert "kept aside" in again.notes[0]
    edit(again)
    again.close()
    assert list(companions(after).glob("kept-aside-*.sqlite"))


@pytest.mark.parametrize("data", [b"", b"no journal at all" * 400])
def test_a_damaged_journal_does_not_keep_a_session_from_opening(
    session: Session, data: bytes
) -> None:
    assert session.path is not None
    session.close()
    companions(session.path).mkdir()
    (companions(session.path) / "journal.sqlite").write_bytes(data)
    again = Session.open(session.path)
    edit(again)
    again.save()
    again.close()


def test_one_recovered_edit_is_told_as_one(session: Session, tmp_path: Path) -> None:
    edit(session)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert again.notes == ("Recovered: 1 edit made after the session was saved last",)
    again.close()


def unfit(path: Path, number: int) -> Path:
    """The session, with a step of its journal that does not fit, though nothing damaged it."""
    with sqlite3.connect(companions(path) / "journal.sqlite") as journal:
        journal.execute("UPDATE steps SET before = '{', after = '{' WHERE number = ?", (number,))
        origin = journal.execute("SELECT session, save FROM origin").fetchone()
        rows = journal.execute(f"{SELECT} ORDER BY number").fetchall()
        for row in number_rows(rows, *origin):
            journal.execute("UPDATE steps SET checksum = ? WHERE number = ?", (row[-1], row[0]))
    journal.close()
    return path


def test_steps_that_do_not_fit_are_kept_aside(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=3)
    again = Session.open(unfit(crashed(session, tmp_path / "after"), 2))
    assert again.recovered == 1
    assert "2 edits do not fit" in again.notes[1]
    again.close()


def test_an_edit_that_does_not_fit_is_told_once_however_often_it_was_undone(
    session: Session, tmp_path: Path
) -> None:
    edit(session)
    session.undo()
    session.redo()
    again = Session.open(unfit(crashed(session, tmp_path / "after"), 1))
    assert again.recovered == 0
    assert [note.partition("(")[0] for note in again.notes] == ["1 edit does not fit "]
    again.close()


def test_an_edit_made_by_hand_must_touch_what_is_there(session: Session) -> None:
    nothing = Change("swap", "Swap nothing", 0, State(), State())
    session.apply(nothing)
    assert session.history.entries[0].text == "Swap nothing"


def test_the_file_is_never_open_while_nobody_reads_it(session: Session) -> None:
    with h5py.File(session.path, "a") as file:  # would fail for a file that is open elsewhere
        assert file.attrs["format"] == "trackwright-session"


def test_a_journal_that_cannot_be_trimmed_is_no_failed_save(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OutputError("no room")

    edit(session)
    with monkeypatch.context() as patch:
        patch.setattr(Journal, "start_over", full)
        session.save()
    assert not session.dirty
    session.apply(plan_split(session.tracks, 1, 20))
    once = Session.open(crashed(session, tmp_path / "once"))
    assert (state_of(once), once.recovered) == (state_of(session), 1)
    once.close()
    pending = session.begin_save()
    session.undo()
    pending.write()
    twice = Session.open(crashed(session, tmp_path / "twice"))
    assert (state_of(twice), twice.recovered) == (state_of(session), 1)
    twice.close()
    session.finish_save(pending)


def test_edits_made_while_saving_elsewhere_outlive_a_second_save_that_fails(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = session.path
    pending = session.begin_save(tmp_path / "other.h5")
    edit(session)
    pending.write()

    def full(*_: object) -> None:
        raise OutputError("no room")

    with monkeypatch.context() as patch:
        patch.setattr("tracking.session.pending_save.replace_verified", full)
        with pytest.raises(OutputError):
            session.finish_save(pending)
    session.abandon_save(pending)
    assert session.path == tmp_path / "other.h5"
    assert first is not None
    old = Session.open(first)
    assert state_of(old) == state_of(session)
    old.close()
    session.apply(plan_split(session.tracks, 1, 20))
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()


def test_what_another_program_saved_while_a_session_was_opened_is_not_missed(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert session.path is not None
    claim = Store.claim

    def late(path: Path) -> Store:
        if session.dirty:
            session.save()
            session.close()
        return claim(path)

    edit(session)
    monkeypatch.setattr(Store, "claim", late)
    second = Session.open(session.path)
    assert (state_of(second), second.read_only) == (state_of(session), False)
    second.close()
