import csv
import json

import numpy as np
import pytest

from app.presenters.exporting_log import write_log
from tracking.editing import Change, History, LabelState, State
from tracking.errors import OutputError
from tracking.tracks import TrackLabel


@pytest.fixture
def entries():
    """Two edits, the second of them undone."""
    history = History()
    for number, author in ((1, "mika"), (2, "=ann")):
        before = State(labels=LabelState({number: TrackLabel()}))
        after = State(labels=LabelState({number: TrackLabel(f'red, "coat" {number}')}))
        change = Change("rename", f'Name {number} "red, coat"', 7 * number, before, after)
        history.add(history.draft(change, "2024-05-01T10:00:00.000Z", author))
    history.mark_undone()
    return history.entries


def test_json_says_everything_about_every_edit(entries, tmp_path):
    write_log(entries, tmp_path / "log.json")
    log = json.loads((tmp_path / "log.json").read_text("utf-8"))
    assert log[0] == {
        "edit": 1,
        "time": "2024-05-01T10:00:00.000Z",
        "author": "mika",
        "kind": "rename",
        "text": 'Name 1 "red, coat"',
        "frame": 7,
        "tracks": [1],
        "undone": False,
        "undoes": 0,
    }
    assert [row["undone"] for row in log] == [False, True]


def test_csv_reads_back_and_holds_no_formula(entries, tmp_path):
    write_log(entries, tmp_path / "log.csv")
    with (tmp_path / "log.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["text"] for row in rows] == ['Name 1 "red, coat"', 'Name 2 "red, coat"']
    assert [row["author"] for row in rows] == ["mika", "'=ann"]
    assert [row["undone"] for row in rows] == ["False", "True"]
    assert np.array_equal([int(row["tracks"]) for row in rows], [1, 2])


def test_a_log_that_cannot_be_written_is_told(entries, tmp_path):
    with pytest.raises(OutputError, match="cannot write"):
        write_log(entries, tmp_path / "nowhere" / "log.csv")
