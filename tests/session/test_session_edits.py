"""Edits are on disk before they are acknowledged, and come back after a crash."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest
from made_up_sessions import crashed, edit, make_run, state_of

from tracking.editing import plan_delete, plan_rename, plan_split, plan_swap
from tracking.errors import EditError, OutputError, SessionError
from tracking.session import Session, describe


def test_a_new_session_is_saved_and_clean(session: Session) -> None:
    assert not session.dirty
    assert not session.read_only
    assert session.notes == ()


def test_an_edit_makes_the_session_dirty_until_it_is_saved(session: Session) -> None:
    edit(session)
    assert session.dirty
    session.save()
    assert not session.dirty


def test_edits_survive_a_crash(session: Session, tmp_path: Path) -> None:
    edit(session, swaps=2)
    session.undo()
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    assert again.recovered == 3
    assert again.dirty
    assert again.notes == (
        "Recovered: 2 edits made after the session was saved last, 1 of them undone again",
    )
    again.close()


def test_a_saved_edit_undone_before_a_crash_is_told_as_undone(
    session: Session, tmp_path: Path
) -> None:
    edit(session)
    session.save()
    session.undo()
    again = Session.open(crashed(session, tmp_path / "after"))
    assert again.notes == ("Recovered: 1 edit undone after the session was saved last",)
    again.close()


@pytest.mark.parametrize("undone_before_saving", [True, False])
def test_a_saved_edit_redone_before_a_crash_is_told_as_redone(
    session: Session, tmp_path: Path, undone_before_saving: bool
) -> None:
    edit(session, swaps=2)
    if undone_before_saving:
        session.undo()
    session.save()
    if not undone_before_saving:
        session.undo()
    session.redo()
    again = Session.open(crashed(session, tmp_path / "after"))
    assert again.notes == ("Recovered: 1 edit redone after the session was saved last",)
    again.close()


def test_edits_made_after_recovery_survive_the_next_crash(session: Session, tmp_path: Path) -> None:
    edit(session)
    second = Session.open(crashed(session, tmp_path / "one"))
    second.apply(plan_split(second.tracks, 1, 20))
    third = Session.open(crashed(second, tmp_path / "two"))
    assert state_of(third) == state_of(second)
    third.close()
    second.close()


def test_a_crash_between_replacing_and_trimming_replays_nothing_twice(
    session: Session, tmp_path: Path
) -> None:
    edit(session)
    pending = session.begin_save()
    session.apply(plan_split(session.tracks, 1, 20))  # made while the file was being written
    pending.write()
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    assert again.recovered == 1
    third = Session.open(crashed(again, tmp_path / "twice"))
    assert state_of(third) == state_of(session)
    again.close()
    third.close()


def test_edits_made_while_saving_stay_in_the_journal(session: Session, tmp_path: Path) -> None:
    edit(session)
    pending = session.begin_save()
    session.apply(plan_split(session.tracks, 1, 20))
    pending.write()
    session.finish_save(pending)
    assert session.dirty
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    assert again.recovered == 1
    again.close()


def test_undo_works_after_reopening(session: Session) -> None:
    before = state_of(session)[0]
    session.apply(plan_delete(session.tracks, 2))
    edit_state = state_of(session)[0]
    path = session.save()
    session.close()
    again = Session.open(path)
    again.undo()
    assert state_of(again)[0] == before
    again.redo()
    assert state_of(again)[0] == edit_state
    again.close()


def test_closing_without_saving_keeps_the_edits_for_the_next_time(session: Session) -> None:
    edit(session)
    after = state_of(session)
    path = session.path
    session.close()
    assert path is not None
    assert describe(path)["edits_waiting_in_journal"] == 1
    again = Session.open(path)
    assert state_of(again) == after
    again.close()


def test_discarded_edits_are_gone(session: Session) -> None:
    before = state_of(session)
    path = session.path
    edit(session)
    session.close(discard=True)
    assert path is not None
    again = Session.open(path)
    assert state_of(again) == before
    again.close()


def test_a_closed_clean_session_leaves_nothing_beside_it(session: Session) -> None:
    path = session.path
    session.close()
    assert path is not None
    assert sorted(file.name for file in path.parent.iterdir()) == ["recording", "s.h5"]


def test_a_refused_edit_is_in_no_log(session: Session, tmp_path: Path) -> None:
    change = plan_swap(session.tracks, 1, 2, 10)
    session.apply(plan_delete(session.tracks, 2))
    with pytest.raises(EditError):
        session.apply(change)
    assert len(session.history) == 1
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()


def test_undo_of_nothing_is_told(session: Session) -> None:
    with pytest.raises(EditError, match="nothing to undo"):
        session.undo()
    with pytest.raises(EditError, match="nothing to redo"):
        session.redo()


def test_an_edit_that_cannot_be_journalled_is_not_made(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    edit(session)
    before = state_of(session)

    def full(*_: object) -> None:
        raise OutputError("disk is full")

    monkeypatch.setattr("tracking.session.journal.Journal.append", full)
    with pytest.raises(OutputError):
        session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    with pytest.raises(OutputError):
        session.undo()
    assert state_of(session) == before
    monkeypatch.undo()
    session.undo()


def test_an_edit_on_a_run_that_is_not_saved_saves_it_first(
    session: Session, tmp_path: Path
) -> None:
    session.add_run(make_run(seed=1, tracks=6))
    edit(session)
    again = Session.open(crashed(session, tmp_path / "after"))
    assert state_of(again) == state_of(session)
    again.close()


def test_a_run_of_fewer_frames_than_the_one_that_is_corrected_is_kept_beside_it(
    session: Session,
) -> None:
    adopted, before = session.adopted_run, session.tracks
    whole = make_run(seed=1, tracks=6)
    start, stop = whole.frames
    later = whole.tracks["frame"] > start
    late = {name: column[later] for name, column in whole.tracks.items()}
    session.add_run(replace(whole, frames=(start + 1, stop), tracks=late))
    assert session.adopted_run == adopted
    assert session.tracks is before
    assert session.add_run(whole) == session.adopted_run


def test_an_edit_waits_for_the_run_it_is_about_to_be_on_disk(
    session: Session, tmp_path: Path
) -> None:
    session.add_run(make_run(seed=1, tracks=6))
    pending = session.begin_save()
    with ThreadPoolExecutor(1) as worker:
        worker.submit(pending.write)
        edit(session)
    after = crashed(session, tmp_path / "after")
    session.finish_save(pending)
    later = crashed(session, tmp_path / "later")
    for path in (after, later):
        again = Session.open(path)
        assert state_of(again) == state_of(session)
        again.close()


def test_two_saves_at_once_are_refused(session: Session, tmp_path: Path) -> None:
    pending = session.begin_save()
    with pytest.raises(SessionError, match="is being saved"):
        session.save()
    with pytest.raises(SessionError, match="is being saved"):
        session.begin_save(tmp_path / "other.h5")
    session.abandon_save(pending)
    session.save()


def test_a_run_that_is_being_saved_elsewhere_is_not_edited(
    session: Session, tmp_path: Path
) -> None:
    session.add_run(make_run(seed=1, tracks=6))
    pending = session.begin_save(tmp_path / "other.h5")
    with pytest.raises(SessionError, match="edit again"):
        edit(session)
    session.abandon_save(pending)
    edit(session)
