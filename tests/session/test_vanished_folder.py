"""A folder that vanishes and comes back: told at once, and nothing acknowledged is lost."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from made_up_sessions import make_session, state_of

from tracking.editing import plan_rename, plan_swap
from tracking.errors import OutputError, SessionError, TrackwrightError
from tracking.session import Session
from tracking.session.session_writer import companions

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="open files cannot be moved there")


@pytest.fixture
def disk(tmp_path: Path) -> Path:
    """A folder that may go away."""
    (tmp_path / "disk").mkdir()
    return tmp_path / "disk"


@pytest.fixture
def session(disk: Path) -> Iterator[Session]:
    """A session there, with one edit that only the journal has."""
    session = make_session(disk)
    edit(session, 10)
    yield session
    session.close()


def edit(session: Session, frame: int) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, frame))


def refused(session: Session, error: type[TrackwrightError], why: str) -> None:
    """An edit is refused in a line, and nothing is changed by it."""
    before = state_of(session)
    for act in (lambda: edit(session, 15), session.undo, session.save):
        with pytest.raises(error, match=why) as told:
            act()
        assert "\n" not in str(told.value)
    assert state_of(session) == before


def goes_on(session: Session, tmp_path: Path) -> None:
    """Edits and saves work; what is on disk is what the session says, after a crash too."""
    edit(session, 20)
    assert session.path is not None
    after = tmp_path / "after"
    after.mkdir()
    shutil.copy(session.path, after)
    shutil.copytree(companions(session.path), after / companions(session.path).name)
    crashed = Session.open(after / session.path.name)
    assert state_of(crashed) == state_of(session)
    crashed.close()
    session.save()
    edit(session, 21)
    state, path = state_of(session), session.path
    session.close()
    again = Session.open(path)
    assert state_of(again) == state
    again.close()


def test_a_folder_that_is_back_is_gone_on_with(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    refused(session, OutputError, "out of reach: its folder has vanished or is locked")
    (tmp_path / "away").rename(disk)
    goes_on(session, tmp_path)


def test_a_folder_that_cannot_be_looked_into_is_out_of_reach_until_it_can(
    session: Session, disk: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = os.stat

    def locked(path: object, *args: Any, **more: Any) -> os.stat_result:
        if isinstance(path, str | Path) and Path(path).is_relative_to(disk):
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return real(path, *args, **more)

    with monkeypatch.context() as patched:
        patched.setattr(os, "stat", locked)
        with pytest.raises(OutputError, match="out of reach: its folder has vanished or is locked"):
            edit(session, 15)
    goes_on(session, tmp_path)


def test_nothing_is_made_where_an_empty_folder_stands_instead(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    disk.mkdir()  # where a network disk was mounted
    refused(session, OutputError, "out of reach")
    assert list(disk.iterdir()) == []
    disk.rmdir()
    (tmp_path / "away").rename(disk)
    goes_on(session, tmp_path)


def test_a_folder_that_is_back_with_other_file_numbers_is_gone_on_with(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    refused(session, OutputError, "out of reach")
    shutil.copytree(tmp_path / "away", disk)
    goes_on(session, tmp_path)


def test_what_a_journal_that_came_back_misses_is_put_on_disk(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    older = shutil.copytree(disk, tmp_path / "older")
    edit(session, 12)
    edit(session, 13)
    disk.rename(tmp_path / "away")
    older.rename(disk)  # as from last night's copy
    goes_on(session, tmp_path)


def test_a_journal_that_is_lost_is_put_on_disk_anew(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    assert session.path is not None
    shutil.rmtree(companions(session.path))
    goes_on(session, tmp_path)


def test_what_a_lost_journal_had_is_saved_at_closing(session: Session) -> None:
    path, state = session.path, state_of(session)
    assert path is not None
    shutil.rmtree(companions(path))
    session.close()
    again = Session.open(path)
    assert (state_of(again), again.recovered, again.damage) == (state, 0, ())
    again.close()


def test_discarded_edits_of_a_lost_journal_are_not_saved(session: Session) -> None:
    path = session.path
    assert path is not None
    before = path.read_bytes()
    shutil.rmtree(companions(path))
    session.close(discard=True)
    assert path.read_bytes() == before


def test_edits_that_are_out_of_reach_at_closing_are_told_and_wait_there(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    state = state_of(session)
    disk.rename(tmp_path / "away")
    with pytest.raises(OutputError, match=r"may be lost: .*its folder has vanished") as told:
        session.close()
    assert "\n" not in str(told.value)
    again = Session.open(tmp_path / "away" / "s.h5")
    assert (state_of(again), again.recovered) == (state, 1)
    again.close()


def test_what_another_program_did_meanwhile_is_not_written_over(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    shutil.copytree(tmp_path / "away", disk)
    assert session.path is not None
    other = Session.open(session.path)
    refused(session, SessionError, "is open in process")
    other.apply(plan_rename(other.tracks, other.labels, 1, "red coat"))
    other.save()
    other.close()
    saved = session.path.read_bytes()
    refused(session, SessionError, "changed by another program while it was out of reach")
    assert session.path.read_bytes() == saved
    state = state_of(session)
    session.save(tmp_path / "mine.h5")
    edit(session, 25)
    assert state_of(session)[2][:-1] == state[2]


def test_runs_that_are_out_of_reach_are_saved_nowhere_else(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    with pytest.raises(SessionError, match="out of reach: it was moved or its disk has gone"):
        session.save(tmp_path / "here.h5")
    assert not (tmp_path / "here.h5").exists()
    (tmp_path / "away").rename(disk)
    session.save(tmp_path / "here.h5")
    goes_on(session, tmp_path)


def test_a_lock_that_another_program_took_is_not_taken_away(
    session: Session, disk: Path, tmp_path: Path
) -> None:
    disk.rename(tmp_path / "away")
    shutil.copytree(tmp_path / "away", disk)
    assert session.path is not None
    other = Session.open(session.path)
    with pytest.raises(SessionError, match=r"may be lost: .* is open in process"):
        session.close()
    third = Session.open(session.path)
    assert third.read_only
    other.close()


@contextmanager
def mounted(source: Path, place: Path) -> Iterator[None]:
    done = subprocess.run(["mount", "--bind", source, place], capture_output=True, check=False)
    if done.returncode:
        pytest.skip("mounting is not allowed here")
    try:
        yield
    finally:
        subprocess.run(["umount", "--lazy", place], check=True)


@pytest.mark.skipif(sys.platform != "linux", reason="mounts otherwise elsewhere")
def test_a_disk_that_is_unmounted_and_mounted_again_is_gone_on_with(tmp_path: Path) -> None:
    source, place = tmp_path / "server", tmp_path / "share"
    source.mkdir()
    place.mkdir()
    with mounted(source, place):
        session = make_session(place)
        edit(session, 10)
    refused(session, OutputError, "out of reach")
    assert list(place.iterdir()) == []
    with mounted(source, place):
        goes_on(session, tmp_path)


@pytest.mark.skipif(
    sys.platform == "win32" or os.geteuid() != 0, reason="only root can become somebody else"
)
def test_a_folder_that_may_not_be_written_any_more_is_told(tmp_path: Path) -> None:
    place = Path(tempfile.mkdtemp())
    session = make_session(place)
    assert session.path is not None
    edit(session, 10)
    before, state = session.path.read_bytes(), state_of(session)
    for folder in (place, companions(session.path)):
        folder.chmod(0o555)
        os.chown(folder, 65534, -1)
    os.seteuid(65534)
    try:
        with pytest.raises(OutputError, match="may not write there"):
            session.save()
        again = Session.open(session.path)
        assert again.read_only
        again.close()
    finally:
        os.seteuid(0)
        for folder in (place, companions(session.path)):
            folder.chmod(0o755)
            os.chown(folder, 0, -1)
    assert (session.path.read_bytes(), state_of(session)) == (before, state)
    goes_on(session, tmp_path)
    shutil.rmtree(place)
