"""`log` and `restore`."""

from __future__ import annotations

import errno
import json
import os
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_rename, plan_swap
from tracking.session import Session


@pytest.fixture
def edited(session: Path) -> Path:
    """Saved after each of two edits; a third waits in the journal."""
    with closing(Session.open(session, author="ada")) as opened:
        a, b = opened.tracks.track_ids[:2]
        frame = opened.tracks.frame_range(a)[0]
        opened.apply(plan_swap(opened.tracks, a, b, frame))
        opened.save()
        opened.apply(plan_rename(opened.tracks, opened.labels, a, "red\x1bcoat"))
        opened.save()
        opened.undo_alone(1)
    return session


def test_log_prints_a_line_an_edit(trackwright: Trackwright, edited: Path) -> None:
    status, printed, _ = trackwright("log", edited)
    lines = printed.splitlines()
    assert (status, len(lines)) == (0, 3)
    assert "ada" in lines[0]
    assert "Swap" in lines[0]
    assert lines[0].endswith("(undone by 3)")
    assert "red\\x1bcoat" in lines[1]
    assert "Undo edit 1 alone" in lines[2]


def test_log_prints_one_json_document(trackwright: Trackwright, edited: Path) -> None:
    log = json.loads(trackwright("log", edited, "--json")[1])
    assert [entry["kind"] for entry in log] == ["swap", "rename", "undo"]
    assert log[1]["after"]["labels"]


def test_log_writes_csv(trackwright: Trackwright, edited: Path, tmp_path: Path) -> None:
    out = tmp_path / "log.csv"
    status, printed, _ = trackwright("log", edited, "--csv", out, "--json")
    assert (status, json.loads(printed)) == (0, {"written": str(out), "edits": 3})
    assert len(out.read_text(encoding="utf-8").splitlines()) == 4


def test_log_does_not_write_over_a_session(trackwright: Trackwright, edited: Path) -> None:
    before = edited.read_bytes()
    status, _, said = trackwright("log", edited, "--csv", edited)
    assert (status, len(said.splitlines())) == (1, 1)
    assert edited.read_bytes() == before


def test_restore_lists_what_is_kept(trackwright: Trackwright, edited: Path) -> None:
    listed = json.loads(trackwright("restore", edited, "--list", "--json")[1])
    assert [(kept["backup"], kept["edits"]) for kept in listed] == [(1, 1), (2, 0)]
    printed = trackwright("restore", edited, "--list")[1]
    assert printed.splitlines()[0].startswith("1  saved 20")
    assert "1 edits" not in printed


def test_restore_puts_an_older_one_in_place(trackwright: Trackwright, edited: Path) -> None:
    status, printed, _ = trackwright("restore", edited, "--backup", "2", "--json")
    assert (status, json.loads(printed)["edits"]) == (0, 0)
    with closing(Session.open(edited)) as session:
        assert len(session.history) == 0
        assert [kept.edits for kept in session.list_backups()] == [3, 2, 1, 0]


def test_restore_tells_what_is_wrong(
    trackwright: Trackwright, edited: Path, tmp_path: Path
) -> None:
    with closing(Session.open(edited)):
        status, _, said = trackwright("restore", edited)
        assert (status, len(said.splitlines())) == (1, 1)
        assert "open in process" in said
        status, _, said = trackwright("restore", edited, "--generation", "9")
        assert (status, len(said.splitlines())) == (1, 1)
        assert "no backup 9" in said
    status, _, said = trackwright("restore", edited, "--generation", "9")
    assert (status, "no backup 9" in said) == (1, True)
    status, _, said = trackwright("restore", tmp_path / "none.h5", "--list")
    assert (status, "no such session" in said) == (1, True)


def test_restore_has_an_older_one_back_where_the_session_is_damaged_and_keeps_that(
    trackwright: Trackwright, edited: Path
) -> None:
    damaged = edited.read_bytes()[:5000]
    edited.write_bytes(damaged)
    status, _, said = trackwright("info", edited)
    assert (status, "trackwright restore" in said) == (1, True)
    status, printed, said = trackwright("restore", edited, "--json")
    assert (status, json.loads(printed)["edits"]) == (0, 1)
    kept = edited.parent / f".{edited.name}.trackwright" / "damaged-1.h5"
    assert str(kept) in said
    assert kept.read_bytes() == damaged
    with closing(Session.open(edited)) as session:
        assert (len(session.history), session.read_only) == (1, False)


def test_a_damaged_session_with_nothing_older_ends_in_what_to_do(
    trackwright: Trackwright, session: Path
) -> None:
    session.write_bytes(session.read_bytes()[:5000])
    status, _, said = trackwright("restore", session)
    assert (status, said.count("\n")) == (1, 1)
    assert "track the recording again" in said


@pytest.mark.parametrize(
    "words",
    [("log",), ("export", "-o", "out.txt", "--format", "mot"), ("count", "--line", "door:0,0:1,1")],
)
def test_edits_that_cannot_be_copied_to_a_full_temporary_folder_are_not_left_out(
    trackwright: Trackwright,
    edited: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("tracking.session.pending_edits.shutil.copyfileobj", full)
    status, printed, said = trackwright(words[0], edited, *words[1:])
    assert (status, printed, len(said.splitlines())) == (1, "", 1)
    assert "edits that wait in its journal cannot be read (No space left on device)" in said
    assert not (tmp_path / "out.txt").exists()
