"""An edit that fails once its step is in the journal was never made, there neither."""

from __future__ import annotations

from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, state_of

from tracking.editing import plan_split
from tracking.session import Session

AFTER_THE_STEP = [
    "tracking.session.journal.text_bytes",
    "tracking.session.journal.StepCount.write",
    "tracking.editing.log.history.touched",
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
