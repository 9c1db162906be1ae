"""Tracks as CSV in and out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import table, through, tracks
from numpy.testing import assert_array_equal

from tracking.errors import FormatError
from tracking.formats import format_of
from tracking.formats.csv_tracks import CSV
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported
from tracking.tracks import CORRECTED_COLUMNS, TrackTable


def imported(folder: Path, text: str) -> Imported:
    path = folder / "t.csv"
    path.write_text(text, encoding="utf-8")
    assert CSV.read is not None
    return CSV.read(path, Filmed())


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=15
)
@given(tracks())
def test_every_column_comes_back_to_the_bit(tmp_path: Path, made: TrackTable) -> None:
    exported = Exported.of_table(made)
    back = through(CSV, tmp_path / "t.csv", exported)
    for name, column in made.columns().items():
        assert_array_equal(back.columns[name], column, err_msg=name)
        assert back.columns[name].dtype == column.dtype


def test_what_is_unknown_is_empty(tmp_path: Path) -> None:
    made = table([(4, 2)], [(1, -2.5, 3, 4)], source=[1])
    through(CSV, tmp_path / "t.csv", Exported.of_table(made))
    assert (tmp_path / "t.csv").read_text() == (
        "frame,track,left,top,width,height,x,y,vx,vy,confidence,visibility,predicted,source\n"
        "4,2,1,-2.5,3,4,,,,,,,0,1\n"
    )


@pytest.mark.parametrize(
    "text",
    [
        "frame,track,left,top,width,height\n3,1,1.5,2,3,4\n",
        "frame;track;left;top;width;height\r\n3;1;1,5;2;3;4\r\n",
        "﻿track\tframe\tleft\ttop\twidth\theight\n1\t3\t1.5\t2\t3\t4",
        '"Track";"Frame";"Left";"top";"width";"height"\n"1";"3";"1.5";"2";"3";"4"\n\n',
        " frame , track , left , top , width , height \n 3 , 1 , 1.5 , 2 , 3 , 4 \n",
    ],
)
def test_separators_decimal_signs_and_order_are_told_apart(tmp_path: Path, text: str) -> None:
    found = imported(tmp_path, text)
    assert format_of(tmp_path / "t.csv").name == "csv"
    row = [found.columns[name].tolist() for name in ("frame", "track", "left", "height", "x")]
    assert row[:4] == [[3], [1], [1.5], [4]]
    assert np.isnan(row[4]).all()
    assert found.bad_rows == ()


def test_other_columns_are_left_out_and_named(tmp_path: Path) -> None:
    found = imported(tmp_path, "frame,name,track,x,y\n1,bob,2,,\n2,eve,2,1,2,3\n")
    assert found.notes == ("columns that are left out: name",)
    assert found.columns["track"].tolist() == [2]
    assert [(row.place, row.reason) for row in found.bad_rows] == [
        ("line 3", "6 values where the header names 5")
    ]


def test_words_for_yes_and_no_are_read(tmp_path: Path) -> None:
    found = imported(tmp_path, 'frame,track,predicted\n1,2,True\n2,2, "FALSE"\n3,2,""\n')
    assert found.columns["predicted"].tolist() == [True, False, False]


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("1,1,nan,,0", "'nan' is not a number"),
        ("1,1,NaN,NaN,0", "'NaN' is not a number"),
        ("1,1,inf,0,0", "finite"),
        ("1,1,2,,0", "only one of x and y"),
        (",1,2,2,0", "frame or the id is not a finite number"),
        ("1.5,1,2,2,0", "whole"),
        ("-1,1,2,2,0", "frame number"),
        ("99999999999999999999,1,2,2,0", "frame number"),
        ("1,0,2,2,0", "id is not a positive"),
        ("1,1,2,2,7", "source is not 0, 1 or 2"),
        ("1,1,2e9,2,0", "farther than"),
        ("1,1,1_0,2,0", "'1_0' is not a number"),
        ("1 2,1,2,2,0", "'1 2' is not a number"),
        ('"1" "2",1,2,2,0', "is not a number"),
        ('1"2,1,2,2,0', "is not a number"),
        ("0,4true,2,2,0", "'4true' is not a number"),
        ("0,falsetrue,2,2,0", "'falsetrue' is not a number"),
        ("5,5,1,1,0", "twice"),
    ],
)
def test_a_bad_row_is_told_by_its_line(tmp_path: Path, row: str, reason: str) -> None:
    found = imported(tmp_path, f"frame,track,x,y,source\n5,5,1,1,0\n{row}\n6,5,1,1,0\n")
    assert len(found.columns["frame"]) == 2
    assert [bad.place for bad in found.bad_rows] == ["line 3"]
    assert reason in found.bad_rows[0].reason


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "no column 'frame'"),
        ("frame,x,y\n", "no column 'track'"),
        ("frame,track,x,x\n", "'x' stands there twice"),
        ("frame,track," + ",".join(f"c{n}" for n in range(300)), "far too many columns"),
        ("frame,track\na,b\n", "line 2: 'a' is not a number"),
    ],
)
def test_a_file_that_is_no_such_table_is_refused(tmp_path: Path, text: str, reason: str) -> None:
    with pytest.raises(FormatError, match=reason):
        imported(tmp_path, text)


def test_a_header_alone_is_a_table_without_rows(tmp_path: Path) -> None:
    found = imported(tmp_path, ",".join(CORRECTED_COLUMNS))
    assert len(found.columns["frame"]) == 0
