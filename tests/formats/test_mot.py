"""MOT text in and out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from tracking.errors import FormatError, OutputError
from tracking.formats import format_named, format_of, read_mot, write_mot

BOX = ("left", "top", "width", "height")


def written(folder: Path, text: str) -> Path:
    path = folder / "tracks.txt"
    path.write_text(text, encoding="utf-8")
    return path


def test_frames_and_corners_are_shifted_to_zero(tmp_path: Path) -> None:
    columns = read_mot(written(tmp_path, "1,7,1,2,30,40,0.5,3.5,-4,0\n"))
    assert columns["frame"].tolist() == [0]
    assert columns["track"].tolist() == [7]
    assert [columns[name][0] for name in BOX] == [0, 1, 30, 40]
    assert [columns[name][0] for name in ("confidence", "x", "y", "z")] == [0.5, 3.5, -4, 0]


def test_minus_one_is_unknown(tmp_path: Path) -> None:
    columns = read_mot(written(tmp_path, "1,7,-1,-1,-1,-1,-1,-1,-1,-1\n"))
    assert all(np.isnan(columns[name][0]) for name in (*BOX, "confidence", "x", "y", "z"))


def test_a_single_minus_one_is_a_place(tmp_path: Path) -> None:
    columns = read_mot(written(tmp_path, "1,7,-1,5,10,10,1,-1,6,0\n"))
    assert columns["left"][0] == -2
    assert (columns["x"][0], columns["y"][0]) == (-1, 6)


@pytest.mark.parametrize("row", ["2,3,1,1,5,5", "2,3,1,1,5,5,0.9", "2,3,1,1,5,5,0.9,1,0.7"])
def test_shorter_rows_are_read_without_positions(tmp_path: Path, row: str) -> None:
    columns = read_mot(written(tmp_path, row + "\n"))
    assert columns["frame"].tolist() == [1]
    assert np.isnan([columns["x"][0], columns["y"][0], columns["z"][0]]).all()


def test_rows_are_sorted_by_frame_and_keep_their_order_within_it(tmp_path: Path) -> None:
    columns = read_mot(written(tmp_path, "2,9,1,1,5,5\n1,4,1,1,5,5\n2,3,1,1,5,5\n"))
    assert columns["track"].tolist() == [4, 9, 3]


def test_an_id_of_0_is_a_label_like_others(tmp_path: Path) -> None:
    columns = read_mot(written(tmp_path, "1,0,1,1,5,5\n1,7,9,9,5,5\n"))
    assert columns["track"].tolist() == [0, 7]


def test_lines_that_begin_with_a_hash_are_comments(tmp_path: Path) -> None:
    text = "# tracker 1.2\n#frame,id,left,top,width,height\n1,3,1,1,5,5\n# end\n2,3,1,1,5,5\n"
    path = written(tmp_path, text)
    assert format_of(path).name == "mot"
    assert read_mot(path)["frame"].tolist() == [0, 1]


def test_a_comment_may_stand_behind_a_row(tmp_path: Path) -> None:
    path = written(tmp_path, "1,3,1,1,5,5 # sure, at last\n2,3,1,1,5,5\n")
    assert format_of(path).name == "mot"
    assert read_mot(path)["frame"].tolist() == [0, 1]


@pytest.mark.parametrize("divider", [" ", "\t", ";", " ; "])
def test_rows_without_commas_are_told_to_want_them(tmp_path: Path, divider: str) -> None:
    path = written(tmp_path, divider.join("133456") + "\n")
    with pytest.raises(FormatError, match="wants them"):
        read_mot(path)
    with pytest.raises(FormatError, match="put commas between"):
        format_of(path)


def test_an_id_that_is_too_large_is_told_as_that(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="the id is too large"):
        read_mot(written(tmp_path, f"1,{2**40},1,1,5,5\n"))


@pytest.mark.parametrize("text", ["", "\n\n", "﻿"])
def test_an_empty_text_has_no_rows(tmp_path: Path, text: str) -> None:
    assert len(read_mot(written(tmp_path, text))["frame"]) == 0


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("1,1,1,1,5,5\n\n1,2,a,1,5,5\n", 3, "'a' is not a number"),
        ("1,1,1,1,5\n", 1, "5 values"),
        ("1,1,1,1,5,5\n1,2,1,1,5,5,1\n", 2, "7 values"),
        ("1,1,nan,1,5,5\n", 1, "finite"),
        ("1,1,1,inf,5,5\n", 1, "finite"),
        ("inf,1,1,1,5,5\n", 1, "finite"),
        ("1,1,1,1,5,5\n0,2,1,1,5,5\n", 2, "frame number"),
        ("-3,1,1,1,5,5\n", 1, "frame number"),
        ("99999999999,1,1,1,5,5\n", 1, "frame number"),
        ("1,-1,1,1,5,5\n", 1, "id is not 0 or a positive"),
        ("1,2147483648,1,1,5,5\n", 1, "id is too large"),
        ("# made by hand\n1,1,1,1,5\n", 2, "5 values"),
        ("1.5,1,1,1,5,5\n", 1, "whole numbers"),
        ("1,1,1,1,5e9,5\n", 1, "outside any image"),
        ("1,1,1,1,-5,5\n", 1, "negative size"),
        ("1,1,1,1,5,5\n2,1,1,1,5,5\n\n1,1,2,2,5,5\n", 4, "twice"),
        ("frame,id,left,top,width,height\n", 1, "'frame' is not a number"),
        ("format = 1\n", 1, "1 value;"),
    ],
)
def test_a_bad_row_is_told_by_its_line(tmp_path: Path, text: str, line: int, reason: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(FormatError) as told:
        read_mot(path)
    assert f"{path}, line {line}:" in str(told.value)
    assert reason in str(told.value)
    assert "\n" not in str(told.value)


def test_what_is_not_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    path.write_bytes(bytes(range(256)))
    with pytest.raises(FormatError, match="not text"):
        read_mot(path)


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=r"nowhere\.txt"):
        read_mot(tmp_path / "nowhere.txt")


def test_a_huge_file_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "huge.txt"
    with path.open("wb") as stream:
        stream.truncate((1 << 30) + 1)
    with pytest.raises(FormatError, match="larger than 1024 MB"):
        read_mot(path)


number = st.floats(-1e4, 1e4, allow_nan=False) | st.just(-1.0)
place = st.one_of(st.just((np.nan, np.nan, np.nan)), st.tuples(number, number, number))
box = st.one_of(
    st.just((np.nan,) * 4), st.tuples(number, number, st.floats(0, 1e4), st.floats(0, 1e4))
)
row = st.tuples(st.tuples(st.integers(0, 50), st.integers(1, 2**31 - 1)), box, place)


def as_columns(rows: list[Any]) -> dict[str, NDArray[Any]]:
    rows = sorted(rows, key=lambda row: row[0])
    boxes = np.array([row[1] for row in rows], np.float64).reshape(-1, 4)
    places = np.array([row[2] for row in rows], np.float64).reshape(-1, 3)
    return {
        "frame": np.array([row[0][0] for row in rows], np.int32),
        "track": np.array([row[0][1] for row in rows], np.int32),
        **dict(zip(BOX, boxes.T, strict=True)),
        **dict(zip("xyz", places.T, strict=True)),
    }


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=20)
@given(st.lists(row, max_size=8, unique_by=lambda row: row[0]))
def test_what_is_written_reads_back(tmp_path: Path, rows: list[Any]) -> None:
    columns = as_columns(rows)
    write_mot(tmp_path / "out.txt", columns)
    back = read_mot(tmp_path / "out.txt")
    for name in ("frame", "track"):
        assert_array_equal(back[name], columns[name])
    for name in (*BOX, "x", "y", "z"):
        assert_allclose(back[name], columns[name], rtol=0, atol=1e-9)


def test_ten_columns_are_written_from_one(tmp_path: Path) -> None:
    columns = as_columns([((0, 4), (0.0, 1.5, 10.0, 20.25), (np.nan,) * 3)])
    columns["confidence"] = np.array([0.9], np.float32)
    write_mot(tmp_path / "out.txt", columns)
    assert (tmp_path / "out.txt").read_text() == "1,4,1,2.5,10,20.25,0.9,-1,-1,-1\n"


def test_positions_without_a_height_are_on_the_floor(tmp_path: Path) -> None:
    columns = {"frame": np.arange(2), "track": np.array([1, 1])}
    columns |= {name: np.ones(2) for name in BOX}
    columns |= {"x": np.array([2.5, np.nan]), "y": np.array([4.0, np.nan])}
    write_mot(tmp_path / "out.txt", columns)
    rows = (tmp_path / "out.txt").read_text().splitlines()
    assert [row.split(",")[7:] for row in rows] == [["2.5", "4", "0"], ["-1", "-1", "-1"]]


def test_an_interrupted_write_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    path = written(tmp_path, "old")
    broken = as_columns([((0, 4), (0.0, 1.5, 10.0, 20.0), (np.nan,) * 3)])
    broken["left"] = np.array(["wide"])
    with pytest.raises(ValueError, match="wide"):
        write_mot(path, broken)
    assert path.read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["tracks.txt"]


def test_a_place_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    blocked = written(tmp_path, "a file, not a folder") / "out.txt"
    with pytest.raises(OutputError, match="cannot write"):
        write_mot(blocked, as_columns([]))


def test_a_folder_is_not_replaced_by_a_file(tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    with pytest.raises(OutputError, match="cannot write"):
        write_mot(tmp_path / "out", as_columns([]))
    assert [file.name for file in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("name", ["samples", "no-such"])
def test_a_format_that_is_not_there_is_told(name: str) -> None:
    with pytest.raises(FormatError, match=f"'{name}' is unknown"):
        format_named(name)


def test_the_public_pairs_can_be_read(shared_data: Path) -> None:
    columns = read_mot(shared_data / "scoring" / "TUD-Campus" / "truth.txt")
    assert len(columns["frame"]) == 359
    assert len(np.unique(columns["track"])) == 8
