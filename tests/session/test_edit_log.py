"""The log as CSV and JSON."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import FRAMES

from tracking.editing import (
    plan_delete,
    plan_draw_box,
    plan_label_part,
    plan_mark_reviewed,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
    plan_swap,
    plan_verdict,
)
from tracking.errors import OutputError
from tracking.session import Session, read_history, write_log_csv, write_log_json
from tracking.tracks import CORRECTED_COLUMNS, PartLabel, Verdict


@pytest.fixture
def edited(session: Session) -> Session:
    """Five edits: one taken back alone, one undone for good."""
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.apply(plan_rename(session.tracks, session.labels, 3, "-red, coat"))
    session.undo()
    session.apply(plan_set_notes(session.tracks, session.labels, 3, "=HYPERLINK(1)"))
    session.undo_alone(1)
    session.apply(plan_delete(session.tracks, 4, 0, 20))
    return session


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_csv_has_a_line_an_edit(edited: Session, tmp_path: Path) -> None:
    write_log_csv(edited.history, tmp_path / "log.csv")
    rows = rows_of(tmp_path / "log.csv")
    assert [row["id"] for row in rows] == ["1", "2", "3", "4", "5"]
    assert [row["kind"] for row in rows] == ["swap", "rename", "notes", "undo", "delete"]
    assert [row["undone"] for row in rows] == ["undone by 4", "undone for good", "", "", ""]
    assert [row["undoes"] for row in rows] == ["", "", "", "1", ""]
    assert {row["author"] for row in rows} == {"ada"}
    assert rows[0]["tracks"] == "1 2"
    assert rows[0]["before"] == "track 1 within frames 10 to 39; track 2 within frames 10 to 39"
    assert rows[0]["after"] == "track 2 within frames 10 to 39; track 1 within frames 10 to 39"
    assert [row["frames"] for row in rows] == ["10:", "", "", "10:", "0:20"]


def test_csv_says_what_was_and_what_is_so_that_people_can_read_it(
    edited: Session, tmp_path: Path
) -> None:
    edited.apply(plan_set_attribute(edited.tracks, edited.labels, 3, "hair", "brown"))
    edited.apply(plan_draw_box(edited.tracks, 2, FRAMES + 1, (10.0, 20.0, 30.0, 60.0)))
    edited.apply(plan_mark_reviewed(edited.labels, 0, 5, 6))
    edited.apply(plan_verdict(edited.labels, Verdict("likely swap", (1, 2), 7, "dismissed")))
    edited.apply(plan_verdict(edited.labels, Verdict("likely ghost", (), 8, "right")))
    edited.apply(plan_label_part(edited.labels, PartLabel(3, 1, 0, (1.0, 2.0, 3.5, 4.0), None)))
    edited.apply(plan_label_part(edited.labels, PartLabel(3, 1, 1, (1.0, 2.0, 3.5, 4.0), False)))
    write_log_csv(edited.history, tmp_path / "log.csv")
    said = [(row["before"], row["after"]) for row in rows_of(tmp_path / "log.csv")]
    assert said[1] == ("track 3: no name", "track 3: name -red, coat")
    assert said[2] == ("track 3: no notes", "track 3: notes =HYPERLINK(1)")
    assert said[4][0].startswith("track 4: ")
    assert "boxes in frames" in said[4][0]
    assert [before for before, _ in said[6:]] == ["nothing"] * 6
    assert said[5] == ("track 3: no hair", "track 3: hair = brown")
    assert [after for _, after in said[6:]] == [
        "track 2: box 30.0 x 60.0 px at 10.0, 20.0 in frame 41",
        "everybody reviewed in frame 5",
        "likely swap of 1 and 2 in frame 7: dismissed",
        "likely ghost of nobody in frame 8: right",
        "head of 1 in frame 3: unsure",
        "torso of 1 in frame 3: off its part",
    ]


@pytest.mark.parametrize("name", ["=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\rx"])
def test_no_cell_is_a_formula(session: Session, tmp_path: Path, name: str) -> None:
    session.author = name
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    write_log_csv(session.history, tmp_path / "log.csv")
    for row in rows_of(tmp_path / "log.csv"):
        assert not any(cell.startswith(("=", "+", "-", "@", "\t", "\r")) for cell in row.values())


def test_json_has_all_rows_and_labels_of_both_sides(edited: Session, tmp_path: Path) -> None:
    edited.apply(plan_label_part(edited.labels, PartLabel(3, 1, 0, (1.0, 2.0, 3.5, 4.0), None)))
    write_log_json(edited.history, tmp_path / "log.json")
    log = json.loads((tmp_path / "log.json").read_text(encoding="utf-8"))
    assert [entry["taken_back_by"] for entry in log] == [4, None, None, None, None, None]
    assert (log[3]["undoes"], log[1]["abandoned"]) == (1, True)
    assert log[0]["before"]["stretches"][0] == {"track": 1, "start": 10, "end": 40}
    rows = log[4]["before"]["rows"]
    told = edited.history.entries[4].change.before.rows
    assert set(rows) == set(CORRECTED_COLUMNS)
    x = np.array([np.nan if value is None else value for value in rows["x"]])
    assert x.tobytes() == told["x"].tobytes()
    assert log[1]["after"]["labels"]["tracks"]["3"]["name"] == "-red, coat"
    (part,) = log[5]["after"]["labels"]["parts"]
    box = {"left": 1.0, "top": 2.0, "width": 3.5, "height": 4.0}
    told = {"frame": 3, "track": 1, "part": "head", "on_part": None, "source": "person"}
    assert part.items() >= {**told, **box}.items()
    assert (log[0]["scope"], log[4]["scope"]) == (
        {"start": 10, "end": None},
        {"start": 0, "end": 20},
    )


def test_an_empty_log_is_a_log(session: Session, tmp_path: Path) -> None:
    write_log_csv(session.history, tmp_path / "log.csv")
    write_log_json(session.history, tmp_path / "log.json")
    assert rows_of(tmp_path / "log.csv") == []
    assert json.loads((tmp_path / "log.json").read_text(encoding="utf-8")) == []


def test_progress_is_told(edited: Session, tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    write_log_csv(edited.history, tmp_path / "log.csv", lambda *step: told.append(step))
    assert told == [(1, 5), (2, 5), (3, 5), (4, 5), (5, 5)]


def test_a_damaged_line_does_not_hide_the_others(edited: Session, tmp_path: Path) -> None:
    path = edited.save()
    edited.close()
    with h5py.File(path, "a") as file:
        file["edits/before"][0] = "{"
    again = Session.open(path)
    write_log_csv(again.history, tmp_path / "log.csv")
    write_log_json(again.history, tmp_path / "log.json")
    again.close()
    assert "cannot be read" in rows_of(tmp_path / "log.csv")[0]["before"]
    log = json.loads((tmp_path / "log.json").read_text(encoding="utf-8"))
    assert ["problem" in entry for entry in log] == [True, False, False, False, False]


def test_what_fails_leaves_no_file(edited: Session, tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="cannot write"):
        write_log_csv(edited.history, tmp_path / "nowhere" / "log.csv")

    def stop(*_: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_log_json(edited.history, tmp_path / "log.json", stop)
    assert not list(tmp_path.glob("*log*"))


def test_the_log_is_read_while_the_session_is_open_elsewhere(edited: Session) -> None:
    assert edited.path is not None
    read = read_history(edited.path)
    assert [entry.text for entry in read] == [entry.text for entry in edited.history]
    edited.save()
    assert len(read_history(edited.path)) == 5
