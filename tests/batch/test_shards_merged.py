"""Shards that end at the same time: none waits for the page of another."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.page_reader import Reader
from tracking.batch import Outcome, Row, Shard, State, batch_folder, merge_shard, output_folder
from tracking.batch.ledger import read_rows
from tracking.batch.report import Reported

REALLY_WRITE = output_folder.write_page


def put(out: Path, shard: Shard, name: str) -> None:
    """A shard's end: it puts one recording into the ledger of the whole."""
    with batch_folder(out, shard) as ledger:
        ledger.put(Row(name, out / name, "", "", "[]", Outcome(State.DONE, people=1)))
        ledger.commit()
        merge_shard(ledger, out)


def test_a_shard_puts_its_own_in_while_another_writes_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found: list[set[str]] = []

    def write(reported: Reported, out: Path) -> Path:
        if not found:
            found.append(set())
            monkeypatch.setattr(output_folder, "_MERGE_S", 0.0)  # the page is taken: no waiting
            put(out, Shard(2, 2), "second")
            found.append({row.name for row in read_rows(out / "batch.sqlite")})
        return REALLY_WRITE(reported, out)

    monkeypatch.setattr(output_folder, "write_page", write)
    put(tmp_path, Shard(1, 2), "first")
    assert found[-1] == {"first", "second"}


def test_the_page_has_what_every_shard_put_in(tmp_path: Path) -> None:
    for number, name in enumerate(("first", "second", "third"), 1):
        put(tmp_path, Shard(number, 3), name)
    page = Reader((tmp_path / "report" / "index.html").read_text()).said
    assert {"first", "second", "third"} <= set(page)
