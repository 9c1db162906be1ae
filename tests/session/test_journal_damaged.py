"""A journal that lost steps, or of which a bit flipped, is told of; what is sound is made again."""

from __future__ import annotations

import re
import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, make_session, state_of

from tracking.errors import SessionError
from tracking.session import Session
from tracking.session.journal import Journal
from tracking.session.journal_rows import number_rows
from tracking.session.journal_schema import SELECT
from tracking.session.session_writer import companions

WAL_HEADER, FRAME_HEADER = 32, 24


def journal_of(path: Path) -> Path:
    return companions(path) / "journal.sqlite"


def wal_of(path: Path) -> Path:
    return companions(path) / "journal.sqlite-wal"


def frames_of(wal: Path) -> list[int]:
    """Where the frames of the log begin."""
    data = wal.read_bytes()
    page = int.from_bytes(data[8:12], "big")
    return list(range(WAL_HEADER, len(data), FRAME_HEADER + page))


def flip(file: Path, at: int, bit: int = 0) -> None:
    data = bytearray(file.read_bytes())
    data[at] ^= 1 << bit
    file.write_bytes(data)


@pytest.fixture
def left(session: Session, tmp_path: Path) -> Path:
    """A session as a program leaves it that dies after five edits, all of them in the log."""
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    assert wal_of(path).stat().st_size > WAL_HEADER
    return path


def is_told(path: Path, recovered: int | None = None) -> None:
    """The session opens with what is sound, says what may be missing, keeps it, and goes on."""
    session = Session.open(path)
    try:
        assert not session.read_only
        assert any("may be missing" in note and "kept aside" in note for note in session.notes)
        assert all("\n" not in note for note in session.notes)
        assert session.recovered < 5 if recovered is None else session.recovered == recovered
        assert list(companions(path).glob("kept-aside-*.sqlite*"))
        edit(session)
        state = state_of(session)
    finally:
        session.close()
    again = Session.open(path)
    assert state_of(again) == state
    assert not any("may be missing" in note for note in again.notes)
    again.close()


def test_a_sound_journal_is_no_news(left: Path) -> None:
    session = Session.open(left)
    assert session.notes == ("Recovered: 5 edits made after the session was saved last",)
    session.close()


@pytest.mark.parametrize("kept", [1, 2, -1])
def test_frames_cut_from_the_end_of_the_log_are_told(left: Path, kept: int) -> None:
    wal = wal_of(left)
    wal.write_bytes(wal.read_bytes()[: frames_of(wal)[kept]])
    is_told(left)


def test_a_log_that_is_gone_is_told(left: Path) -> None:
    wal_of(left).unlink()
    (companions(left) / "journal.sqlite-shm").unlink(missing_ok=True)
    is_told(left, 0)


def test_a_journal_that_is_gone_is_told(left: Path) -> None:
    for ending in ("", "-wal", "-shm"):
        (companions(left) / f"journal.sqlite{ending}").unlink(missing_ok=True)
    is_told(left, 0)


@pytest.mark.parametrize("where", ["header", "frame", "page"])
def test_a_flipped_bit_in_the_log_is_told(left: Path, where: str) -> None:
    frame = frames_of(wal_of(left))[2]
    flip(wal_of(left), {"header": 17, "frame": frame + 9, "page": frame + 2000}[where])
    (companions(left) / "journal.sqlite-shm").unlink(missing_ok=True)
    is_told(left)


COLUMNS = (
    *("act", "edit", "time", "author", "kind", "text", "frame"),
    *("before", "after", "undoes", "scope", "checksum"),
)


def recovered_steps(path: Path) -> tuple[int, str]:
    """How many steps a session's journal gives, and why there are no more, as opening finds it."""
    journal = Journal(journal_of(path))
    try:
        contents = journal.contents()
    finally:
        journal.close()
    return len(contents.steps), contents.problem


def flipped_values(value: str | int) -> Iterator[str | int | bytes]:
    """A value with each of its bits flipped."""
    if isinstance(value, int):
        yield from (value ^ 1 << bit for bit in range(31))
        return
    data = value.encode()
    for bit in range(8 * len(data)):
        damaged = bytearray(data)
        damaged[bit // 8] ^= 1 << bit % 8
        yield bytes(damaged)


@pytest.mark.parametrize("column", COLUMNS)
def test_a_bit_of_the_last_step_costs_that_step_alone(left: Path, column: str) -> None:
    Session.open(left).close()  # the log is in the file now
    base = sqlite3.connect(journal_of(left), isolation_level=None)
    base.execute("PRAGMA synchronous=OFF")
    value = base.execute(f"SELECT {column} FROM steps WHERE number = 5").fetchone()[0]
    for damaged in flipped_values(value):
        new = "CAST(? AS TEXT)" if isinstance(damaged, bytes) else "?"
        base.execute(f"UPDATE steps SET {column} = {new} WHERE number = 5", (damaged,))
        steps, problem = recovered_steps(left)
        assert (steps, "step 5 is damaged" in problem) == (4, True), damaged
    base.close()
    is_told(left, 4)


@pytest.mark.parametrize("word", [b"Swap 1 and 2", b"adaswap", b"stretches", b"apply"])
@pytest.mark.parametrize("bit", [1, 7])
def test_a_flipped_bit_in_the_text_of_the_last_step_is_told(
    left: Path, word: bytes, bit: int
) -> None:
    Session.open(left).close()  # the log is in the file now
    file = journal_of(left)
    places = [match.start() for match in re.finditer(re.escape(word), file.read_bytes())]
    flip(file, min(places) + 1, bit)  # a page is filled from its end: the last step comes first
    is_told(left, 4)


@pytest.mark.parametrize("columns", [0, 13])
def test_a_damaged_page_costs_the_steps_from_there_on_alone(
    session: Session, tmp_path: Path, columns: int
) -> None:
    edit(session, swaps=29)
    path = crashed(session, tmp_path / "after")
    session.close()
    Session.open(path).close()
    if columns:
        older(path, columns)
    file = journal_of(path)
    data = file.read_bytes()
    page = int.from_bytes(data[16:18], "big")
    last = data.rindex(b"apply") // page * page  # some page of steps that is not the first
    assert last > page
    flip(file, last, 1)  # its kind is none any more
    steps, problem = recovered_steps(path)
    assert 0 < steps < 29
    assert problem
    session = Session.open(path)
    assert session.recovered == steps
    session.close()


def test_a_journal_that_is_damaged_while_the_session_is_open_is_kept_aside(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    edit(session)

    def damaged(*_: object) -> bool:
        raise SessionError("a page is damaged")

    assert session.path is not None
    shutil.copy(journal_of(session.path), session.path.parent / "copy")
    (session.path.parent / "copy").replace(journal_of(session.path))  # so it is opened anew
    monkeypatch.setattr(Journal, "continues", damaged)
    with pytest.raises(SessionError, match="kept aside"):
        edit(session)
    monkeypatch.undo()
    edit(session)
    state = state_of(session)
    session.close()
    again = Session.open(session.path)
    assert state_of(again) == state
    again.close()


def test_a_number_that_jumps_costs_that_step_alone(left: Path) -> None:
    with sqlite3.connect(journal_of(left)) as base:
        base.execute("UPDATE steps SET number = 7 WHERE number = 5")
    base.close()
    is_told(left, 4)


def test_a_step_taken_out_by_hand_is_told(left: Path) -> None:
    with sqlite3.connect(journal_of(left)) as base:
        base.execute("DELETE FROM steps WHERE number = 5")
    base.close()
    is_told(left, 4)


def test_a_count_of_another_save_says_nothing(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=3)
    path = crashed(session, tmp_path / "after")
    count = (companions(path) / "journal.sqlite-count").read_bytes()
    session.save()
    edit(session)
    newer = crashed(session, tmp_path / "newer")
    (companions(newer) / "journal.sqlite-count").write_bytes(count)
    again = Session.open(newer)
    assert again.notes == ("Recovered: 1 edit made after the session was saved last",)
    again.close()


def older(path: Path, columns: int) -> Path:
    """The session, with its journal as an older program makes it: with so many columns."""
    base = sqlite3.connect(journal_of(path))
    rows = [(*row[:-2], "", "") for row in base.execute(SELECT)]  # it keeps no message
    origin = base.execute("SELECT session, save FROM origin").fetchone()
    for row in number_rows(rows, *origin):
        base.execute("UPDATE steps SET checksum = ? WHERE number = ?", (row[-1], row[0]))
    names = [row[1] for row in base.execute("PRAGMA table_info(steps)")]
    for name in reversed(names[columns:]):
        base.execute(f"ALTER TABLE steps DROP COLUMN {name}")
    base.commit()
    base.close()
    (companions(path) / "journal.sqlite-count").unlink()
    return path


@pytest.mark.parametrize("columns", [10, 11, 12, 13])
def test_a_journal_of_an_older_program_is_opened(left: Path, columns: int) -> None:
    session = Session.open(older(left, columns))
    assert session.notes == ("Recovered: 5 edits made after the session was saved last",)
    edit(session)
    session.close()
    again = Session.open(left)
    assert again.recovered == 6
    again.close(discard=True)


def test_the_first_steps_of_a_damaged_journal_are_made_again(tmp_path: Path) -> None:
    session = make_session(tmp_path)
    edit(session, swaps=3)
    state = state_of(session)
    edit(session, swaps=2)
    path = crashed(session, tmp_path / "after")
    session.close()
    with sqlite3.connect(journal_of(path)) as base:
        base.execute("UPDATE steps SET author = 'eve' WHERE number = 4")
    base.close()
    again = Session.open(path)
    assert (again.recovered, state_of(again)) == (3, state)
    assert "step 4 is damaged" in again.notes[-1]
    again.close()
