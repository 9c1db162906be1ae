"""Backups are listed and restored without loss."""

from __future__ import annotations

import errno
import os
import shutil
from contextlib import closing
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import make_run, state_of

from tracking.editing import plan_rename, plan_swap
from tracking.errors import OutputError, SessionError
from tracking.session import Session, find_backups, list_backups
from tracking.session.session_writer import companions


@pytest.fixture
def states(session: Session) -> list[tuple[object, ...]]:
    """The session after each of seven saves; the last is the present one."""
    states = [state_of(session)]
    for frame in range(6):
        session.apply(plan_swap(session.tracks, 1, 2, 10 + frame))
        session.save()
        states.append(state_of(session))
    return states


def reopened(session: Session) -> Session:
    path = session.path
    session.close()
    assert path is not None
    return Session.open(path)


def test_backups_are_listed_with_what_they_hold(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    session.undo()
    session.save()
    listed = session.list_backups()
    assert [kept.number for kept in listed] == [1, 2, 3, 4, 5]
    assert [kept.edits for kept in listed] == [6, 5, 4, 3, 2]
    assert [kept.saved for kept in listed] == sorted((kept.saved for kept in listed), reverse=True)
    assert {kept.tracks for kept in listed} == {4}
    assert all(kept.size_bytes == kept.path.stat().st_size for kept in listed)
    assert not any(kept.problem for kept in listed)


def test_tracks_of_a_backup_that_does_not_say_are_counted(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    with h5py.File(session.list_backups()[1].path, "a") as file:
        del file["tracks"].attrs["count"]
        file["tracks/track"][...] = np.arange(len(file["tracks/track"])) % 3 + 1
    assert [kept.tracks for kept in session.list_backups()] == [4, 3, 4, 4, 4]


def test_a_damaged_backup_is_listed_with_its_problem(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    damaged = session.list_backups()[2].path
    damaged.unlink()
    damaged.write_bytes(b"\x89HDF\r\n\x1a\nnothing")
    listed = session.list_backups()
    assert [bool(kept.problem) for kept in listed] == [False, False, True, False, False]
    assert str(damaged) in listed[2].problem
    present = state_of(session)
    with pytest.raises(SessionError):
        session.restore(3)
    assert state_of(session) == present
    session.apply(plan_swap(session.tracks, 1, 2, 3))


@pytest.mark.parametrize("number", [1, 3, 5])
def test_a_backup_is_restored_and_the_present_becomes_one(
    session: Session, states: list[tuple[object, ...]], number: int
) -> None:
    restored = session.restore(number)
    assert state_of(restored) == states[-1 - number]
    assert not restored.dirty
    assert session.read_only
    assert len(restored.list_backups()) == 6
    assert [state_of_file(file) for file in find_backups(restored.path)] == states[-1:-7:-1]
    again = reopened(restored)
    assert (again.recovered, state_of(again)) == (0, states[-1 - number])
    again.close()


def state_of_file(path: Path) -> tuple[object, ...]:
    with closing(Session.open(path)) as session:
        return state_of(session)


def test_edits_that_were_not_saved_are_in_the_newest_backup(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    unsaved = state_of(session)
    restored = session.restore(5)
    assert state_of(restored) == states[1]
    kept = [state_of_file(file) for file in find_backups(restored.path)]
    assert kept == [unsaved, *states[-1:-7:-1]]
    restored.close()


def test_a_restored_session_is_edited_undone_and_saved_as_any_other(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    restored = session.restore(2)
    restored.undo()
    restored.apply(plan_rename(restored.tracks, restored.labels, 1, "red coat"))
    after = state_of(restored)
    again = reopened(restored)
    assert (again.recovered, state_of(again)) == (2, after)
    again.save()
    assert len(again.list_backups()) == 5
    back = again.restore(2)
    assert state_of(back) == states[-1]
    back.close()


def test_runs_of_a_restored_backup_are_its_own(session: Session) -> None:
    session.add_run(make_run(seed=7))
    session.save()
    restored = session.restore(1)
    assert len(restored.runs) == 1
    again = reopened(restored.restore(1))
    assert [run.seed for run in again.runs] == [0, 7]
    again.runs[1].particles.of_frame(3)
    again.close()


def test_a_backup_that_is_not_there_is_told(session: Session) -> None:
    with pytest.raises(SessionError, match=r"no backup 1 \(none is kept yet"):
        session.restore(1)
    session.save()
    with pytest.raises(SessionError, match=r"no backup 2 \(there are 1, 1 is the newest"):
        session.restore(2)


def test_what_another_program_has_open_is_not_restored(
    session: Session, states: list[tuple[object, ...]]
) -> None:
    assert session.path is not None
    before = session.path.read_bytes()
    second = Session.open(session.path)
    with pytest.raises(SessionError, match="reading only"):
        second.restore(1)
    second.close()
    assert session.path.read_bytes() == before


def test_a_session_that_was_never_saved_has_nothing_older(session: Session) -> None:
    fresh = Session.create(session_recording(session))
    assert fresh.list_backups() == ()
    with pytest.raises(SessionError, match="never saved"):
        fresh.restore(1)


def session_recording(session: Session) -> object:
    from made_up_sessions import OneFile

    assert session.path is not None
    return OneFile(session.path.parent / "recording")


def test_a_full_disk_leaves_the_present_and_every_backup(
    session: Session, states: list[tuple[object, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    assert session.path is not None
    before = session.path.read_bytes(), [file.read_bytes() for file in find_backups(session.path)]
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OutputError, match="no space"):
        session.restore(4)
    monkeypatch.undo()
    assert session.path.read_bytes() == before[0]
    assert [file.read_bytes() for file in find_backups(session.path)] == before[1]
    assert state_of(session) == states[-1]
    restored = session.restore(4)
    assert state_of(restored) == states[-5]
    restored.close()


@pytest.mark.parametrize("step", ["before", "after"])
def test_a_crash_while_restoring_leaves_the_old_or_the_restored_one(
    session: Session,
    states: list[tuple[object, ...]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    step: str,
) -> None:
    after = tmp_path / "after"

    def crash(new: Path, path: Path) -> None:
        if step == "after":
            new.replace(path)
        after.mkdir()
        shutil.copy(path, after)
        shutil.copytree(companions(path), after / companions(path).name)
        raise OSError(errno.EIO, "the power went")

    monkeypatch.setattr("tracking.session.session_writer._replace", crash)
    with pytest.raises(OutputError):
        session.restore(4)
    monkeypatch.undo()
    again = Session.open(after / "s.h5")
    assert not again.read_only
    assert state_of(again) == (states[-1] if step == "before" else states[-5])
    kept = [state_of_file(file) for file in find_backups(again.path)]
    assert all(state in [*kept, state_of(again)] for state in states[1:])
    again.close()


def flip(file: Path, text: bytes) -> None:
    """One flipped bit in a text of a session file."""
    data = bytearray(file.read_bytes())
    data[data.rindex(text)] ^= 1
    file.write_bytes(data)


@pytest.fixture
def of_damaged_backup(session: Session) -> Path:
    """A session whose newest backup has a flipped bit in a name; the others are sound."""
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    session.save()
    for frame in (10, 11):
        session.apply(plan_swap(session.tracks, 1, 2, frame))
        session.save()
    session.close()
    assert session.path is not None
    flip(find_backups(session.path)[0], b"red coat")
    return session.path


def test_damage_of_a_backup_is_told_before_it_is_restored(of_damaged_backup: Path) -> None:
    listed = list_backups(of_damaged_backup)
    assert ["checksum does not hold" in kept.damage for kept in listed] == [True, False, False]
    assert not any(kept.problem for kept in listed)


def test_damage_of_a_backup_is_told_when_it_is_restored(
    of_damaged_backup: Path, caplog: pytest.LogCaptureFixture
) -> None:
    backup = find_backups(of_damaged_backup)[0]
    with closing(Session.open(of_damaged_backup)) as session:
        assert session.damage == ()
        with closing(session.restore(1)) as restored:
            assert [str(backup) in note for note in restored.damage] == [True]
    assert f"{backup} is damaged" in caplog.text
    with closing(Session.open(of_damaged_backup)) as session, closing(session.restore(3)) as older:
        assert older.damage == ()


@pytest.mark.skipif(not hasattr(os, "link"), reason="a disk with second names")
def test_a_backup_with_two_names_is_restored_and_never_written(
    session: Session, states: list[tuple[object, ...]], tmp_path: Path
) -> None:
    """As in a copy of the folder by hard links."""
    second = tmp_path / "copy-of-last-night.h5"
    second.hardlink_to(find_backups(session.path or Path())[1])
    before = second.read_bytes()
    assert not any(kept.problem for kept in session.list_backups())
    with closing(session.restore(2)) as restored:
        assert state_of(restored) == states[-3]
        restored.apply(plan_swap(restored.tracks, 1, 2, 20))
        for _ in range(7):
            restored.save()
    assert second.read_bytes() == before


def test_a_backup_that_goes_while_it_is_restored_is_told(
    session: Session, states: list[tuple[object, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracking.session.document.find_backups", lambda _: ())
    with pytest.raises(SessionError, match="backup 2 was deleted"):
        session.restore(2)
    assert state_of(session) == states[-1]
