"""VIAME's CSV in and out."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_tracks import BOX, assert_same, known_rows, table, through, tracks

from tracking.errors import FormatError
from tracking.formats import format_of
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported
from tracking.formats.viame import VIAME, import_viame
from tracking.formats.viame_class import cell_of_class, class_of_cell
from tracking.tracks import TrackLabel, TrackTable

GOOD = "3,a.png,0,10,20,40,60,0.5,-1,person,0.5"


def imported(folder: Path, *lines: str) -> Imported:
    path = folder / "t.csv"
    path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    return import_viame(path, Filmed())


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_what_has_a_box_comes_back(tmp_path: Path, made: TrackTable) -> None:
    boxed = known_rows(made.columns(), "left")
    exported = Exported.of_table(made, frames=41, fps=12.5, name="a")
    if not len(boxed["frame"]):
        with pytest.raises(FormatError, match="nobody has a box"):
            through(VIAME, tmp_path / "t.csv", exported)
        return
    back = through(VIAME, tmp_path / "t.csv", exported)
    assert_same(back.columns, boxed, BOX)
    assert back.fps == 12.5


def test_names_attributes_confidence_and_who_is_hidden_travel(tmp_path: Path) -> None:
    made = table([(0, 3), (0, 8), (7, 3)], [(1, 2, 3, 4)] * 3, visibility=[1, 0.2, 1])
    rows = {**made.columns(), "confidence": np.array([0.59, 0.25, 0], np.float32)}
    labels = {
        3: TrackLabel('Zoë, "Z"', {"hand_bag": "yes, red"}),
        8: TrackLabel(attributes={"class": "dog, small"}),
    }
    back = through(
        VIAME, tmp_path / "t.csv", Exported(rows, frames=9, labels=labels, dont_cares=True)
    )
    assert back.labels == labels
    np.testing.assert_array_equal(back.columns["confidence"], rows["confidence"])
    assert back.columns["visibility"].tolist() == [1, 0, 1]
    assert back.fps is None


@pytest.mark.parametrize(
    "text",
    [
        f"{GOOD}\n",
        f"# a comment\n\n{GOOD}\n",
        "# 1: Detection or Track-id,  2: Video or Image Identifier\n",
        '"# 1: Detection or Track-id","2: Video"\n',
        f"# metadata,fps: 5\n{GOOD}\n",
        "3,,0,10,20,40,60,1,-1\n",
        "3,00:00:01.5,0,10.5,-2e1,40,60,1,-1,person,1\n",
    ],
)
def test_the_format_is_told_by_content(tmp_path: Path, text: str) -> None:
    path = tmp_path / "any"
    path.write_text(text)
    assert format_of(path).name == "viame"


def test_mot_text_is_none_of_it(tmp_path: Path) -> None:
    path = tmp_path / "any"
    path.write_text("1,3,10,20,30,40,1,-1,-1,-1\n")
    assert format_of(path).name == "mot"


def test_the_class_of_a_track_is_the_likeliest_of_its_last_line(tmp_path: Path) -> None:
    found = imported(
        tmp_path,
        GOOD,
        "3,a.png,1,10,20,40,60,-1,-1,cat,0.25,dog,0.75",
        "3,a.png,2,10,20,40,60,,-1",
    )
    assert found.labels == {3: TrackLabel(attributes={"class": "dog"})}
    np.testing.assert_array_equal(
        found.columns["confidence"], np.array([0.5, 0.75, np.nan], np.float32)
    )


def test_what_belongs_to_single_frames_is_left_out_and_told(tmp_path: Path) -> None:
    found = imported(
        tmp_path, f"{GOOD},(atr) pose bent,(poly) 1 2 3 4 5 6,(note) hm,(trk-atr) bag yes"
    )
    assert found.labels == {3: TrackLabel(attributes={"bag": "yes"})}
    assert "(poly)" in found.notes[0]
    assert np.isnan(found.columns["visibility"]).all()


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("1,2,3", "3 values"),
        ('3,"a,0,10,20,40,60,0.5,-1', "quotes"),
        ("x,a,0,10,20,40,60,0.5,-1", "whole number"),
        ("3,a,-1,10,20,40,60,0.5,-1", "whole number"),
        ("3,a,1,10,nan,40,60,0.5,-1", "four numbers"),
        ("3,a,1,10,1_0,40,60,0.5,-1", "four numbers"),
        ("3,a,1,40,20,10,60,0.5,-1", "negative size"),
        ("3,a,1,10,20,40,60,high,-1", "confidence"),
        ("3,a,1,10,20,40,60,-0.5,-1", "confidence is -0.5, below 0"),
        ("3,a,1,10,20,40,60,0.5,-1,person", "class has no confidence"),
        ("3,a,99999999,10,20,40,60,0.5,-1", "frame number"),
        (GOOD, "its id stands twice"),
    ],
)
def test_an_invalid_line_is_told(tmp_path: Path, line: str, reason: str) -> None:
    found = imported(tmp_path, "# metadata, fps: 8", GOOD, line)
    assert (found.fps, found.columns["frame"].tolist()) == (8, [0])
    (bad,) = found.bad_rows
    assert bad.place == "line 3"
    assert reason in bad.reason


def test_times_count_on_after_a_day(tmp_path: Path) -> None:
    made = table([(0, 3), (90_061, 3)], [(1, 2, 3, 4)] * 2)
    through(VIAME, tmp_path / "t.csv", Exported.of_table(made, fps=1.0))
    *_, first, last = (tmp_path / "t.csv").read_text().splitlines()
    assert [line.split(",")[1] for line in (first, last)] == ["00:00:00.000000", "25:01:01.000000"]


@pytest.mark.parametrize("kind", ['=HYPERLINK("https://example.org")', "@SUM(A1)", "-1", "'=a"])
def test_a_class_is_no_formula_and_comes_back(tmp_path: Path, kind: str) -> None:
    labels = {3: TrackLabel("=1+1", {"class": kind, "bag": "=2"})}
    made = table([(0, 3)], [(1, 2, 3, 4)])
    back = through(VIAME, tmp_path / "t.csv", Exported.of_table(made, labels=labels))
    assert back.labels == labels
    with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as stream:
        cells = list(csv.reader(stream))[-1]
    assert cells[9] == f"'{kind}"
    assert not [cell for cell in cells if cell.startswith(("=", "+", "@"))]


@pytest.mark.parametrize("kind", ["(", "(dog) big", "'(dog", "(a;=1", "a;=HYPERLINK(1)"])
def test_a_class_is_no_attribute_and_comes_back(tmp_path: Path, kind: str) -> None:
    labels = {3: TrackLabel("a;=1", {"class": kind, "(bag)": "b;'=2"})}
    made = table([(0, 3)], [(1, 2, 3, 4)])
    back = through(VIAME, tmp_path / "t.csv", Exported.of_table(made, labels=labels))
    assert back.labels == labels
    assert ";=" not in (tmp_path / "t.csv").read_text("utf-8")


@given(st.text(alphabet="()'=;a -\"", min_size=1, max_size=8))
def test_every_class_comes_back(name: str) -> None:
    cell = cell_of_class(name)
    assert not cell.startswith("(")
    assert class_of_cell(cell) == name


def test_other_classes_stand_as_they_are(tmp_path: Path) -> None:
    labels = {3: TrackLabel(attributes={"class": "dog-like"})}
    made = table([(0, 3)], [(1, 2, 3, 4)])
    through(VIAME, tmp_path / "t.csv", Exported.of_table(made, labels=labels))
    assert ",-1,dog-like," in (tmp_path / "t.csv").read_text()
