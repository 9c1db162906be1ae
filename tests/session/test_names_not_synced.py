"""A disk that fails to keep a new name: told, and the journal keeps what the old file misses."""

from __future__ import annotations

import errno
import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, state_of

from tracking.errors import OutputError
from tracking.owned_files import sync_folder
from tracking.session import Session, find_backups

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="folders are not synced there")


@contextmanager
def failing_folders(number: int = errno.EIO) -> Iterator[None]:
    sync = os.fsync

    def only_files(handle: int) -> None:
        if stat.S_ISDIR(os.fstat(handle).st_mode):
            raise OSError(number, os.strerror(number))
        sync(handle)

    with pytest.MonkeyPatch.context() as failing:
        failing.setattr(os, "fsync", only_files)
        yield


def after_a_power_cut(session: Session, folder: Path) -> Path:
    """The new name is undone; the journal is as it was synced."""
    path = crashed(session, folder)
    find_backups(path)[0].replace(path)
    return path


def test_a_save_whose_name_may_not_last_is_told_and_the_journal_keeps_its_steps(
    session: Session, tmp_path: Path
) -> None:
    edit(session, swaps=2)
    with failing_folders(), pytest.raises(OutputError, match="Input/output error") as told:
        session.save()
    assert "\n" not in str(told.value)
    assert session.dirty
    for folder, left in (("cut", after_a_power_cut), ("whole", crashed)):
        again = Session.open(left(session, tmp_path / folder))
        assert (state_of(again), again.damage) == (state_of(session), ())
        again.close()
    edit(session)
    session.save()
    assert not session.dirty


def test_an_edit_after_a_restored_backup_whose_name_may_not_last_builds_on_what_is_edited(
    session: Session, tmp_path: Path
) -> None:
    edit(session, swaps=2)
    session.save()
    session.undo()
    session.save()
    with failing_folders(), pytest.raises(OutputError, match="Input/output error"):
        session.restore(2)
    edit(session)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert (state_of(again), again.damage) == (state_of(session), ())
    again.close()


@pytest.mark.parametrize("number", [errno.EINVAL, errno.ENOTSUP, errno.ENOSYS, errno.EACCES])
def test_a_disk_that_syncs_no_folders_at_all_is_no_failing_one(tmp_path: Path, number: int) -> None:
    with failing_folders(number):
        sync_folder(tmp_path)
    with failing_folders(errno.ENOSPC), pytest.raises(OSError, match="No space"):
        sync_folder(tmp_path)
