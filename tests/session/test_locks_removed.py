"""Somebody takes a lock away by hand: what either program acknowledged is kept, and told."""

from __future__ import annotations

import errno
import os
import sqlite3
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, make_session, state_of

from tracking.editing import plan_rename, plan_split
from tracking.errors import OutputError, SessionError
from tracking.session import Session, store
from tracking.session.journal import Journal
from tracking.session.journal_schema import SELECT
from tracking.session.session_writer import companions
from tracking.session.store import Store


def other_program(session: Session) -> Session:
    """The session opened once more, after its lock was taken away."""
    assert session.path is not None
    if session._store is not None:
        _ = session._store.journal  # waits for the thread that makes it: half a file locks others
    (companions(session.path) / "lock").unlink()
    other = Session.open(session.path)
    assert not other.read_only, other.why_read_only
    return other


def texts_beside(path: Path) -> list[str]:
    """What the steps of all journals beside a session say, those set aside too."""
    found = []
    for file in sorted(companions(path).glob("*.sqlite")):
        base = sqlite3.connect(file)
        found += [text for (text,) in base.execute("SELECT text FROM steps ORDER BY number")]
        base.close()
    return found


def test_edits_kept_aside_are_told_to_whoever_opens_the_session_next(session: Session) -> None:
    edit(session, swaps=2)
    path = session.path
    assert path is not None
    other = other_program(session)
    other.apply(plan_rename(other.tracks, other.labels, 1, "red coat"))
    other.close()
    with pytest.raises(SessionError, match="another program edited this session"):
        session.save()
    session._let_go(keep_journal=True)  # it is killed
    for look in (Session.look_into, Session.open):
        opened = look(path)
        told = [note for note in opened.notes if "kept-aside-1.sqlite" in note]
        opened.close()
        assert len(told) == 1
        assert told[0].startswith("3 edits made after the last save of ")


def test_a_save_after_edits_were_kept_aside_keeps_that_told(session: Session) -> None:
    path = session.path
    assert path is not None
    other = other_program(session)
    other.apply(plan_rename(other.tracks, other.labels, 1, "red coat"))
    other.close()
    with pytest.raises(SessionError, match="another program edited this session"):
        session.save()
    session.save()
    session.close()
    again = Session.open(path)
    assert [True for note in again.notes if "another program edited" in note] == [True]
    again.close()


@pytest.mark.parametrize("edits_before", [0, 2])
def test_an_edit_of_the_second_program_is_kept_aside_and_told(
    session: Session, edits_before: int, tmp_path: Path
) -> None:
    edit(session, swaps=edits_before)
    other = other_program(session)
    other.apply(plan_rename(other.tracks, other.labels, 1, "red coat"))
    other.close()
    state = state_of(session)
    with pytest.raises(SessionError, match="another program edited this session") as told:
        edit(session)
    assert "kept-aside-1.sqlite" in str(told.value)
    assert state_of(session) == state
    edit(session)
    assert session.path is not None
    assert any("red coat" in text for text in texts_beside(session.path))
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()


def test_while_the_second_program_has_it_the_first_one_may_not_edit(session: Session) -> None:
    edit(session)
    other = other_program(session)
    edit(other)
    with pytest.raises(SessionError, match="is open in process"):
        edit(session)
    session.close()
    edit(other)
    assert session.path is not None
    state = state_of(other)
    other.close()
    again = Session.open(session.path)
    assert state_of(again) == state
    again.close()


def test_a_first_program_that_closes_takes_no_edit_of_the_second_with_it(session: Session) -> None:
    other = other_program(session)
    edit(other)
    state = state_of(other)
    other.close()
    session.close()
    assert session.path is not None
    again = Session.open(session.path)
    assert (state_of(again), again.recovered) == (state, 1)
    again.close()


def test_a_save_of_the_first_program_takes_no_edit_of_the_second_with_it(
    session: Session,
) -> None:
    edit(session)
    pending = session.begin_save()
    other = other_program(session)
    other.apply(plan_split(other.tracks, 1, 20))
    pending.write()
    session.finish_save(pending)
    other.close()
    session.close()
    assert session.path is not None
    again = Session.open(session.path)
    assert again.history.entries[-1].text == other.history.entries[-1].text or any(
        other.history.entries[-1].text in text for text in texts_beside(session.path)
    )
    again.close()


def edited_by_another_program(session: Session, name: str) -> None:
    """Another program opens the session, edits, and closes it; its edit stays in a journal."""
    other = other_program(session)
    other.apply(plan_rename(other.tracks, other.labels, 1, name))
    other.close()


@pytest.mark.parametrize("then", [edit, Session.save])
def test_a_program_whose_journal_was_kept_aside_takes_over_no_other_one(
    session: Session, then: Callable[[Session], object]
) -> None:
    edit(session)
    edited_by_another_program(session, "red coat")
    with pytest.raises(SessionError, match="kept-aside-1"):
        edit(session)
    edited_by_another_program(session, "green hat")
    with pytest.raises(SessionError, match="kept-aside-2"):
        then(session)
    then(session)
    session.close()
    assert session.path is not None
    said = " ".join(texts_beside(session.path))
    assert "red coat" in said
    assert "green hat" in said


def full(*_: object) -> None:
    raise OutputError("the disk is full")


def test_a_program_that_could_begin_no_journal_writes_into_no_other_one(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert session.path is not None
    session.close()
    with monkeypatch.context() as at_first:
        at_first.setattr(Journal, "start_over", full)
        session = Session.open(session.path)
        with pytest.raises(OutputError, match="the disk is full"):
            edit(session)
    edited_by_another_program(session, "red coat")
    with pytest.raises(SessionError, match="kept-aside-1"):
        edit(session)
    edit(session)
    session.save()
    session.close()
    assert any("red coat" in text for text in texts_beside(session.path))


def test_a_session_saved_by_another_program_while_it_is_opened_keeps_that_ones_edits(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    edit(session)
    session.close()
    assert session.path is not None
    path, claim = session.path, Store.claim

    def after_another_program(claimed: Path) -> Store:
        monkeypatch.setattr(Store, "claim", claim)
        other = Session.open(path)
        other.save()
        other.apply(plan_rename(other.tracks, other.labels, 1, "red coat"))
        other.close()
        return claim(claimed)

    monkeypatch.setattr(Store, "claim", after_another_program)
    again = Session.open(path)
    assert again.recovered == 1
    assert "red coat" in again.history.entries[-1].text
    again.close()


def fail_commits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every step is written, and then said not to be, as where the disk fails at the last."""
    append = Journal.append

    def failing(self: Journal, *what: object) -> None:
        checksums, last, origin = list(self._checksums), self._last, self._origin
        append(self, *what)
        row = self._base.execute(f"{SELECT} WHERE number = ?", (self._last,)).fetchone()
        self._checksums, self._last, self._origin = checksums, last, origin
        self._failed = (row[0], row[-1])
        raise OutputError("the disk failed")

    monkeypatch.setattr(Journal, "append", failing)


def test_a_step_that_was_said_to_fail_is_taken_out_though_it_is_on_the_disk(
    session: Session, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    edit(session)
    with monkeypatch.context() as at_first:
        fail_commits(at_first)
        with pytest.raises(OutputError, match="the disk failed"):
            session.apply(plan_split(session.tracks, 1, 20))
    edit(session)
    assert session.path is not None
    assert not any("Split" in text for text in texts_beside(session.path))
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()


def test_another_step_in_the_place_of_one_that_failed_is_not_taken_out(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(self: Journal, *_: object) -> None:
        self._failed = (1, "apply")
        raise OutputError("the disk failed")

    with monkeypatch.context() as at_first:
        at_first.setattr(Journal, "append", failing)
        with pytest.raises(OutputError, match="the disk failed"):
            edit(session)
    other = other_program(session)
    other.apply(plan_split(other.tracks, 1, 20))
    other.close()
    with pytest.raises(SessionError, match="another program edited"):
        edit(session)
    assert session.path is not None
    assert any("Split" in text for text in texts_beside(session.path))


def refuse(number: int) -> Callable[..., None]:
    def refusing(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    return refusing


@pytest.mark.parametrize("number", [errno.EROFS, errno.EACCES, errno.EIO])
def test_a_lock_that_cannot_be_removed_locks_nobody_out(
    session: Session, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    edit(session)
    session.save()
    with monkeypatch.context() as refused:
        refused.setattr(Path, "unlink", refuse(number))
        session.close()
    assert session.path is not None
    again = Session.open(session.path)
    assert (again.read_only, again.notes) == (False, ())
    edit(again)
    again.close()


class Refusing(sqlite3.Connection):
    """A database on a disk that may be read only for a while."""

    refuses = False

    def execute(self, statement: str, *values: object) -> sqlite3.Cursor:
        if Refusing.refuses and not statement.startswith(("SELECT", "PRAGMA")):
            why = sqlite3.OperationalError("attempt to write a readonly database")
            why.sqlite_errorcode = sqlite3.SQLITE_READONLY
            raise why
        return super().execute(statement, *values)


@pytest.mark.parametrize("refused", [1, 2, 3])
@pytest.mark.parametrize("restores", [True, False])
def test_a_disk_that_refuses_while_restoring_refuses_edits_only_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, restores: bool, refused: int
) -> None:
    monkeypatch.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=Refusing))
    session = make_session(tmp_path)
    edit(session)
    session.save()
    edit(session, swaps=0 if restores else 1)
    monkeypatch.setattr(Refusing, "refuses", True)
    restored = session.restore(1) if restores else session
    for _ in range(refused):
        with pytest.raises(OutputError, match="readonly"):
            edit(restored)
    monkeypatch.setattr(Refusing, "refuses", False)
    edit(restored)
    again = Session.open(crashed(restored, tmp_path / "after"))
    assert state_of(again) == state_of(restored)
    again.close()
    restored.close()


def test_a_folder_that_goes_before_the_lock_is_in_it_is_made_again(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another program closes the session and takes the empty folder away meanwhile."""
    session.close()
    assert session.path is not None
    make, goes = store.make_folder, [True, True]

    def make_what_goes(folder: Path) -> None:
        make(folder)
        if goes:
            goes.pop()
            folder.rmdir()

    monkeypatch.setattr(store, "make_folder", make_what_goes)
    again = Session.open(session.path)
    assert (again.read_only, again.notes, goes) == (False, (), [])
    edit(again)
    again.close(discard=True)
