"""An edit that fails once its step is in the journal was never made, there neither."""

from __future__ import annotations

import os
import sqlite3
import zlib
from functools import partial
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, make_session, state_of

from tracking.editing import plan_split
from tracking.session import Session

AFTER_THE_STEP = [
    "tracking.session.journal.text_bytes",
    "tracking.session.journal.StepCount.write",
    "tracking.editing.log.history.footprint_of",
]
"""What is done only for or after a step; memory may not suffice for it."""


@pytest.mark.parametrize("error", [MemoryError, KeyboardInterrupt])
@pytest.mark.parametrize("where", AFTER_THE_STEP)
def test_an_edit_that_fails_at_the_last_moment_costs_no_later_one(
    session: Session,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    where: str,
    error: type[BaseException],
) -> None:
    def fails(*_: object, **__: object) -> None:
        raise error

    edit(session, swaps=2)
    session.undo()
    before = state_of(session)
    with monkeypatch.context() as at_first:
        at_first.setattr(where, fails)
        with pytest.raises(error):
            session.apply(plan_split(session.tracks, 1, 20))
    assert state_of(session) == before
    assert session.redo()
    edit(session, swaps=2)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert (state_of(again), again.damage, again.recovered) == (state_of(session), (), 6)
    again.close()


def test_an_edit_that_does_not_apply_leaves_the_step_before_it(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object) -> None:
        raise MemoryError

    edit(session)
    with monkeypatch.context() as at_first:
        at_first.setattr("tracking.session.journal.row_of", fails)
        with pytest.raises(MemoryError):
            session.apply(plan_split(session.tracks, 1, 20))
    session.undo()
    again = Session.open(crashed(session, tmp_path / "after"))
    assert (state_of(again), again.damage, again.recovered) == (state_of(session), (), 2)
    again.close()


class SaysItFailed(sqlite3.Connection):
    """A database whose disk says that what it just did for good has failed."""

    commits_left = 0

    def execute(self, statement: str, *values: object) -> sqlite3.Cursor:
        done = super().execute(statement, *values)
        if statement == "COMMIT" and SaysItFailed.commits_left:
            SaysItFailed.commits_left -= 1
            why = sqlite3.OperationalError("disk I/O error")
            why.sqlite_errorcode = sqlite3.SQLITE_IOERR
            raise why
        return done


def test_a_journal_that_was_said_not_to_start_over_is_no_other_program_s(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sqlite3, "connect", partial(sqlite3.connect, factory=SaysItFailed))
    session = make_session(tmp_path)
    edit(session, swaps=2)
    pending = session.begin_save()
    pending.write()
    edit(session)  # while it is saved: the journal keeps it
    monkeypatch.setattr(SaysItFailed, "commits_left", 1)
    session.finish_save(pending)
    assert SaysItFailed.commits_left == 0
    edit(session, swaps=2)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert (state_of(again), again.damage, again.recovered) == (state_of(session), (), 3)
    again.close()
    session.close()


def test_a_count_of_steps_that_the_system_writes_in_pieces_is_whole(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    edit(session)
    write = os.write
    monkeypatch.setattr(os, "write", lambda handle, data: write(handle, data[:10]))
    edit(session)
    monkeypatch.undo()
    assert session.path is not None
    count = session.path.with_name(".s.h5.trackwright") / "journal.sqlite-count"
    digest, steps, checked = count.read_bytes().split()
    assert (int(steps), int(checked, 16)) == (2, zlib.crc32(digest + b" " + steps))
