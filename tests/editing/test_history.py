"""The log of edits: undo and redo without limit, and what cannot be redone any more."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracking.editing import Change, History, State, StoredChange
from tracking.errors import EditError


def log_of(count: int) -> History:
    history = History()
    for number in range(count):
        add(history, f"edit {number + 1}")
    return history


def add(history: History, text: str) -> None:
    change = Change("rename", text, 0, State(), State())
    history.add(history.draft(change, "2026-01-01T00:00:00.000+00:00", "ada"))


def states(history: History) -> str:
    return "".join("a" if e.abandoned else "u" if e.undone else "d" for e in history)


def test_undo_goes_back_to_the_first_and_redo_to_the_last() -> None:
    history = log_of(3)
    assert [history.mark_undone().id for _ in range(3)] == [3, 2, 1]
    assert history.next_undo is None
    assert [history.mark_redone().id for _ in range(3)] == [1, 2, 3]
    assert history.next_redo is None
    assert states(history) == "ddd"


def test_a_new_edit_abandons_what_was_undone() -> None:
    history = log_of(3)
    history.mark_undone()
    history.mark_undone()
    add(history, "another way")
    assert states(history) == "daad"
    assert history.next_redo is None
    history.mark_undone()
    assert history.next_redo is not None
    assert history.next_redo.id == 4
    assert history.next_undo is not None
    assert history.next_undo.id == 1


def test_a_log_taken_up_again_goes_on_where_it_was() -> None:
    history = log_of(3)
    history.mark_undone()
    add(history, "another way")
    history.mark_undone()
    again = History(history.entries)
    assert (again.next_undo, again.next_redo) == (history.next_undo, history.next_redo)
    assert again.mark_redone().text == "another way"


def test_an_entry_says_who_when_and_what() -> None:
    entry = log_of(1).entries[0]
    assert (entry.id, entry.author, entry.kind, entry.text) == (1, "ada", "rename", "edit 1")
    assert entry.change.text == "edit 1"


def test_nothing_to_undo_or_redo_is_said() -> None:
    with pytest.raises(EditError, match="nothing to undo"):
        History().mark_undone()
    with pytest.raises(EditError, match="nothing to redo"):
        log_of(1).mark_redone()


def test_a_log_that_cannot_be_is_refused() -> None:
    entries = log_of(2).entries
    with pytest.raises(EditError, match="numbered"):
        History(entries[1:])
    with pytest.raises(EditError, match="before one that is in force"):
        History([replace(entries[0], undone=True), entries[1]])


def test_a_change_that_was_written_ahead_is_logged_as_one_that_was_not() -> None:
    change = Change("rename", "edit 1", 0, State(np.array([[3, 0, 9]])), State())
    drafted = [
        History().draft(change, "now", "ada", written=written)
        for written in (None, StoredChange.of(change), StoredChange(replace(change), "{", "{"))
    ]
    assert drafted == [drafted[0]] * 3
    assert '"stretches":[[3,0,9]]' in drafted[0].before
