"""Words in CSV are never formulas, and come back as they were."""

from __future__ import annotations

import csv
import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.cells import CsvWriter, cell_of, text_of_cell


@pytest.mark.parametrize("text", ['=HYPERLINK("x")', "+1", "-1", "@SUM(A1)", "\t1", "\r1", "＝1"])
def test_a_formula_stands_behind_an_apostrophe(text: str) -> None:
    assert cell_of(text) == f"'{text}"


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("a;=HYPERLINK(1)", "a;'=HYPERLINK(1)"),
        ("a;;+1;b", "a;;'+1;b"),
        ("a\n=1\n-2", "a\n'=1\n'-2"),
        ("a\r\n@x", "a\r'\n'@x"),
        ('a;"=1', "a;'\"=1"),
        ("=1;=2", "'=1;'=2"),
        ("\t=1", "'\t'=1"),
        ("a;'=1", "a;''=1"),
    ],
)
def test_no_formula_stands_where_a_spreadsheet_parts_cells(text: str, cell: str) -> None:
    assert (cell_of(text), text_of_cell(cell)) == (cell, text)


@pytest.mark.parametrize("value", [-1, -0.5, "", "Gate -1", "'tis", "a=b", "a;b", "1;2", None])
def test_numbers_and_other_words_stay_as_they_are(value: object) -> None:
    assert cell_of(value) == value


@given(st.text(alphabet="'\"=+-@;\t\r\nab＝", max_size=8) | st.text())
def test_every_text_comes_back(text: str) -> None:
    cell = cell_of(text)
    assert isinstance(cell, str)
    for part in (cell, *cell.split(";")[1:], *cell.split("\n")[1:]):
        assert not part.startswith(("=", "+", "-", "@", "\t", "\r", "\n", "＝"))
    assert text_of_cell(cell) == text


@given(st.lists(st.text(alphabet='ab\r\n,"', max_size=6), min_size=1, max_size=4))
def test_no_letter_of_a_cell_ends_a_row(cells: list[str]) -> None:
    stream = io.StringIO(newline="")
    CsvWriter(stream).writerow(cells)
    text = stream.getvalue()
    quoted = text.split('"')[1::2]
    assert text.count("\r") == sum(part.count("\r") for part in quoted)
    assert text.count("\n") == sum(part.count("\n") for part in quoted) + 1
    assert list(csv.reader(io.StringIO(text, newline=""))) == [cells]
