"""A save that fails leaves the old file byte for byte as it was."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from made_up_sessions import make_recording, make_run, make_session, state_of

from tracking.editing import plan_swap
from tracking.errors import OutputError, SessionError
from tracking.file_lock import SessionLock
from tracking.session import Session, find_backups
from tracking.session.session_writer import companions


def failing(number: int, after_bytes: int) -> object:
    write, written = os.write, 0

    def limited(handle: int, data: memoryview) -> int:
        nonlocal written
        if written + len(data) > after_bytes:
            raise OSError(number, os.strerror(number))
        written += len(data)
        return write(handle, data)

    return limited


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (errno.ENOSPC, "no space is left"),
        (errno.EDQUOT, "share of the disk"),
        (errno.EACCES, "may not write"),
        (errno.EIO, "another place"),
    ],
)
def test_the_old_file_stays_whole_and_the_next_save_works(
    session: Session, monkeypatch: pytest.MonkeyPatch, number: int, said: str
) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    assert session.path is not None
    before = session.path.read_bytes()
    monkeypatch.setattr("tracking.hdf5_image._PIECE", 4096)
    monkeypatch.setattr(os, "write", failing(number, 10_000))
    with pytest.raises(OutputError, match=said) as told:
        session.save()
    assert "\n" not in str(told.value)
    monkeypatch.undo()
    assert session.path.read_bytes() == before
    assert not list(companions(session.path).glob("saving-*"))
    assert session.dirty
    session.save()
    assert not session.dirty


@pytest.mark.parametrize("step", ["fsync", "link", "replace"])
def test_no_step_of_saving_harms_the_old_file(
    session: Session, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    assert session.path is not None
    before = session.path.read_bytes()

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, step, full)
    if step == "link":  # a disk without second names gets a copy; then that fails
        monkeypatch.setattr("shutil.copyfileobj", full)
    with pytest.raises(OutputError, match="no space"):
        session.save()
    monkeypatch.undo()
    assert session.path.read_bytes() == before
    session.save()


def test_what_reads_back_otherwise_is_not_saved(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert session.path is not None
    before = session.path.read_bytes()
    write = os.write
    monkeypatch.setattr(
        os, "write", lambda handle, data: write(handle, bytes(len(data))) if len(data) else 0
    )
    with pytest.raises(OutputError, match="reads back otherwise"):
        session.save()
    monkeypatch.undo()
    assert session.path.read_bytes() == before


def test_five_backups_are_kept(session: Session) -> None:
    assert session.path is not None
    saved = [session.path.read_bytes()]
    for frame in range(7):
        session.apply(plan_swap(session.tracks, 1, 2, frame))
        saved.append(session.save().read_bytes())
    kept = find_backups(session.path)
    assert [file.read_bytes() for file in kept] == saved[-2:-7:-1]
    older = Session.open(kept[2])
    assert len(older.history) == 4
    older.close()


def test_a_disk_without_second_names_gets_copies(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unknown(*_: object) -> None:
        raise OSError(errno.EPERM, "Operation not permitted")

    assert session.path is not None
    before = session.path.read_bytes()
    monkeypatch.setattr(os, "link", unknown)
    session.save()
    assert find_backups(session.path)[0].read_bytes() == before


def test_a_folder_that_does_not_exist_is_said(tmp_path: Path) -> None:
    recording = make_recording(tmp_path / "recording")
    with pytest.raises(OutputError, match="does not exist"):
        Session.create(recording, [make_run()], tmp_path / "nowhere" / "s.h5")
    assert not (tmp_path / "nowhere").exists()


def test_a_failed_first_save_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recording = make_recording(tmp_path / "recording")
    monkeypatch.setattr(os, "fsync", lambda _: (_ for _ in ()).throw(OSError(errno.EIO, "broken")))
    with pytest.raises(OutputError):
        Session.create(recording, [make_run()], tmp_path / "s.h5")
    assert [file.name for file in tmp_path.iterdir()] == ["recording"]


def test_what_a_killed_save_left_is_cleared_away(session: Session) -> None:
    assert session.path is not None
    session.close()
    companions(session.path).mkdir()
    (companions(session.path) / "saving-1.h5").write_bytes(b"half")
    Session.open(session.path).close()
    assert not companions(session.path).exists()


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of 600 KB, where the system lets us make one."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=600k", "tmpfs", str(disk)]
    if (
        sys.platform != "linux"
        or subprocess.run(mount, capture_output=True, check=False).returncode
    ):
        pytest.skip("no small disk can be made here")
    yield disk
    subprocess.run(["umount", "-l", str(disk)], check=True)


def fill(file: Path) -> None:
    with suppress(OSError), file.open("wb", buffering=0) as filler:
        while True:
            filler.write(bytes(512))


def edit_until_refused(session: Session) -> tuple[tuple[object, ...], str]:
    """The state after the last edit that was taken, and why the next one was not."""
    for frame in range(1000):
        state = state_of(session)
        try:
            session.apply(plan_swap(session.tracks, 1, 2, frame % 30))
        except OutputError as why:
            return state, str(why)
    raise AssertionError("the full disk took a thousand edits")


def test_a_disk_that_is_really_full_loses_nothing(small_disk: Path) -> None:
    session = make_session(small_disk)
    assert session.path is not None
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    filler = small_disk / "filler"
    fill(filler)
    before = session.path.read_bytes()
    with pytest.raises(OutputError, match="no space is left"):
        session.save()
    state, why = edit_until_refused(session)
    assert "journal of edits cannot be written" in why
    assert state_of(session) == state
    assert session.path.read_bytes() == before
    filler.unlink()
    session.apply(plan_swap(session.tracks, 1, 2, 11))
    state = state_of(session)
    session.save()
    session.close()
    again = Session.open(session.path)
    assert state_of(again) == state
    again.close()


@pytest.mark.skipif(sys.platform == "win32" or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written_opens_for_reading(session: Session) -> None:
    assert session.path is not None
    session.close()
    session.path.parent.chmod(0o555)
    try:
        again = Session.open(session.path)
        assert again.read_only
        assert "cannot be written" in again.notes[0]
        with pytest.raises(SessionError):
            again.apply(plan_swap(again.tracks, 1, 2, 10))
        again.close()
    finally:
        session.path.parent.chmod(0o755)


def test_a_disk_that_keeps_refusing_does_not_push_backups_out(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert session.path is not None
    for frame in range(3):
        session.apply(plan_swap(session.tracks, 1, 2, frame))
        session.save()
    before = [file.read_bytes() for file in find_backups(session.path)]
    present = session.path.read_bytes()

    replace = os.replace

    def refusing(new: Path, old: Path) -> None:
        if old == session.path:
            raise PermissionError(errno.EACCES, "in use")
        replace(new, old)

    session.apply(plan_swap(session.tracks, 1, 2, 3))
    monkeypatch.setattr(os, "replace", refusing)
    for _ in range(6):
        with pytest.raises(OutputError):
            session.save()
    monkeypatch.undo()
    session.save()
    assert [file.read_bytes() for file in find_backups(session.path)] == [present, *before]


def test_a_save_keeps_a_private_session_private(session: Session) -> None:
    assert session.path is not None
    session.path.chmod(0o600)
    session.save()
    if sys.platform != "win32":
        assert session.path.stat().st_mode & 0o777 == 0o600


def test_a_folder_that_cannot_be_synced_is_no_failed_save(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    sync = os.fsync

    def only_files(handle: int) -> None:
        if stat.S_ISDIR(os.fstat(handle).st_mode):
            raise OSError(errno.EINVAL, "Invalid argument")
        sync(handle)

    session.apply(plan_swap(session.tracks, 1, 2, 10))
    monkeypatch.setattr(os, "fsync", only_files)
    session.save()
    assert not session.dirty


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_link_to_a_session_is_the_session_itself(session: Session, tmp_path: Path) -> None:
    assert session.path is not None
    link = tmp_path / "elsewhere" / "link.h5"
    link.parent.mkdir()
    link.symlink_to(session.path)
    second = Session.open(link)
    assert second.read_only
    second.close()
    session.close()
    third = Session.open(link)
    third.apply(plan_swap(third.tracks, 1, 2, 10))
    third.save()
    assert link.is_symlink()
    assert [file.name for file in link.parent.iterdir()] == ["link.h5"]
    third.close()
    again = Session.open(session.path)
    assert len(again.history) == 1
    again.close()


def test_a_lock_is_given_back_where_there_is_no_room_to_say_who_holds_it(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert session.path is not None
    session.close()

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "ftruncate", full)
        first = Session.open(session.path)
        assert not first.read_only
        first.close()
    second = Session.open(session.path)
    assert not second.read_only
    second.close()


@pytest.mark.parametrize("said", [b"", b" {", b' {"process": 1e999}', b" " + b"[" * 4000, b" 5"])
def test_a_lock_file_that_says_nonsense_is_another_program_s(tmp_path: Path, said: bytes) -> None:
    (tmp_path / "lock").write_bytes(said)
    assert SessionLock(tmp_path / "lock").holder() == "another program"
