"""A fault while a session opens leaves no lock behind in the program that meets it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from made_up_sessions import edit

from tracking import file_lock as lock_module
from tracking.session import Session


@pytest.fixture
def path(session: Session) -> Path:
    edit(session)
    session.close()
    assert session.path is not None
    return session.path


def opens(path: Path) -> None:
    again = Session.open(path)
    assert not again.read_only, again.notes
    assert again.recovered == 1
    again.close()


def test_a_disk_error_at_the_leftovers_of_a_save_keeps_no_lock(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(_: Path) -> None:
        raise OSError(5, "Input/output error")

    monkeypatch.setattr("tracking.session.store.clear_leftovers", fails)
    first = Session.open(path)
    assert first.read_only
    first.close()
    monkeypatch.undo()
    opens(path)


@pytest.mark.parametrize("error", [MemoryError, KeyboardInterrupt])
def test_an_error_nobody_expects_while_opening_keeps_no_lock(
    path: Path, monkeypatch: pytest.MonkeyPatch, error: type[BaseException]
) -> None:
    def fails(*_: object) -> None:
        raise error

    monkeypatch.setattr("tracking.session.on_disk.recover", fails)
    with pytest.raises(error):
        Session.open(path)
    monkeypatch.undo()
    opens(path)


def test_a_disk_that_reports_no_links_of_open_files_can_be_worked_on(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = os.fstat

    def without_links(handle: int) -> os.stat_result:
        state = list(real(handle))
        state[3] = 0
        return os.stat_result(state)

    monkeypatch.setattr(lock_module.os, "fstat", without_links)
    opens(path)
