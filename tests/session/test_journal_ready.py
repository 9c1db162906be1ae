"""The journal is there before the first edit, and is nothing to anybody until then."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from made_up_sessions import make_session

from tracking.editing import plan_swap
from tracking.errors import OutputError
from tracking.session import Session, describe
from tracking.session.journal import Journal
from tracking.session.pending_edits import edits_wait
from tracking.session.session_writer import companions


def edit(session: Session) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))


def left_by_a_crash(session: Session, folder: Path) -> Path:
    """The session as a program leaves it that ends before its first edit, journal and all."""
    assert session.path is not None
    assert session._store is not None
    assert session._store.journal is not None  # waits until it is made
    folder.mkdir()
    shutil.copy(session.path, folder)
    shutil.copytree(companions(session.path), folder / companions(session.path).name)
    return folder / session.path.name


def forbid_new_journals(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(self: Journal, path: Path) -> None:
        raise AssertionError(f"{path} is opened while an edit waits for it")

    monkeypatch.setattr(Journal, "__init__", never)


@pytest.mark.parametrize("how", ["created", "opened", "saved elsewhere", "restored"])
def test_the_first_edit_makes_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: str
) -> None:
    session = make_session(tmp_path)
    if how == "opened":
        assert session.path is not None
        session.close()
        session = Session.open(session.path)
    elif how == "saved elsewhere":
        session.save(tmp_path / "other.h5")
    elif how == "restored":
        session.save()
        session = session.restore(1)
    assert session._store is not None
    assert session._store.journal is not None
    forbid_new_journals(monkeypatch)
    edit(session)
    session.close(discard=True)


def test_a_session_opened_and_closed_leaves_nothing_beside_it(session: Session) -> None:
    session.close()
    assert session.path is not None
    for _ in range(5):
        Session.open(session.path).close()
        assert not companions(session.path).exists()


def test_a_journal_without_an_edit_is_no_news_after_a_crash(
    session: Session, tmp_path: Path
) -> None:
    after = left_by_a_crash(session, tmp_path / "after")
    again = Session.open(after)
    assert (again.notes, again.recovered, again.dirty) == ((), 0, False)
    edit(again)
    again.close(discard=True)


def test_a_journal_without_an_edit_is_no_news_beside_another_save(
    session: Session, tmp_path: Path
) -> None:
    after = left_by_a_crash(session, tmp_path / "after")
    session.save()
    assert session.path is not None
    shutil.copy(session.path, after)
    again = Session.open(after)
    assert (again.notes, again.read_only) == ((), False)
    edit(again)
    again.close()
    once_more = Session.open(after)
    assert once_more.recovered == 1
    once_more.close(discard=True)


def test_a_session_open_elsewhere_without_an_edit_hides_nothing(session: Session) -> None:
    assert session.path is not None
    second = Session.open(session.path)
    assert second.read_only
    assert not any("not shown" in note for note in second.notes)
    assert not edits_wait(session.path)
    edit(session)
    assert edits_wait(session.path)
    third = Session.open(session.path)
    assert any("not shown" in note for note in third.notes)


def test_where_no_journal_can_be_made_the_first_edit_tells_and_the_next_one_is_kept(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(self: Journal, *_: object) -> None:
        raise OutputError("s.h5: the journal of edits cannot be written")

    assert session.path is not None
    session.close()
    with monkeypatch.context() as at_first:
        at_first.setattr(Journal, "start_over", full)
        again = Session.open(session.path)
        assert not again.read_only
        with pytest.raises(OutputError, match="cannot be written"):
            edit(again)
    edit(again)
    assert describe(session.path)["edits_waiting_in_journal"] == 1
    again.close(discard=True)
