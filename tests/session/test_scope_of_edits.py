"""The frames an edit was made for, kept as data in the journal and in the file."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_up_sessions import make_session

from tracking.editing import (
    Scope,
    find_protected,
    plan_label_part,
    plan_rename,
    plan_swap,
    plan_unlabel_part,
)
from tracking.errors import EditError, SessionError
from tracking.session import Session
from tracking.session.session_writer import companions
from tracking.tracks import LARGEST_NUMBER, PartLabel


def scopes(session: Session) -> list[Scope | None]:
    return [entry.scope for entry in session.history]


def protected(session: Session) -> list[list[int]]:
    found = find_protected(session.tracks, session.labels, session.history, fps=20.0)
    return found.stretches.tolist()


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    """Edited, saved and closed: a swap from here on, one in a range, and a name."""
    with closing(make_session(tmp_path)) as session:
        session.apply(plan_swap(session.tracks, 1, 2, 10))
        session.apply(plan_swap(session.tracks, 1, 2, 3, 5))
        session.apply(plan_rename(session.tracks, session.labels, 1, "from frame 3 on"))
        return session.save()


def test_a_saved_session_keeps_the_scope_of_each_edit(saved: Path) -> None:
    with closing(Session.open(saved)) as session:
        assert scopes(session) == [Scope(10), Scope(3, 5), None]


def test_an_edit_waiting_in_the_journal_keeps_its_scope(saved: Path) -> None:
    with closing(Session.open(saved)) as session:
        session.apply(plan_swap(session.tracks, 1, 2, 7, 9))
    with closing(Session.open(saved)) as session:
        assert (session.recovered, scopes(session)[-1]) == (1, Scope(7, 9))


def test_what_is_protected_hangs_on_the_scope_and_not_on_the_words(tmp_path: Path) -> None:
    with closing(make_session(tmp_path)) as session:
        swap = plan_swap(session.tracks, 1, 2, 3, 15)
        session.apply(replace(swap, text="Fixed: 1 and 2 were changed over from frame 3 on"))
        assert protected(session) == [[1, 3, 15], [2, 3, 15]]


def test_a_file_and_a_journal_without_scopes_read_as_their_texts_say(saved: Path) -> None:
    with closing(Session.open(saved)) as session:
        session.apply(plan_swap(session.tracks, 1, 2, 7))
        before = protected(session)
    with h5py.File(saved, "a") as file:
        del file["edits/scope"]
    base = sqlite3.connect(companions(saved) / "journal.sqlite")
    for column in ("message", "checksum", "scope"):
        base.execute(f"ALTER TABLE steps DROP COLUMN {column}")
    base.close()
    with closing(Session.open(saved)) as session:
        assert (session.recovered, scopes(session)) == (1, [Scope(10), None, None, Scope(7)])
        assert protected(session) == before


@pytest.mark.parametrize("nonsense", ["5:5", "9:3", "from 3", "-1:4", "3", f"0:{2**40}", "٣:"])
def test_a_scope_that_is_none_is_refused(saved: Path, nonsense: str) -> None:
    with h5py.File(saved, "a") as file:
        file["edits/scope"][1] = nonsense
    with pytest.raises(SessionError, match="are no frames"):
        Session.open(saved)


@given(st.integers(0, LARGEST_NUMBER - 1), st.none() | st.integers(1, LARGEST_NUMBER))
def test_a_scope_comes_back_from_its_text(start: int, length: int | None) -> None:
    scope = Scope(start, None if length is None else min(start + length, LARGEST_NUMBER))
    assert Scope.of_text(scope.as_text) == scope


def test_an_empty_text_is_no_scope() -> None:
    assert Scope.of_text("") is None
    with pytest.raises(EditError, match="no frames"):
        Scope.of_text("here")


def test_undoing_alone_is_about_the_frames_of_what_it_takes_back(saved: Path) -> None:
    with closing(Session.open(saved)) as session:
        session.undo_alone(2)
        assert scopes(session)[-1] == Scope(3, 5)
        session.undo_alone(3)
        assert scopes(session)[-1] is None


def test_labels_of_parts_are_about_the_frames_from_the_first_to_the_last(saved: Path) -> None:
    box = (1.0, 2.0, 3.0, 4.0)
    with closing(Session.open(saved)) as session:
        several = [PartLabel(frame, 1, 0, box) for frame in (12, 7, 9)]
        session.apply(plan_label_part(session.labels, several))
        session.apply(plan_unlabel_part(session.labels, (9, 1, 0)))
        assert scopes(session)[-2:] == [Scope(7, 13), Scope(9, 10)]
