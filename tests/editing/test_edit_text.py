"""Text that is no edit is refused, however it is made."""

from __future__ import annotations

import json

import pytest
from tables_of_people import table_of

from tracking.editing import plan_delete, rows_beyond_the_log, state_as_text, state_from_text
from tracking.errors import EditError

ROWS = json.loads(state_as_text(plan_delete(table_of({1: [(0, 9)]}), 1).before))["rows"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "[" * 100_000,
        '{"stretches": [[1, 2]]}',
        '{"stretches": "x"}',
        '{"stretches": [[1e400, 2, 3]]}',
        '{"rows": {}}',
        '{"labels": {"tracks": {"x": {}}}}',
        '{"labels": {"occluders": [1]}}',
        '{"labels": {"parts": [[1, 2, 0, 1, 2, 3, 4, 1, "person"]]}}',
        '{"labels": {"parts": [[1, 2, 0, 1, 2, 0, 4, true, "person"]]}}',
        '{"labels": {"parts": [[1, 2, 0, 1, 2, 3, 4, true, "me"]]}}',
        '{"labels": {"parts": [[1, 2, 7, 1, 2, 3, 4, true, "person"]]}}',
        '{"labels": {"verdicts": [["crossing", [1], 5, "maybe"]]}}',
        '{"labels": {"lines": [["a", [0, 0], [NaN, 1]]]}}',
        '{"labels": {"regions": [["a", [[0, 0], [1, 1]]]]}}',
        '{"labels": {"reviewed": [[0, 5, 5]]}}',
        json.dumps({"rows": {**ROWS, "count": 8}}),
        json.dumps({"rows": {**ROWS, "count": 10**12}}),
        json.dumps({"rows": {**ROWS, "count": -1}}),
        json.dumps({"rows": {**ROWS, "columns": ROWS["columns"][:-8]}}),
        json.dumps({"rows": {**ROWS, "columns": "?"}}),
    ],
)
def test_what_is_no_edit_is_refused(text: str) -> None:
    with pytest.raises(EditError):
        state_from_text(text)


def test_an_edit_that_could_not_be_read_again_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    side = plan_delete(table_of({1: [(0, 9)]}), 1).before
    longest = len(state_as_text(side))
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", longest)
    assert len(state_from_text(state_as_text(side)).rows["frame"]) == 9
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", longest - 1)
    with pytest.raises(EditError, match="an edit of 9 rows is larger than the history can keep"):
        state_as_text(side)


def test_what_the_log_will_not_keep_is_told_before_it_is_tried(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    change = plan_delete(table_of({1: [(0, 90_000)]}), 1)
    assert rows_beyond_the_log(change) == 0
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", 2 * 90_000)
    with pytest.raises(EditError, match="larger than the history can keep"):
        state_as_text(change.before)
    assert rows_beyond_the_log(change) == rows_beyond_the_log(change.inverse) == 90_000
