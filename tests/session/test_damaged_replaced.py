"""A backup in the place of a damaged session: the damaged file is never the price of a failure."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from made_up_sessions import edit

from tracking.session import Session, backup_restore, replace_damaged
from tracking.session.session_writer import companions
from tracking.session.store import is_open


@pytest.fixture
def damaged(session: Session) -> Path:
    """A session that cannot be read, and its backup."""
    edit(session)
    path = session.save()
    session.close()
    path.write_bytes(b"\0" * 8 + path.read_bytes()[8:])
    return path


def fails(error: BaseException) -> Callable[..., None]:
    def failing(*_: object, **__: object) -> None:
        raise error

    return failing


@pytest.mark.parametrize(
    "error",
    [OSError(errno.EIO, os.strerror(errno.EIO)), KeyboardInterrupt()],
    ids=["EIO", "Ctrl+C"],
)
def test_what_fails_once_the_backup_is_in_place_leaves_the_damaged_file(
    damaged: Path, monkeypatch: pytest.MonkeyPatch, error: BaseException
) -> None:
    before = damaged.read_bytes()
    with monkeypatch.context() as failing:
        failing.setattr("tracking.session.backup_restore.sync_folder", fails(error))
        with pytest.raises(BaseException, match=r"Input/output error|^$"):
            replace_damaged(damaged, 1)
    assert (companions(damaged) / "damaged-1.h5").read_bytes() == before
    Session.open(damaged).close()


def test_what_fails_before_the_backup_is_in_place_keeps_no_second_damaged_file(
    damaged: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = damaged.read_bytes()
    with monkeypatch.context() as failing:
        failing.setattr("tracking.session.backup_restore.copy_file", fails(KeyboardInterrupt()))
        with pytest.raises(KeyboardInterrupt):
            replace_damaged(damaged, 1)
    assert damaged.read_bytes() == before
    assert not list(companions(damaged).glob("damaged-*"))


def test_a_backup_is_chosen_once_nobody_else_can_save(
    damaged: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = backup_restore.read_backup
    held: list[bool] = []

    def reads(path: Path, number: int) -> object:
        held.append(is_open(path))
        return read(path, number)

    monkeypatch.setattr("tracking.session.backup_restore.read_backup", reads)
    restored, _ = replace_damaged(damaged, 1)
    restored.close()
    assert held == [True]
