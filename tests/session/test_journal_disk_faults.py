"""A disk that fails while a journal is opened is no damage: nothing is kept aside, all is there."""

from __future__ import annotations

import errno
import os
import sqlite3
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, make_session

from tracking.errors import SessionError
from tracking.session import Session
from tracking.session.session_writer import companions

CODES = {
    "IOERR_READ": 266,
    "IOERR_CORRUPTFS": 8458,
    "FULL": sqlite3.SQLITE_FULL,
    "CANTOPEN": sqlite3.SQLITE_CANTOPEN,
    "BUSY": sqlite3.SQLITE_BUSY,
    "LOCKED": sqlite3.SQLITE_LOCKED,
    "READONLY": sqlite3.SQLITE_READONLY,
    "NOMEM": None,
}
UNREAD_PAGE = "*** in database main ***\nTree 3 page 2: unable to get the page. error code=266"


class Failing(sqlite3.Connection):
    """A database whose disk fails at one statement of all that are executed."""

    statements = 0
    fails_at = 0
    code: int | None = None

    def execute(self, statement: str, *values: object) -> sqlite3.Cursor:
        self.failing()
        return super().execute(statement, *values)

    def cursor(self) -> sqlite3.Cursor:  # type: ignore[override]
        self.failing()
        return super().cursor()

    @classmethod
    def failing(cls) -> None:
        Failing.statements += 1
        if cls.statements != cls.fails_at:
            return
        if cls.code is None:
            raise MemoryError
        why = sqlite3.OperationalError("the disk fails")
        why.sqlite_errorcode = cls.code
        raise why


@pytest.fixture
def left(session: Session, tmp_path: Path) -> Path:
    """A session beside a journal of five edits that its program left."""
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    Session.open(path).close()  # the log is in the file now
    return path


def damage(path: Path) -> None:
    with sqlite3.connect(companions(path) / "journal.sqlite") as base:
        base.execute("UPDATE steps SET author = 'eve' WHERE number = 4")
    base.close()


def nothing_is_lost(path: Path, recovered: int = 5) -> None:
    """Nothing was kept aside; the next opening finds all edits."""
    assert not list(companions(path).glob("kept-aside*"))
    again = Session.open(path)
    assert (again.read_only, again.recovered) == (False, recovered)
    assert bool(again.damage) == (recovered < 5)
    again.close()


def is_told(session: Session) -> None:
    """It is open for reading, or has all edits; nothing is called damaged."""
    assert session.read_only or session.recovered == 5
    assert all("\n" not in note for note in session.notes)
    assert session.damage == ()
    if session.read_only:
        assert any("cannot be" in note for note in session.notes)


@pytest.mark.parametrize("name", CODES)
def test_a_disk_that_fails_at_any_statement_is_no_damage(
    left: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setattr(Failing, "code", CODES[name])
    monkeypatch.setattr(Failing, "statements", 0)
    with monkeypatch.context() as at_first:
        at_first.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=Failing))
        Session.open(left).close()
        whole = Failing.statements
    assert whole > 10
    for number in range(1, whole + 1, 1 if name in ("IOERR_READ", "NOMEM") else 5):
        with monkeypatch.context() as failing:
            failing.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=Failing))
            failing.setattr(Failing, "statements", 0)
            failing.setattr(Failing, "fails_at", number)
            session = Session.open(left)
            is_told(session)
            session.close()
        nothing_is_lost(left)


@pytest.mark.parametrize("number", [8, 12, 16, 20, 24])
def test_a_disk_that_fails_under_a_damaged_journal_is_not_what_is_told(
    left: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    file = companions(left) / "journal.sqlite"
    data = bytearray(file.read_bytes())
    page = int.from_bytes(data[16:18], "big")
    data[data.rindex(b"apply") // page * page] ^= 2  # its kind is none any more
    file.write_bytes(data)
    monkeypatch.setattr(Failing, "code", CODES["IOERR_READ"])
    with monkeypatch.context() as failing:
        failing.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=Failing))
        failing.setattr(Failing, "statements", 0)
        failing.setattr(Failing, "fails_at", number)
        session = Session.open(left)
        assert session.read_only
        assert all("left where it is" in damage for damage in session.damage)
        session.close()
    assert not list(companions(left).glob("kept-aside*"))


class UnreadPage(sqlite3.Connection):
    """A database of which SQLite could not read a page once while it looked the pages over."""

    times = 0

    def execute(self, statement: str, *values: object) -> sqlite3.Cursor:
        if statement.startswith("PRAGMA quick_check") and UnreadPage.times > 0:
            UnreadPage.times -= 1
            return super().execute("SELECT ?", (UNREAD_PAGE,))
        return super().execute(statement, *values)


@pytest.mark.parametrize("times", [1, 2])
def test_a_page_that_the_disk_does_not_give_is_no_damage(
    left: Path, monkeypatch: pytest.MonkeyPatch, times: int
) -> None:
    def fails(_: Path) -> None:
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    with monkeypatch.context() as failing:
        failing.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=UnreadPage))
        failing.setattr(UnreadPage, "times", times)
        if times > 1:  # it fails on and on
            failing.setattr("tracking.session.journal_schema._read_through", fails)
        session = Session.open(left)
        assert session.read_only
        is_told(session)
        session.close()
    nothing_is_lost(left)


def failing_at(
    real: Callable[..., object],
    calls: Iterator[int],
    turn: int,
    number: int,
    *what: object,
    **more: object,
) -> object:
    """A call that fails at its turn."""
    if next(calls) == turn:
        raise OSError(number, os.strerror(number))
    return real(*what, **more)


@pytest.mark.parametrize("number", [errno.EIO, errno.EACCES, errno.ENOSPC, errno.ENOMEM])
@pytest.mark.parametrize("call", ["lstat", "open", "fstat"])
def test_a_system_call_that_fails_once_is_no_damage(
    left: Path, monkeypatch: pytest.MonkeyPatch, call: str, number: int
) -> None:
    folder, real = companions(left).name, getattr(os, call)
    for failing_one in range(1, 30):
        calls = iter(range(1, 1000))
        fails = partial(failing_at, real, calls, failing_one, number)

        def faulty(*what: object, fails: Callable[..., object] = fails, **more: object) -> object:
            ours = call == "fstat" or folder in str(what[0])
            return fails(*what, **more) if ours else real(*what, **more)

        with monkeypatch.context() as failing:
            failing.setattr(os, call, faulty)
            session = Session.open(left)
        assert session.read_only or session.recovered == 5
        assert session.damage == ()
        session.close()
        nothing_is_lost(left)
        if next(calls) <= failing_one:
            return
    raise AssertionError("it calls without end")


def test_an_interrupted_look_at_a_file_is_repeated(
    left: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, seen = os.lstat, set[str]()

    def interrupted(path: Path) -> os.stat_result:
        if str(path) not in seen:
            seen.add(str(path))
            raise InterruptedError(errno.EINTR, os.strerror(errno.EINTR))
        return real(path)

    with monkeypatch.context() as failing:
        failing.setattr(os, "lstat", interrupted)
        session = Session.open(left)
    assert (session.read_only, session.recovered, session.damage) == (False, 5, ())
    session.close()


@pytest.mark.parametrize("number", [errno.EIO, errno.EACCES, errno.EINTR])
def test_a_session_file_that_cannot_be_looked_at_is_refused_in_one_line(
    left: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    real = os.stat

    def fails(path: object, **more: object) -> object:
        if str(path) == str(left):
            raise OSError(number, os.strerror(number))
        return real(path, **more)  # type: ignore[call-overload]

    with monkeypatch.context() as failing:
        failing.setattr(os, "stat", fails)
        with pytest.raises(
            SessionError, match=r"s\.h5: the session cannot be looked at: .+"
        ) as told:
            Session.open(left)
    assert "\n" not in str(told.value)
    nothing_is_lost(left)


def test_a_slow_disk_is_no_damage(left: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as slow:
        slow.setattr("tracking.session.journal_limits.DISK_S", -1.0)
        session = Session.open(left)
        assert session.read_only
        assert any("takes too long" in note for note in session.notes)
        session.close()
    nothing_is_lost(left)


def test_a_damaged_journal_is_still_kept_aside_when_the_disk_is_well(tmp_path: Path) -> None:
    session = make_session(tmp_path)
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    session.close()
    Session.open(path).close()
    damage(path)
    again = Session.open(path)
    assert (again.read_only, again.recovered) == (False, 3)
    again.close()
    assert (companions(path) / "kept-aside-1.sqlite").exists()
