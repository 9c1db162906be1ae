"""A journal made to harm takes no time, no memory and no room: neither looked at nor opened."""

from __future__ import annotations

import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit

from tracking.editing import plan_delete
from tracking.errors import OutputError, SessionError
from tracking.session import Session, describe, pending_edits
from tracking.session.journal import Journal
from tracking.session.journal_limits import TimeLimit
from tracking.session.journal_schema import SELECT
from tracking.session.session_writer import companions

MIB = 1 << 20
ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT max(i) FROM n"


def journal_of(path: Path, ending: str = "") -> Path:
    return companions(path) / f"journal.sqlite{ending}"


@pytest.fixture
def left(session: Session, tmp_path: Path) -> Path:
    """A session beside a journal of five edits that its program left, all of them in its log."""
    edit(session, swaps=5)
    return crashed(session, tmp_path / "after")


@pytest.fixture
def emptied(left: Path) -> Path:
    """The same with all edits in the main file."""
    Session.open(left).close()
    assert not journal_of(left, "-wal").exists()
    return left


def beside(path: Path) -> dict[str, tuple[int, int]]:
    states = {file.name: file.stat() for file in companions(path).iterdir()}
    return {name: (state.st_size, state.st_mtime_ns) for name, state in states.items()}


@pytest.fixture
def copied(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The endings of the files that are copied from now on."""
    copy, endings = pending_edits._copy, list[str]()

    def copying(main: Path, target: Path, ending: str, most_bytes: int) -> None:
        copy(main, target, ending, most_bytes)
        if os.path.lexists(f"{target}{ending}"):
            endings.append(ending)

    monkeypatch.setattr(pending_edits, "_copy", copying)
    return endings


def a_large_one(path: Path) -> None:
    """Of the size that no journal exceeds, in a file that takes no room."""
    os.truncate(journal_of(path), 800 * MIB)


def a_large_log(path: Path) -> None:
    journal_of(path, "-wal").touch()
    os.truncate(journal_of(path, "-wal"), 800 * MIB)


def one_of_holes(path: Path) -> None:
    os.truncate(journal_of(path), 200 * MIB)


def junk(path: Path) -> None:
    journal_of(path).write_bytes(b"no journal at all" * 4000)


def other_tables(path: Path) -> None:
    base = sqlite3.connect(journal_of(path))
    base.execute("PRAGMA journal_mode=DELETE")
    base.execute("CREATE VIEW more AS SELECT 1")
    base.close()


@pytest.mark.parametrize("make", [a_large_one, a_large_log, one_of_holes, junk, other_tables])
def test_what_is_no_journal_by_its_beginning_or_size_is_not_copied(
    emptied: Path, copied: list[str], make: object
) -> None:
    assert callable(make)
    make(emptied)
    before = beside(emptied)
    told = describe(emptied)
    assert told["edits_waiting_in_journal"] == 0
    assert copied == []
    assert beside(emptied) == before


def test_a_log_that_is_none_is_not_copied(left: Path, copied: list[str]) -> None:
    journal_of(left, "-wal").write_bytes(b"no log at all" * 99)
    assert describe(left)["edits_waiting_in_journal"] == 0
    assert set(copied) == {"-count", ""}


def test_a_journal_whose_log_was_emptied_halfway_is_read_with_the_log(
    session: Session, tmp_path: Path
) -> None:
    edit(session, swaps=30)
    left = crashed(session, tmp_path / "after")
    log, file = journal_of(left, "-wal").read_bytes(), journal_of(left)
    page = int.from_bytes(log[8:12], "big")
    frames = [log[at : at + 24 + page] for at in range(32, len(log), 24 + page)]
    first = [frame for frame in frames if int.from_bytes(frame[:4], "big") == 1]
    whole = file.read_bytes()  # the first page says how many there are; the new ones lack still
    file.write_bytes(first[-1][24:] + whole[page:])
    base = sqlite3.connect(f"{file.as_uri()}?mode=ro&immutable=1", uri=True)
    with pytest.raises(sqlite3.DatabaseError, match="malformed"):
        base.execute("SELECT count(*) FROM steps").fetchone()
    base.close()
    told = describe(left)
    assert (told["edits_waiting_in_journal"], told["damage"]) == (30, [])


def test_a_count_of_more_than_a_line_is_not_copied(left: Path, copied: list[str]) -> None:
    journal_of(left, "-count").write_bytes(b"9" * 5000)
    assert describe(left)["edits_waiting_in_journal"] == 5
    assert set(copied) == {"-wal", ""}


def test_a_sound_journal_is_copied_with_its_log(left: Path, copied: list[str]) -> None:
    before = beside(left)
    assert describe(left)["edits_waiting_in_journal"] == 5
    assert set(copied) == {"-count", "-wal", ""}
    assert beside(left) == before


@pytest.fixture
def no_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever ends, ends by itself."""
    monkeypatch.setattr("tracking.session.journal_limits.PROCESSOR_S", 1e9)
    monkeypatch.setattr("tracking.session.journal_limits.DISK_S", 1e9)


def opens_told(path: Path, recovered: int) -> None:
    session = Session.open(path)
    assert (session.read_only, session.recovered) == (False, recovered)
    assert "may be missing" in session.damage[0]
    session.close()


def root_of_steps(path: Path) -> tuple[int, int]:
    """The number of the first page of steps, and the size of a page."""
    base = sqlite3.connect(journal_of(path))
    root = base.execute("SELECT rootpage FROM sqlite_schema WHERE name = 'steps'").fetchone()[0]
    size = base.execute("PRAGMA page_size").fetchone()[0]
    base.close()
    return int(root), int(size)


def test_pages_that_lead_to_the_same_steps_endlessly_are_read_once(
    emptied: Path, no_clock: None
) -> None:
    root, size = root_of_steps(emptied)
    data = bytearray(journal_of(emptied).read_bytes())
    first = (root - 1) * size
    leaf, levels, children = data[first : first + size], 8, 300
    assert leaf[0] == 13  # the five steps are on one page
    count = len(data) // size
    for level in range(levels):  # of each, all children are the next level's page
        child = count + 2 + level
        cells = [child.to_bytes(4, "big") + b"\x05" for _ in range(children)]
        begin = size - 5 * children
        page = bytearray(size)
        page[0:12] = (
            b"\x05\0\0" + children.to_bytes(2, "big") + begin.to_bytes(2, "big") + b"\0"
        ) + child.to_bytes(4, "big")
        for number in range(children):
            page[12 + 2 * number : 14 + 2 * number] = (begin + 5 * number).to_bytes(2, "big")
        page[begin:] = b"".join(cells)
        if level == 0:
            data[first : first + size] = page
            data += bytes(size)  # the second level comes after it
        else:
            data[(count + level) * size :] = page
            data += bytes(size)
    data[(count + levels) * size :] = leaf
    data[28:32] = (len(data) // size).to_bytes(4, "big")
    journal_of(emptied).write_bytes(data)
    opens_told(emptied, 5)


def test_a_chain_of_pages_that_leads_to_itself_ends(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    Session.open(path).close()
    with sqlite3.connect(journal_of(path)) as base:
        base.execute("UPDATE steps SET after = ? WHERE number = 5", ("loop" * 100_000,))
    base.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    base.close()
    _, size = root_of_steps(path)
    data = bytearray(journal_of(path).read_bytes())
    numbers = [
        n
        for n in range(len(data) // size)
        if data[n * size + 4 : (n + 1) * size].count(b"loop") > 900
    ]
    page = numbers[0]
    data[page * size : page * size + 4] = (page + 1).to_bytes(4, "big")
    journal_of(path).write_bytes(data)
    opens_told(path, 4)


@pytest.fixture
def no_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every statement has taken too long when SQLite looks at the clock first, which is at once."""
    monkeypatch.setattr("tracking.session.journal_limits.PROCESSOR_S", -1.0)
    monkeypatch.setattr("tracking.session.journal_limits._OPS_A_CALL", 1)


@pytest.mark.parametrize("damaged", [True, False])
def test_what_never_ends_is_given_up(monkeypatch: pytest.MonkeyPatch, damaged: bool) -> None:
    monkeypatch.setattr("tracking.session.journal_limits.PROCESSOR_S", 0.05)
    base = sqlite3.connect(":memory:")
    error = sqlite3.OperationalError if damaged else TimeoutError
    with pytest.raises(error), TimeLimit().enforce(base, damaged=damaged):
        base.execute(ENDLESS)
    base.execute("SELECT 1")  # and the limit is gone
    base.close()


def test_a_step_is_written_only_where_the_last_one_is_found_in_time(
    session: Session, request: pytest.FixtureRequest
) -> None:
    edit(session)
    request.getfixturevalue("no_time")
    with pytest.raises(OutputError, match="takes too long"):
        edit(session)


def test_starting_over_and_taking_a_step_out_end_in_time(
    emptied: Path, request: pytest.FixtureRequest
) -> None:
    journal, other = Journal(journal_of(emptied)), Journal(journal_of(emptied))
    assert journal.origin is not None
    row = other._base.execute(f"{SELECT} WHERE number = 5").fetchone()
    other._last, other._checksums, other._failed = 4, other._checksums[:4], (5, row[-1])
    request.getfixturevalue("no_time")
    with pytest.raises(OutputError, match="takes too long"):
        journal.start_over(journal.origin[0], "another save", 2)
    with pytest.raises(OutputError, match="takes too long"):
        journal.continues(other)
    journal.close()
    other.close()


MEASURE = """
import re, sys
from pathlib import Path
from tracking.session.journal import Journal

def greatest_kib():  # what getrusage says counts the program that began this one, too
    return int(re.search("VmHWM:[^0-9]*([0-9]+)", Path("/proc/self/status").read_text())[1])

before = greatest_kib()
contents = Journal(Path(sys.argv[1])).contents()
print(len(contents.steps), greatest_kib() - before)
print(contents.problem)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="memory is told otherwise elsewhere")
def test_a_large_step_that_nobody_wrote_is_not_held_in_memory(emptied: Path) -> None:
    base = sqlite3.connect(journal_of(emptied), isolation_level=None)
    base.execute("PRAGMA synchronous=OFF")
    base.execute("UPDATE steps SET after = hex(zeroblob(40000000)) WHERE number = 4")
    base.close()
    done = subprocess.run(
        [sys.executable, "-c", MEASURE, journal_of(emptied)],
        capture_output=True,
        text=True,
        check=True,
    )
    numbers, problem = done.stdout.splitlines()
    steps, grown_kib = map(int, numbers.split())
    assert steps == 3
    assert "step 4 is damaged: it is not what its checksum says" in problem
    assert grown_kib < 60 * 1024


def test_the_last_sound_step_before_one_that_is_too_large_is_recovered(emptied: Path) -> None:
    base = sqlite3.connect(journal_of(emptied), isolation_level=None)
    base.execute("UPDATE steps SET checksum = hex(zeroblob(1000000)) WHERE number = 5")
    base.close()
    opens_told(emptied, 4)


@pytest.fixture
def large(session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A session beside a journal of three edits, the second of which counts as large."""
    edit(session)
    session.apply(plan_delete(session.tracks, 3))
    edit(session)
    monkeypatch.setattr("tracking.session.journal.SMALL_CELL", 200)
    return crashed(session, tmp_path / "after")


def test_a_large_step_is_looked_at_for_a_time_only(
    large: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    journal = Journal(journal_of(large))
    monkeypatch.setattr("tracking.session.journal_limits._OPS_A_CALL", 1 << 20)
    monkeypatch.setattr("tracking.session.journal_limits.PROCESSOR_S", -1.0)
    with pytest.raises(OutputError, match="takes too long"):
        journal.contents()
    journal.close()


def test_a_large_step_that_was_written_is_read(large: Path) -> None:
    opened = Session.open(large)
    assert (opened.recovered, opened.damage) == (3, ())
    opened.close()


def test_a_large_step_that_was_not_written_so_is_told(large: Path) -> None:
    with sqlite3.connect(journal_of(large)) as base:
        base.execute("UPDATE steps SET before = before || ' ' WHERE number = 2")
    base.close()
    opens_told(large, 1)


def test_a_session_error_names_the_journal_and_not_its_copy(left: Path) -> None:
    with sqlite3.connect(journal_of(left)) as base:
        base.execute("INSERT INTO origin VALUES ('a', 'b')")
    base.close()
    with pytest.raises(SessionError) as told, pending_edits._copied(journal_of(left)):
        pass
    assert str(told.value).startswith(f"{journal_of(left)}: ")


def test_edits_that_a_slow_disk_does_not_give_in_time_are_not_left_out(
    emptied: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracking.session.journal_limits.DISK_S", -1.0)
    with pytest.raises(OutputError, match="takes too long"):
        Session.look_into(emptied)
