"""The ledger: what is committed is there, and what is none is refused."""

from __future__ import annotations

import json
import os
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.batch import Cause, Ledger, Outcome, Row, State, read_rows
from tracking.batch.outcome import failure
from tracking.errors import OutputError
from tracking.translation import count_msg, msg

FULL = Outcome(
    State.DONE,
    why=msg("{n} of {name}", n=3, name="a"),
    tracked=True,
    fingerprint="f",
    outside=("/x/y",),
    session_state=(1, 2, 3),
    notes=(msg("a note"), count_msg(2, "{n} frame", "{n} frames")),
    score={"IDF1": 0.5, "position_error_m": {"mean": None}},
    exports={"mot": ("export/mot/a.txt",)},
    export_problems={"csv": msg("why not")},
    review_rows=0.25,
)


def row(name: str, outcome: Outcome = FULL) -> Row:
    return Row(name, Path("/r") / name, "asked", "seen", "[null]", outcome)


def test_an_outcome_comes_back_as_it_was() -> None:
    assert Outcome.from_text(FULL.as_text()) == FULL


@pytest.mark.parametrize("text", ["", "{}", "[]", "null", '{"state": 3}', "[" * 100_000])
def test_a_damaged_outcome_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r".*"):
        Outcome.from_text(text)


@given(
    st.recursive(
        st.none() | st.floats() | st.text(), lambda x: st.lists(x) | st.dictionaries(st.text(), x)
    )
)
def test_any_value_in_the_place_of_another_is_refused_or_read(value: object) -> None:
    data = json.loads(FULL.as_text())
    for name in data:
        try:
            Outcome.from_text(json.dumps({**data, name: value}))
        except ValueError:
            continue


def test_what_is_committed_is_there_and_the_rest_is_not(tmp_path: Path) -> None:
    path = tmp_path / "batch.sqlite"
    with Ledger(path) as ledger:
        ledger.put(row("a"), b"image")
        ledger.commit()
        ledger.put(row("b"))
    assert [each.name for each in read_rows(path)] == ["a"]
    assert [each.name for each in tmp_path.iterdir()] == ["batch.sqlite"]


def test_a_thumbnail_stays_until_there_is_another(tmp_path: Path) -> None:
    with Ledger(tmp_path / "batch.sqlite") as ledger:
        ledger.put(row("a"), b"first")
        ledger.put(row("a"))
        assert ledger.thumbnails(["a", "b"]) == {"a": b"first"}
        ledger.put(row("a"), b"second")
        assert ledger.thumbnails(["a"]) == {"a": b"second"}


def test_ledgers_of_shards_are_taken_over_and_the_later_word_holds(tmp_path: Path) -> None:
    with Ledger(tmp_path / "all") as whole, Ledger(tmp_path / "one") as one:
        one.put(row("a", failure(Cause.INPUT, msg("bad"))))
        one.end_attempt(one.begin_attempt("a", "run", "token", "1"), FULL)
        one.commit()
        for _ in range(2):
            whole.take_over(one)
            whole.commit()
        assert [each.outcome.state for each in whole.rows()] == [State.FAILED]
        assert len(whole.attempts()) == 1
        whole.put(row("a"))
        whole.take_over(one)
        assert [each.outcome.state for each in whole.rows()] == [State.DONE]


def add_a_trigger(base: sqlite3.Connection) -> None:
    base.execute("CREATE TRIGGER bad AFTER INSERT ON recordings BEGIN DELETE FROM about; END")


def make_a_view(base: sqlite3.Connection) -> None:
    base.execute("DROP TABLE attempts")
    base.execute("CREATE VIEW attempts AS SELECT * FROM about")


def say_another_version(base: sqlite3.Connection) -> None:
    base.execute("UPDATE about SET value = '2' WHERE name = 'format_version'")


@pytest.mark.parametrize("change", [add_a_trigger, make_a_view, say_another_version])
def test_what_is_no_ledger_of_this_program_is_refused(tmp_path: Path, change) -> None:
    path = tmp_path / "batch.sqlite"
    Ledger(path).close()
    with closing(sqlite3.connect(path)) as base:
        change(base)
        base.commit()
    with pytest.raises(OutputError):
        Ledger(path)


def test_a_link_is_no_ledger(tmp_path: Path) -> None:
    Ledger(tmp_path / "elsewhere").close()
    (tmp_path / "batch.sqlite").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(Exception, match="link"):
        Ledger(tmp_path / "batch.sqlite")


@pytest.mark.parametrize("name", ["../../victim", "/etc/x", "..", "", "a/b", ".h", "index.html"])
def test_a_name_that_leads_elsewhere_is_damage(tmp_path: Path, name: str) -> None:
    path = tmp_path / "batch.sqlite"
    with Ledger(path) as ledger, Ledger(tmp_path / "whole") as whole:
        ledger.put(row("a"))
        ledger.commit()
        ledger._base.execute("UPDATE recordings SET name = ?", (name,))
        with pytest.raises(OutputError, match="is damaged"):
            whole.take_over(ledger)
    with pytest.raises(OutputError, match="is damaged"):
        read_rows(path)


def test_a_journal_that_would_delete_a_file_is_refused(tmp_path: Path) -> None:
    path, victim = tmp_path / "batch.sqlite", tmp_path / "victim"
    Ledger(path).close()
    victim.write_bytes(b"precious")
    journal = tmp_path / "batch.sqlite-journal"
    journal.write_bytes(_journal_naming(victim, path.read_bytes()))
    with pytest.raises(OutputError, match="of another program"):
        Ledger(path)
    assert victim.exists()


def _journal_naming(victim: Path, base: bytes) -> bytes:
    """A rollback journal of one page that names a super-journal."""
    magic = bytes.fromhex("d9d505f920a163d7")
    pages = len(base) // 4096
    numbers = (1, 0, pages, 512, 4096)
    head = (magic + b"".join(n.to_bytes(4, "big") for n in numbers)).ljust(512, b"\0")
    page = base[:4096]
    check = sum(page[i] for i in range(4096 - 200, 0, -200)) & 0xFFFFFFFF
    record = (1).to_bytes(4, "big") + page + check.to_bytes(4, "big")
    name = os.fsencode(victim)
    lock_page = ((1 << 30) // 4096 + 1).to_bytes(4, "big")
    sums = len(name).to_bytes(4, "big") + sum(name).to_bytes(4, "big")
    return head + record + lock_page + name + sums + magic


@pytest.mark.parametrize("ending", ["-wal", "-shm"])
def test_what_no_ledger_leaves_beside_it_is_refused(tmp_path: Path, ending: str) -> None:
    path = tmp_path / "batch.sqlite"
    Ledger(path).close()
    (tmp_path / f"batch.sqlite{ending}").write_bytes(b"")
    with pytest.raises(OutputError, match="of another program"):
        Ledger(path)


def test_a_transaction_that_was_cut_short_is_taken_back(tmp_path: Path) -> None:
    path, other = tmp_path / "batch.sqlite", tmp_path / "cut" / "batch.sqlite"
    other.parent.mkdir()
    with Ledger(path) as ledger:
        ledger.put(row("a"))
        ledger.commit()
        ledger._base.execute("PRAGMA cache_size = 2")
        for number in range(200):
            ledger.put(row(f"b{number}"), bytes(2000))
        for end in ("", "-journal"):
            shutil.copy(f"{path}{end}", f"{other}{end}")
    assert [each.name for each in read_rows(other)] == ["a"]


def test_a_full_disk_is_told_in_one_line(tmp_path: Path) -> None:
    with Ledger(tmp_path / "batch.sqlite") as ledger:
        ledger._base.execute("PRAGMA max_page_count = 10")
        with pytest.raises(OutputError, match="make room"):
            ledger.put(row("a"), bytes(100_000))
        with pytest.raises(OutputError, match="make room"):
            ledger.begin_attempt("a", "run", "token", "1" * 100_000)
