"""A journal that is replaced is never missed, whenever the program or the power ends."""

from __future__ import annotations

import itertools
import shutil
import sqlite3
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, state_of

from tracking.session import Session, describe
from tracking.session.session_writer import companions

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="open files cannot be moved there")


def journal_of(path: Path) -> Path:
    return companions(path) / "journal.sqlite"


def a_damaged_step(path: Path) -> int:
    """Its log stays beside it, with all that was written."""
    wal = journal_of(path).with_name("journal.sqlite-wal")
    data = bytearray(wal.read_bytes())
    page = int.from_bytes(data[8:12], "big")
    frame = 32 + 3 * (24 + page)  # past the first edits
    data[frame + 2000] ^= 1
    wal.write_bytes(data)
    journal_of(path).with_name("journal.sqlite-shm").unlink(missing_ok=True)
    return 3


def a_step_that_does_not_fit(path: Path) -> int:
    before = journal_of(path).read_bytes()
    assert before
    with sqlite3.connect(journal_of(path)) as base:
        base.execute("UPDATE steps SET author = 'eve' WHERE number = 4")
    base.close()
    return 3


def no_journal_at_all(path: Path) -> int:
    journal_of(path).write_bytes(b"no journal at all" * 400)
    return 0


DAMAGES = [a_damaged_step, a_step_that_does_not_fit, no_journal_at_all]


@pytest.fixture(params=DAMAGES, ids=lambda damage: damage.__name__)
def damaged(request: pytest.FixtureRequest, session: Session, tmp_path: Path) -> tuple[Path, int]:
    """A session beside a journal of five edits that is damaged, and how many are sound."""
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "damaged")
    return path, request.param(path)


@dataclass
class Disk:
    """What happens to the names of a folder while a session opens.

    Attributes:
        groups: the renames between one sync of the folder and the next, each group with a copy of
            what was there before its first one.
        moments: a copy before each rename.
    """

    folder: Path
    copies: Path
    groups: list[tuple[Path, list[tuple[str, str]]]] = field(default_factory=list)
    moments: list[Path] = field(default_factory=list)
    _numbers: Iterator[int] = field(default_factory=itertools.count)

    def copied(self) -> Path:
        copy = self.copies / str(next(self._numbers))
        shutil.copytree(self.folder, copy)
        return copy

    def watch(self, monkeypatch: pytest.MonkeyPatch) -> None:
        rename, own = Path.replace, companions(self.folder / "s.h5")

        def renaming(file: Path, target: Path) -> Path:
            self.moments.append(self.copied())
            if not self.groups or self.groups[-1] is None:
                self.groups.append((self.moments[-1], []))
            self.groups[-1][1].append((file.name, target.name))
            return rename(file, target)

        def synced(folder: Path) -> None:
            if folder == own and self.groups and self.groups[-1] is not None:
                self.groups.append(None)  # type: ignore[arg-type]

        monkeypatch.setattr(Path, "replace", renaming)
        for module in ("store", "journal_files"):
            monkeypatch.setattr(f"tracking.session.{module}.sync_folder", synced)


def opened(path: Path, disk: Disk, monkeypatch: pytest.MonkeyPatch) -> tuple[object, ...]:
    with monkeypatch.context() as watched:
        disk.watch(watched)
        session = Session.open(path)
        state = state_of(session)
    session.close()
    assert len(disk.moments) >= 3
    return state


def is_as_ever(path: Path, sound: int, state: tuple[object, ...], *, tells: bool = True) -> None:
    """The session opens with all sound edits and tells; it goes on, and all of it is kept."""
    told = describe(path)["edits_waiting_in_journal"]
    session = Session.open(path)
    assert (session.read_only, session.recovered, state_of(session)) == (False, sound, state)
    told_of = ["may be missing" in note and "kept aside" in note for note in session.damage]
    assert told_of == [True] * tells
    assert told == sound
    edit(session)
    state = state_of(session)
    session.close()
    again = Session.open(path)
    assert (state_of(again), again.damage) == (state, ())
    again.close(discard=True)
    kept = [file.name for file in companions(path).iterdir()]
    assert not [name for name in kept if "next" in name or "making" in name]
    assert {name for name in kept if name.endswith(".sqlite")} == {"kept-aside-1.sqlite"}


def test_a_program_killed_while_it_replaces_a_journal_loses_nothing(
    damaged: tuple[Path, int], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, sound = damaged
    disk = Disk(path.parent, tmp_path / "copies")
    state = opened(path, disk, monkeypatch)
    for moment in disk.moments:
        is_as_ever(moment / path.name, sound, state)


def test_a_power_cut_while_a_journal_is_replaced_loses_nothing(
    damaged: tuple[Path, int], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, sound = damaged
    disk = Disk(path.parent, tmp_path / "copies")
    state = opened(path, disk, monkeypatch)
    tried = 0
    for before, renames in filter(None, disk.groups):
        for count in range(1, len(renames) + 1):
            for kept in itertools.combinations(renames, count):
                copy = shutil.copytree(before, tmp_path / f"cut-{(tried := tried + 1)}")
                folder = companions(copy / path.name)
                for old, new in kept:
                    (folder / old).replace(folder / new)
                finished = ("journal-next.sqlite", "journal.sqlite") in kept
                is_as_ever(copy / path.name, sound, state, tells=not finished)
    assert tried >= 4


def test_what_a_damaged_log_holds_after_the_damage_is_kept(
    session: Session, tmp_path: Path
) -> None:
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "damaged")
    a_damaged_step(path)
    log = journal_of(path).with_name("journal.sqlite-wal").read_bytes()
    Session.open(path).close()
    assert (companions(path) / "kept-aside-1.sqlite-wal").read_bytes() == log


def test_a_log_without_its_journal_is_kept(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=5)
    for number, lose in enumerate((Path.unlink, lambda file: file.write_bytes(b""))):
        path = crashed(session, tmp_path / f"after-{number}")
        log = journal_of(path).with_name("journal.sqlite-wal").read_bytes()
        lose(journal_of(path))
        again = Session.open(path)
        assert "may be missing" in again.damage[0]
        again.close()
        assert (companions(path) / "kept-aside-1.sqlite-wal").read_bytes() == log


def test_nothing_that_was_kept_aside_is_written_over(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    (companions(path) / "kept-aside-1.sqlite-wal").write_bytes(b"somebody's")
    no_journal_at_all(path)
    Session.open(path).close()
    assert (companions(path) / "kept-aside-1.sqlite-wal").read_bytes() == b"somebody's"
    assert (companions(path) / "kept-aside-2.sqlite").exists()


def test_a_disk_without_room_for_the_new_journal_keeps_the_old_one_and_shows_its_edits(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    edit(session, swaps=5)
    path = crashed(session, tmp_path / "after")
    sound = a_damaged_step(path)

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as at_first:
        at_first.setattr("tracking.session.journal.open_file", full)
        refused = Session.open(path)
    assert (refused.read_only, refused.recovered) == (True, sound)
    assert any("No space left" in note for note in refused.notes)
    assert any("left where it is" in note for note in refused.damage)
    refused.close()
    assert not list(companions(path).glob("kept-aside*"))
    again = Session.open(path)
    assert (again.read_only, again.recovered) == (False, sound)
    again.close()
