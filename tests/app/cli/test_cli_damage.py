"""Commands that read a session say on stderr what of it is damaged or may be missing."""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_rename, plan_swap
from tracking.session import Session
from tracking.session.journal_files import JOURNAL
from tracking.session.session_writer import companions

DAMAGED = "its checksum does not hold"
MISSING = "edits made after the session was saved last may be missing"
ROWS = "1,1,1,1,5,5,1,-1,-1,-1\n"
LABELS = "frame,track,part,on,left,top,width,height\n1,1,head,1,1,2,9,9\n"


def flip(session: Path, text: bytes = b"red coat") -> None:
    """One flipped bit in a text of the session."""
    data = bytearray(session.read_bytes())
    data[data.rindex(text)] ^= 1
    session.write_bytes(data)


@pytest.fixture(autouse=True)
def files(tmp_path: Path) -> None:
    """What is imported."""
    (tmp_path / "rows.txt").write_text(ROWS)
    (tmp_path / "labels.csv").write_text(LABELS)


@pytest.fixture
def named(session: Path) -> Path:
    """A session in which a track has a name."""
    with closing(Session.open(session)) as opened:
        track = opened.tracks.track_ids[0]
        opened.apply(plan_rename(opened.tracks, opened.labels, track, "red coat"))
        opened.save()
    return session


@pytest.fixture
def damaged(named: Path) -> Path:
    """A session with one flipped bit in the name of a track."""
    flip(named)
    return named


@pytest.fixture
def of_lost_edits(named: Path, tmp_path: Path) -> Path:
    """A session whose journal has lost the log with all of its three edits."""
    with closing(Session.open(named)) as opened:
        first, second = opened.tracks.track_ids[:2]
        for frame in range(10, 13):
            opened.apply(plan_swap(opened.tracks, first, second, frame))
        left = tmp_path / "left" / named.name  # as a program leaves it that dies
        left.parent.mkdir()
        shutil.copy(named, left)
        shutil.copytree(companions(named), companions(left))
    (companions(left) / "lock").unlink()
    log = companions(left) / f"{JOURNAL}-wal"
    log.write_bytes(log.read_bytes()[: 32 + 24])
    return left


def reading(session: Path, footage: Path, out: Path) -> dict[str, tuple[str | Path, ...]]:
    """Every command that reads a session, and how it is asked to."""
    rows, labels = out / "rows.txt", out / "labels.csv"
    return {
        "info": ("info", session),
        "info --json": ("info", session, "--json"),
        "log": ("log", session),
        "log --csv": ("log", session, "--csv", out / "log.csv"),
        "log --json": ("log", session, "--json"),
        "review": ("review", session),
        "count": ("count", session, "--line", "door:0,0:1,1"),
        "compare": ("compare", session, session),
        "score": ("score", session, "--truth", footage),
        "score --truth": ("score", footage / "truth.txt", "--truth", session),
        "train": ("train", session, "-o", out / "d.h5"),
        "export": ("export", session, "-o", out / "out.txt", "--format", "mot"),
        "track --again": ("track", "--again", session, "--from", "70", "--until", "72"),
        "track -o": ("track", footage, "-o", session, "--frames", "0:2"),
        "import -o": ("import", rows, "-r", footage, "-o", session),
        "import --into": ("import", rows, "--into", session),
        "import-labels": ("import-labels", labels, session),
        "restore": ("restore", session),
    }


NAMES = tuple(reading(Path(), Path(), Path()))


@pytest.mark.parametrize("command", NAMES)
def test_damage_of_the_file_is_told_once_by_every_command(
    trackwright: Trackwright, damaged: Path, footage: Path, tmp_path: Path, command: str
) -> None:
    words = reading(damaged, footage, tmp_path)[command]
    _, printed, told = trackwright(*words)
    assert told.count(DAMAGED) == 1, told
    assert next(line for line in told.splitlines() if DAMAGED in line).startswith("note: ")
    assert DAMAGED not in printed or command == "info --json"


@pytest.mark.parametrize("command", NAMES)
def test_edits_that_the_journal_lost_are_told_once_by_every_command(
    trackwright: Trackwright, of_lost_edits: Path, footage: Path, tmp_path: Path, command: str
) -> None:
    words = reading(of_lost_edits, footage, tmp_path)[command]
    told = trackwright(*words)[2]
    assert told.count(MISSING) == 1, told
    assert "0 of 3 steps are left" in told


def test_what_is_damaged_is_a_fact_of_info(trackwright: Trackwright, damaged: Path) -> None:
    (note,) = json.loads(trackwright("info", damaged, "--json")[1])["damage"]
    assert DAMAGED in note


def test_a_command_that_only_reads_leaves_a_damaged_journal_to_be_told_again(
    trackwright: Trackwright, of_lost_edits: Path
) -> None:
    def files() -> dict[str, bytes]:
        return {file.name: file.read_bytes() for file in companions(of_lost_edits).iterdir()}

    before = files()
    for _ in range(2):
        assert MISSING in trackwright("review", of_lost_edits)[2]
    assert files() == before


def test_a_sound_session_has_no_notes(
    trackwright: Trackwright, named: Path, footage: Path, tmp_path: Path
) -> None:
    for command in ("info", "log", "review", "count", "export", "import-labels"):
        told = trackwright(*reading(named, footage, tmp_path)[command])[2]
        assert not [line for line in told.splitlines() if named.name in line and "note" in line]
        assert DAMAGED not in told
        assert MISSING not in told


def test_edits_that_another_program_is_making_are_read_and_never_told_as_damage(
    trackwright: Trackwright, named: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the copies of a journal's files another program writes a step, and saves."""
    from tracking.session import pending_edits

    with closing(Session.open(named)) as other:
        first, second = other.tracks.track_ids[:2]
        steps: list[Callable[[], object]] = [
            lambda: other.apply(plan_swap(other.tracks, first, second, 20)),
            other.save,
        ]
        other.apply(plan_swap(other.tracks, first, second, 10))
        copy = pending_edits._copy

        def copy_slowly(main: Path, place: Path, ending: str, most_bytes: int) -> None:
            copy(main, place, ending, most_bytes)
            if steps:
                steps.pop(0)()

        monkeypatch.setattr(pending_edits, "_copy", copy_slowly)
        _, printed, told = trackwright("log", named)
    assert "missing" not in told
    assert len(printed.splitlines()) == 3


def test_damage_is_told_after_a_save_until_it_is_accepted(
    trackwright: Trackwright, damaged: Path, tmp_path: Path
) -> None:
    assert trackwright("import", tmp_path / "rows.txt", "--into", damaged)[0] == 0
    told = trackwright("review", damaged)[2]
    assert told.count("was found damaged on") == 1
    status, out, told = trackwright("restore", damaged, "--accept-damage")
    assert (status, out.strip()) == (0, str(damaged))
    status, out, told = trackwright("review", damaged)
    assert (status, "damaged" in told) == (0, False)
    status, out, told = trackwright("restore", damaged, "--accept-damage", "--json")
    assert (status, json.loads(out)["accepted"]) == (0, 0)
    assert "no damage of it is known" in told
    assert trackwright("restore", damaged, "--accept-damage", "--list")[0] == 2


def test_a_session_whose_only_edits_wait_in_a_damaged_journal_is_not_tracked_over(
    trackwright: Trackwright, session: Path, footage: Path
) -> None:
    with closing(Session.open(session)) as opened:
        first, second = opened.tracks.track_ids[:2]
        opened.apply(plan_swap(opened.tracks, first, second, 10))
    with closing(sqlite3.connect(companions(session) / JOURNAL)) as journal, journal:
        journal.execute("UPDATE steps SET text = 'x'")
    before = session.read_bytes()
    status, _, said = trackwright("track", footage, "-o", session, "--frames", "0:2")
    assert (status, session.read_bytes()) == (1, before)
    assert "what somebody may have done in it (it is damaged) would be lost" in said
