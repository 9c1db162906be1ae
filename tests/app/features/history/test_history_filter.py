import pytest

from app.core.scenes import HistoryItem
from app.features.history.history_filter import HistoryFilter


def _item(edit, text, author="mika", kind="swap") -> HistoryItem:
    return HistoryItem(edit, text, "10:40:00", author, 7, False, kind)


ITEMS = (
    _item(1, "Swap 4 and 7 from frame 834 on"),
    _item(2, "Delete track 44", "ann", "delete"),
    _item(3, 'Name 7 "Red coat"', "ann", "rename"),
)


@pytest.mark.parametrize(
    ("wanted", "left"),
    [
        (HistoryFilter(), [1, 2, 3]),
        (HistoryFilter("  "), [1, 2, 3]),
        (HistoryFilter("4"), [1]),  # not 44, not 834
        (HistoryFilter("7"), [1, 3]),
        (HistoryFilter("red 7"), [3]),
        (HistoryFilter("ANN"), [2, 3]),
        (HistoryFilter(author="mika"), [1]),
        (HistoryFilter(kind="delete"), [2]),
        (HistoryFilter("7", author="ann"), [3]),
        (HistoryFilter("(7"), []),
    ],
)
def test_edits_are_found_by_words_ids_author_and_kind(wanted, left):
    assert [item.edit for item in wanted.of(ITEMS)] == left
