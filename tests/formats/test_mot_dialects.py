"""The dialects of MOT text, and what stands beside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, FLOOR, assert_same, table, through, tracks

from tracking.errors import FormatError
from tracking.formats import TrackFormat, format_of, read_mot
from tracking.formats.mot import MOT, MOT16, import_mot
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported, no_progress
from tracking.tracks import TrackLabel, TrackTable

TWO = table([(0, 3), (4, 7)], [(0, 1.5, 10, 20), (-2, 0, 5, 5)], [(np.nan,) * 2, (1, -1)])


def imported(folder: Path, text: str) -> Imported:
    path = folder / "gt.txt"
    path.write_text(text, encoding="utf-8")
    return import_mot(path, Filmed())


def quick(test: object) -> object:
    return settings(
        suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
    )(test)


@quick
@given(tracks())
def test_boxes_and_places_come_back_from_world_columns(tmp_path: Path, made: TrackTable) -> None:
    if len(made):
        back = through(MOT, tmp_path / "t.txt", Exported.of_table(made))
        assert_same(back.columns, made.columns(), (*BOX, *FLOOR))


@quick
@given(tracks())
def test_boxes_come_back_from_rows_with_classes(tmp_path: Path, made: TrackTable) -> None:
    if len(made):
        back = through(MOT16, tmp_path / "t.txt", Exported.of_table(made))
        assert_same(back.columns, made.columns(), BOX)
        assert np.isnan(back.columns["x"]).all()
        assert back.labels == {}


def test_world_columns_byte_for_byte(tmp_path: Path) -> None:
    MOT.write(tmp_path / "t.txt", Exported.of_table(TWO, ground_truth=True), no_progress)  # type: ignore[misc] # it writes
    assert (tmp_path / "t.txt").read_bytes() == (
        b"1,3,1,2.5,10,20,1,-1,-1,-1\n5,7,-1,1,5,5,1,1,-0.9999999999999999,0\n"
    )


def test_classes_and_visibility_byte_for_byte(tmp_path: Path) -> None:
    seen = table([(0, 3), (0, 9), (1, 3)], [(0, 0, 5, 5)] * 3, visibility=[0.25, 1.0, np.nan])
    labels = {9: TrackLabel(attributes={"class": "car"})}
    exported = Exported.of_table(seen, labels=labels, ground_truth=True)
    MOT16.write(tmp_path / "t.txt", exported, no_progress)  # type: ignore[misc] # it writes
    assert (tmp_path / "t.txt").read_bytes() == (
        b"1,3,1,1,5,5,1,1,0.25\n1,9,1,1,5,5,0,3,1\n2,3,1,1,5,5,1,1,1\n"
    )


def test_classes_become_labels_and_rows_that_do_not_count_keep_that(tmp_path: Path) -> None:
    found = imported(tmp_path, "1,1,1,1,5,5,1,1,0.5\n1,2,1,1,5,5,0,12,1\n1,3,1,1,5,5,0,77,1\n")
    assert found.labels == {
        2: TrackLabel(attributes={"class": "reflection"}),
        3: TrackLabel(attributes={"class": "class 77"}),
    }
    assert found.columns["confidence"].tolist() == [1, 0, 0]
    assert found.columns["visibility"].tolist() == [0.5, 1, 1]


def test_classes_survive_writing_and_reading(tmp_path: Path) -> None:
    labels = {3: TrackLabel(attributes={"class": "Car"}), 7: TrackLabel(name="red coat")}
    back = through(MOT16, tmp_path / "t.txt", Exported.of_table(TWO, labels=labels))
    assert back.labels == {3: TrackLabel(attributes={"class": "car"})}


def test_scoring_reads_the_class_and_the_visibility(tmp_path: Path) -> None:
    path = tmp_path / "gt.txt"
    path.write_text("1,1,1,1,5,5,1,8,0.5\n")
    columns = read_mot(path)
    assert (columns["class"].tolist(), columns["visibility"].tolist()) == ([8], [0.5])


@pytest.mark.parametrize(
    ("row", "name"),
    [
        ("1,1,1,1,5,5", "mot"),
        ("1,-1,1,1,5,5,0.5,-1,-1,-1", "mot"),
        ("1.0, 2, -3.5, 4e1, 5, 6, 1", "mot"),
        ("1,1,1,1,5,5,1,1", "mot16"),
        ("﻿1,1,1,1,5,5,1,1,0.8", "mot16"),
    ],
)
def test_the_dialect_is_told_by_the_first_row(tmp_path: Path, row: str, name: str) -> None:
    path = tmp_path / "any.name"
    path.write_text(row + "\n", encoding="utf-8")
    assert format_of(path).name == name


def test_good_rows_are_kept_and_each_bad_one_is_told_by_its_line(tmp_path: Path) -> None:
    found = imported(
        tmp_path,
        "1,1,1,1,5,5,1\n\n1,1,2,2,5,5,1\n1,x,1,1,5,5,1\n1,2,1,1\n-4,2,1,1,5,5,1\n"
        "1,4,1,1,-5,5,1\n1,5,nan,1,5,5,1\n2,1,1,1,5,5,1\n",
    )
    assert found.columns["frame"].tolist() == [0, 1]
    assert found.bad_count == 6
    told = {row.place: row.reason for row in found.bad_rows}
    assert told.keys() == {f"line {line}" for line in (3, 4, 5, 6, 7, 8)}
    assert "twice" in told["line 3"]
    assert "'x' is not a number" in told["line 4"]
    assert "4 values" in told["line 5"]


def test_a_sequence_s_description_is_read_from_beside_its_folder(tmp_path: Path) -> None:
    (tmp_path / "gt").mkdir()
    (tmp_path / "seqinfo.ini").write_text(
        "[Sequence]\nname=A\nframeRate=12.5\nseqLength=40\nimWidth=640\nimHeight=480\n"
    )
    found = imported(tmp_path / "gt", "1,1,1,1,5,5,1\n")
    assert (found.fps, found.frames, found.size_px) == (12.5, 40, (640, 480))


@pytest.mark.parametrize(
    "text", ["", "frameRate=3", "[Sequence]\nframeRate=many", "[Sequence]\nseqLength=-1", "\0"]
)
def test_a_description_that_cannot_be_read_is_noted(tmp_path: Path, text: str) -> None:
    (tmp_path / "seqinfo.ini").write_text(text)
    found = imported(tmp_path, "1,1,1,1,5,5,1\n")
    assert (found.fps, found.frames, found.size_px) == (None, None, None)
    assert "seqinfo.ini is left out" in found.notes[0]
    assert "\n" not in found.notes[0]


def test_the_challenge_s_folders_get_a_description_and_others_do_not(tmp_path: Path) -> None:
    (tmp_path / "lobby" / "gt").mkdir(parents=True)
    exported = Exported.of_table(TWO, frames=50, fps=12.5, size_px=(640, 480), name="lobby 3")
    made = MOT16.write(tmp_path / "lobby" / "gt" / "gt.txt", exported, no_progress)  # type: ignore[misc] # it writes
    assert made[1] == tmp_path / "lobby" / "seqinfo.ini"
    assert made[1].read_text() == (
        "[Sequence]\nname=lobby 3\nimDir=img1\nframeRate=12.5\nseqLength=50\n"
        "imWidth=640\nimHeight=480\nimExt=.jpg\n"
    )
    assert MOT.write(tmp_path / "t.txt", exported, no_progress) == (tmp_path / "t.txt",)  # type: ignore[misc] # it writes
    back = import_mot(made[0], Filmed())
    assert (back.fps, back.frames, back.size_px) == (12.5, 50, (640, 480))


def test_a_description_that_is_there_stays(tmp_path: Path) -> None:
    (tmp_path / "gt").mkdir()
    (tmp_path / "seqinfo.ini").write_text("[Sequence]\nname=MOT17-02\n")
    assert MOT.write is not None
    made = MOT.write(tmp_path / "gt" / "gt.txt", Exported.of_table(TWO), no_progress)
    assert made == (tmp_path / "gt" / "gt.txt",)
    assert (tmp_path / "seqinfo.ini").read_text() == "[Sequence]\nname=MOT17-02\n"


@pytest.mark.parametrize(
    ("first", "others", "known"),
    [
        ("1,1,ten,10,20,50,1,-1,-1,-1", "2,1,9,9,20,50,1,-1,-1,-1", MOT),
        ("1,1,,10,20,50,1,1,1", "2,1,9,9,20,50,1,1,1", MOT16),
        ("1,1,ten,10,20,50,1,-1,-1,-1", "2,1,two,10,20,50,1,-1,-1,-1\n" * 3, MOT),
        ("1;1", "2,1,9,9,20,50,1,-1,-1,-1\n" * 3, None),
    ],
)
def test_a_text_with_a_bad_first_row_is_known_by_its_other_rows(
    tmp_path: Path, first: str, others: str, known: TrackFormat | None
) -> None:
    path = tmp_path / "gt.txt"
    path.write_text(f"{first}\n{others}\n")
    if known is None:
        with pytest.raises(FormatError, match="no format known"):
            format_of(path)
    else:
        assert format_of(path) is known


def test_a_bad_first_row_is_told_with_line_and_reason(tmp_path: Path) -> None:
    found = imported(tmp_path, "1,1,ten,10,20,50,1\n2,1,9,9,20,50,1\n")
    assert [(row.place, row.reason) for row in found.bad_rows] == [
        ("line 1", "'ten' is not a number")
    ]
    assert found.columns["frame"].tolist() == [1]


def test_a_text_whose_ids_are_all_none_is_told_as_detections_and_how_to_use_them(
    tmp_path: Path,
) -> None:
    text = "".join(f"{frame},-1,10,20,30,60,0.9,-1,-1,-1\n" for frame in range(1, 4000))
    with pytest.raises(FormatError, match="detections of a detector") as told:
        imported(tmp_path, text)
    assert "--detections" in str(told.value)
