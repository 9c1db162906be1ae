import pytest

from app.core.document.edit_history import HistoryList
from tracking.editing import Change, History, State


@pytest.fixture
def history():
    history = History()
    for number in range(3):
        _add(history, f"edit {number + 1}")
    return history


def _add(history: History, text: str) -> None:
    change = Change("rename", text, 7, State(), State())
    history.add(history.draft(change, "2024-05-01T10:00:00.000Z", "mika"))


def test_the_log_is_listed_oldest_first(history):
    assert [item.text for item in HistoryList().of(history)] == ["edit 1", "edit 2", "edit 3"]


def test_an_unchanged_log_is_the_same_list_and_unchanged_edits_are_the_same_items(history):
    listed = HistoryList()
    before = listed.of(history)
    assert listed.of(history) is before
    history.mark_undone()
    after = listed.of(history)
    assert after[2].undone
    assert [a is b for a, b in zip(before, after, strict=True)] == [True, True, False]


def test_what_was_undone_before_another_edit_is_listed_no_more(history):
    listed = HistoryList()
    listed.of(history)
    history.mark_undone()
    _add(history, "edit 4")
    assert [item.text for item in listed.of(history)] == ["edit 1", "edit 2", "edit 4"]
