"""Labels in the session file: back as they were, of older files too, and never nonsense."""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import make_session, state_of

from tracking.editing import (
    plan_label_part,
    plan_lines,
    plan_mark_reviewed,
    plan_occluders,
    plan_regions,
    plan_rename,
    plan_swap,
    plan_verdict,
)
from tracking.errors import SessionError
from tracking.session import Session
from tracking.session.session_writer import companions
from tracking.tracks import CountingLine, Labels, Occluder, PartLabel, Region, Verdict

BOX = (10.25, 20.5, 0.1, 1e-3)
PARTS = (
    PartLabel(3, 2, 0, BOX, True, "person"),
    PartLabel(3, 2, 1, BOX, False, "tracker"),
    PartLabel(3, 2, 2, BOX, None, "truth"),
    PartLabel(700, 1, 0, BOX, None, "person", "José", "the score is near the threshold"),
)


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session with every kind of label, closed."""
    session = make_session(tmp_path_factory.mktemp("good"))
    corners = ((0.0, 0.1), (5.0, 1 / 3), (5.0, 90.0))
    for plan in (
        lambda labels: plan_rename(session.tracks, labels, 2, "赤いコート"),
        lambda labels: plan_occluders(labels, [Occluder("pillar", corners)]),
        lambda labels: plan_lines(labels, [CountingLine("door", (0.1, 0.2), (3.0, 0.2))]),
        lambda labels: plan_regions(labels, [Region("hall", corners)]),
        lambda labels: plan_mark_reviewed(labels, (1, 3), 5, 9),
        lambda labels: plan_verdict(labels, Verdict("crossing", (1, 2), 7, "dismissed")),
        lambda labels: plan_label_part(labels, PARTS),
    ):
        session.apply(plan(session.labels))
    path = session.save()
    session.close()
    return path


@pytest.fixture
def copy(good: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(good, tmp_path / "s.h5"))


def test_every_kind_of_label_comes_back(copy: Path) -> None:
    session = Session.open(copy)
    labels = session.labels
    session.close()
    assert tuple(labels.parts.values()) == PARTS
    assert labels.lines[0].start == (0.1, 0.2)
    assert labels.regions[0].polygon[1] == (5.0, 1 / 3)
    assert labels.occluders[0].name == "pillar"
    assert [seen.track for seen in labels.reviewed] == [1, 3]
    assert labels.verdicts["crossing", (1, 2), 7].decision == "dismissed"
    assert labels.of_track(2).name == "赤いコート"


def test_labels_can_be_undone_after_reopening(copy: Path) -> None:
    session = Session.open(copy)
    after = session.labels
    while session.history.next_undo:
        session.undo()
    assert session.labels == Labels()
    while session.history.next_redo:
        session.redo()
    assert session.labels == after
    session.close()


def test_on_part_says_yes_and_sure_tells_no_from_unsure(copy: Path) -> None:
    with h5py.File(copy) as file:
        assert file["labels/parts/on_part"][()].tolist() == [True, False, False, False]
        assert file["labels/parts/sure"][()].tolist() == [True, True, False, False]
        assert file["labels/parts/source"][()].tolist() == [1, 0, 2, 1]


def test_part_labels_of_format_1_1_have_no_author(copy: Path) -> None:
    with h5py.File(copy, "a") as file:
        file.attrs["format_version"] = "1.1"
        del file["labels/parts/author"], file["labels/parts/reason"]
    session = Session.open(copy)
    labels = session.labels.parts
    session.close()
    assert tuple(labels.values()) == tuple(replace(label, author="", reason="") for label in PARTS)


def test_a_table_with_authors_but_no_reasons_is_refused(copy: Path) -> None:
    with h5py.File(copy, "a") as file:
        del file["labels/parts/reason"]
    with pytest.raises(SessionError, match="no column reason in labels/parts"):
        Session.open(copy)


def as_format_1_0(path: Path) -> Path:
    """The file as a program of format 1.0 would have written it, had it known no newer labels."""
    with h5py.File(path, "a") as file:
        file.attrs["format_version"] = "1.0"
        for name in ("labels/lines", "labels/regions", "labels/verdicts", "edits/touched"):
            del file[name]
        del file["edits/undoes"], file["labels/parts"], file["runs/0/signals"]
        parts = file.create_group("labels/parts")
        for name, dtype in (
            *(("frame", np.int32), ("track", np.int32), ("part", np.uint8)),
            ("on_part", np.bool_),
        ):
            parts.create_dataset(name, data=np.zeros(0, dtype))
    return path


@pytest.fixture
def older(tmp_path: Path) -> Path:
    """A small session of format 1.0 with an edit and labels in the log as it had them."""
    session = make_session(tmp_path)
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.apply(plan_mark_reviewed(session.labels, 0, 0, 5))
    session.apply(plan_mark_reviewed(session.labels, 0, 20, 30))
    path = session.save()
    session.close()
    with h5py.File(as_format_1_0(path), "a") as file:  # it named all ranges on both sides
        before, after = file["edits/before"], file["edits/after"]
        before[2] = json.dumps({"labels": {"reviewed": [[0, 0, 5]]}})
        after[2] = json.dumps({"labels": {"reviewed": [[0, 0, 5], [0, 20, 30]]}})
        before[1] = json.dumps({"labels": {"reviewed": []}})
    return path


def test_a_session_of_format_1_0_is_read_edited_and_saved_as_newer(older: Path) -> None:
    session = Session.open(older)
    assert not session.read_only
    assert [(seen.start, seen.end) for seen in session.labels.reviewed] == [(0, 5), (20, 30)]
    session.undo()
    assert [(seen.start, seen.end) for seen in session.labels.reviewed] == [(0, 5)]
    session.redo()
    session.undo_alone(2)
    assert [(seen.start, seen.end) for seen in session.labels.reviewed] == [(20, 30)]
    after = state_of(session)
    session.save()
    session.close()
    again = Session.open(older)
    assert state_of(again) == after
    assert again.history.taken_back_by(2) == 4
    again.close()
    with h5py.File(older) as file:
        assert file.attrs["format_version"] == "1.8"


def test_edits_waiting_in_a_journal_of_format_1_0_come_back(older: Path) -> None:
    session = Session.open(older)
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    after = state_of(session)
    session.close()
    base = sqlite3.connect(companions(older) / "journal.sqlite")
    for column in ("message", "checksum", "scope", "undoes"):
        base.execute(f"ALTER TABLE steps DROP COLUMN {column}")
    base.close()
    again = Session.open(older)
    assert (again.recovered, state_of(again)) == (1, after)
    again.undo_alone(4)
    again.close()


def set_column(name: str, values: list[object]) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        file[name][...] = values

    return spoil


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (set_column("labels/parts/part", [9, 0, 0, 0]), "part 9 is none"),
        (set_column("labels/parts/source", [7, 0, 0, 0]), "source is 7"),
        (set_column("labels/parts/width", [np.nan, 1, 1, 1]), "box"),
        (set_column("labels/parts/track", [-1, 2, 2, 1]), "track -1"),
        (set_column("labels/parts/part", [0, 0, 0, 0]), "labelled twice"),
        (set_column("labels/lines/x1", [np.inf]), "corner"),
        (set_column("labels/lines/name", [""]), "needs a name"),
        (set_column("labels/regions/polygon", ["[[0, 0], [1, 1], [1, 0], [0, 1]]"]), "cross"),
        (set_column("labels/regions/polygon", ["[[0, 0], [1, 1]]"]), "three or more"),
        (set_column("labels/regions/polygon", ["[" * 100_000]), "damaged"),
        (set_column("labels/regions/polygon", [json.dumps([[0, 1]] * 9999)]), "9999 corners"),
        (set_column("labels/occluders/polygon", ["[[0, 0], [1, NaN], [1, 0]]"]), "no place"),
        (set_column("labels/verdicts/decision", ["maybe"]), "decision 'maybe'"),
        (set_column("labels/verdicts/tracks", ["[[1]]"]), "damaged"),
        (set_column("labels/reviewed/end", [0, 0]), "range is empty"),
        (set_column("edits/undoes", [0, 0, 0, 0, 7, 0, 0]), "undoes a later one"),
        (lambda file: file.__delitem__("labels/parts/left"), "no column left in labels/parts"),
        (lambda file: file.__delitem__("labels/lines/x1"), "no column x1 in labels/lines"),
    ],
)
def test_labels_that_nobody_gave_are_refused(
    copy: Path, spoil: Callable[[h5py.File], None], why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with h5py.File(copy, "a") as file:
        spoil(file)
    monkeypatch.setattr("tracking.session.session_reader.check_file", looked_over)
    with pytest.raises(SessionError, match=why) as told:
        Session.open(copy)
    assert str(copy) in str(told.value)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    ("column", "value"), [("edit", 99), ("kind", 11), ("of", -1), ("start", 2**40), ("end", -1)]
)
def test_what_edits_touch_is_worked_out_where_the_file_says_nonsense(
    copy: Path, column: str, value: int
) -> None:
    session = Session.open(copy)
    told, why = session.history.touches, session.history.why_not_alone(1)
    session.close()
    with h5py.File(copy, "a") as file:
        file[f"edits/touched/{column}"][1] = value
    again = Session.open(copy)
    for name, numbers in again.history.touches.items():
        assert numbers.tolist() == told[name].tolist()
    assert again.history.why_not_alone(1) == why
    again.close()


def looked_over(path: Path) -> tuple[int, int]:
    from tracking.session.inspection import Refused, inspect

    try:
        return inspect(path)
    except Refused as why:
        raise SessionError(f"{path} {why}") from why
