"""Places on the floor as text: what PedPy loads, and what PeTrack exports."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pedpy
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import FLOOR, assert_same, known_rows, table, through, tracks

from tracking.errors import FormatError
from tracking.formats import Stated, format_of
from tracking.formats.floor_text import PEDPY_TEXT, PETRACK, import_floor_text
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_format import TrackFormat
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackTable

BOTH = pytest.mark.parametrize("format_", [PEDPY_TEXT, PETRACK], ids=lambda each: each.name)
WALK = table([(0, 3), (0, 5), (2, 3)], floor=[(1.5, 4.25), (-2, 7), (1.75, 4)])
HEADER = "# framerate: 25 fps\n# id frame x/m y/m z/m\n"


def exported(made: TrackTable = WALK, **known: Any) -> Exported:
    return Exported.of_table(made, **{"fps": 12.5, "name": "yard", **known})


def written(folder: Path, text: str) -> Path:
    path = folder / "tracks.txt"
    path.write_text(text, encoding="utf-8")
    return path


def read(folder: Path, text: str) -> Imported:
    return import_floor_text(written(folder, text), Filmed())


@BOTH
@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(made=tracks())
def test_who_has_a_place_comes_back(tmp_path: Path, format_: TrackFormat, made: TrackTable) -> None:
    placed = known_rows(made.columns(), "x")
    if not len(placed["frame"]):
        with pytest.raises(FormatError, match="nobody has a place"):
            through(format_, tmp_path / "t.txt", exported(made))
        return
    back = through(format_, tmp_path / "t.txt", exported(made))
    assert_same(back.columns, placed, FLOOR)
    assert np.isnan(back.columns["left"]).all()
    assert (back.fps, back.bad_count) == (12.5, 0)


NAMES = ["yard", "in cm", "Lobby in morning", "framerate 3", "x/cm", "# in centimetres", "", "a\nb"]


@BOTH
@pytest.mark.parametrize("name", NAMES)
def test_pedpy_loads_the_places_whatever_the_recording_is_called(
    tmp_path: Path, format_: TrackFormat, name: str
) -> None:
    through(format_, tmp_path / "t.txt", exported(name=name))
    loaded = pedpy.load_trajectory(trajectory_file=tmp_path / "t.txt")
    assert loaded.frame_rate == 12.5
    rows = loaded.data.sort_values(["id", "frame"])[["id", "frame", "x", "y"]]
    assert rows.to_numpy().tolist() == [[3, 0, 1.5, 4.25], [3, 2, 1.75, 4], [5, 0, -2, 7]]


def test_the_columns_are_the_last_comment_and_the_only_unit(tmp_path: Path) -> None:
    through(PEDPY_TEXT, tmp_path / "t.txt", exported(name="Lobby in morning"))
    lines = (tmp_path / "t.txt").read_text().splitlines()
    assert lines == [
        "# framerate: 12.5 fps",
        "# id frame x/m y/m z/m",
        "3 0 1.5 4.25 0",
        "5 0 -2 7 0",
        "3 2 1.75 4 0",
    ]


def test_petrack_has_one_person_after_the_other(tmp_path: Path) -> None:
    through(PETRACK, tmp_path / "t.txt", exported())
    assert (tmp_path / "t.txt").read_text().splitlines() == [
        "# PeTrack project: yard",
        "# raw trajectory file: ",
        "# framerate: 12.5 fps",
        "# z: can be 3d position or height of person (alternating or not)",
        "# id frame x/m y/m z/m",
        "3 0 1.5 4.25 0",
        "3 2 1.75 4 0",
        "5 0 -2 7 0",
    ]


def test_centimetres_and_further_columns_of_petrack_are_read(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        "# PeTrack project: a in m.pet\n# framerate: 25 fps\n#  1|walked in m\n"
        "# id frame x/cm y/cm z/cm viewDirX viewDirY markerID\n"
        "1 7   150 -20\t180 0.5 0.5 -1  \r\n\n1 8 151 -20 180 0 1 -1\n",
    )
    assert found.columns["frame"].tolist() == [7, 8]
    assert found.columns["x"].tolist() == [1.5, 1.51]
    assert found.columns["y"].tolist() == [-0.2, -0.2]
    assert found.fps == 25


@pytest.mark.parametrize(
    ("comments", "scale"),
    [
        ("# x/m", 1),
        ("#ID FR X/m Y/m", 1),
        ("#X,Y,Z: the agents coordinates in meters\n#ID FR X Y Z", 1),
        ("# in cm", 0.01),
        ("# coordinates in centimeters", 0.01),
        ("# x/cm\n# x/m", 1),
    ],
)
def test_the_last_unit_holds(tmp_path: Path, comments: str, scale: float) -> None:
    found = read(tmp_path, f"#framerate: 16\n{comments}\n1 0 200 100 0\n")
    assert found.columns["x"].tolist() == [200 * scale]
    assert found.fps == 16


@pytest.mark.parametrize("fps", ["0", "1e9"])
def test_an_invalid_frame_rate_is_told(tmp_path: Path, fps: str) -> None:
    found = read(tmp_path, HEADER.replace("25", fps) + "1 0 1 1 1\n")
    assert found.fps is None
    assert f"{fps} frames per second, which is invalid" in found.notes[0]


def test_what_says_no_unit_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="does not say its unit"):
        read(tmp_path, "# framerate: 25\n1 0 1 1 1\n")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("1 43 79.035 774.009 183.02\n1 44 79.1 764.5 183.02\n", "pedpy-txt"),
        ("1\t0\t2.15\t-2.66\n", "pedpy-txt"),
        ("# geometry: hall.xml\n\n# PersID Frame X Y Z\n1 0 2.15 2.66 1.7\n", "pedpy-txt"),
        ("# PeTrack project: hall.pet\n# id frame x y z\n1 0 215 266 170\n", "petrack"),
    ],
)
def test_a_text_without_a_unit_is_told_and_read_with_what_the_user_states(
    tmp_path: Path, text: str, name: str
) -> None:
    path = written(tmp_path, text)
    assert format_of(path).name == name
    with pytest.raises(FormatError, match="--unit m or --unit cm"):
        import_floor_text(path, Filmed())
    metres = import_floor_text(path, Filmed(stated=Stated("m")))
    found = import_floor_text(path, Filmed(stated=Stated("cm", 12.5)))
    np.testing.assert_allclose(found.columns["x"] * 100, metres.columns["x"])
    assert (found.fps, metres.fps, found.notes) == (12.5, None, ())


def test_what_a_text_says_itself_counts_and_that_is_noted(tmp_path: Path) -> None:
    path = written(tmp_path, f"{HEADER}1 0 5 5 1\n")
    found = import_floor_text(path, Filmed(stated=Stated("cm", 12.5)))
    assert (found.columns["x"].tolist(), found.fps) == ([5], 25)
    assert found.notes == (
        "the file says m itself; cm is passed over",
        "the file says 25 frames per second itself; 12.5 is passed over",
    )


@pytest.mark.parametrize(
    "text", ["1 0.5 0.5 0.1 0.2\n", "1 2\n3 4\n", "1 2 3 4 5 6 7 8 9 10\n", "a b c d\n", "# m\n"]
)
def test_other_rows_of_numbers_are_no_places(tmp_path: Path, text: str) -> None:
    with pytest.raises(FormatError, match="no format known here"):
        format_of(written(tmp_path, text))


@pytest.mark.parametrize(("unit", "fps"), [("ft", None), ("m", 0.0), ("m", -5.0), ("m", 1e9)])
def test_what_cannot_be_stated_is_refused(unit: str, fps: float | None) -> None:
    with pytest.raises(FormatError):
        Stated(unit, fps)


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("2 -1 1 1 1", "the frame number"),
        ("2 99999999999 1 1 1", "the frame number"),
        ("2 1.5 1 1 1", "whole numbers"),
        ("-2 1 1 1 1", "the id is not"),
        ("2 1 nan 1 1", "finite"),
        ("2 1 inf 1 1", "finite"),
        ("2 1 1e9 1 1", "farther than"),
        ("2 1 here 1 1", "not a number"),
        ("2 1 1 1", "4 values"),
        ("1 0 1 1 1", "stands twice"),
    ],
)
def test_a_bad_row_is_told_by_its_line(tmp_path: Path, row: str, reason: str) -> None:
    found = read(tmp_path, f"{HEADER}1 0 5 5 1\n\n# a comment\n{row}\n3 0 5 5 1\n")
    assert [bad.place for bad in found.bad_rows] == ["line 6"]
    assert reason in found.bad_rows[0].reason
    assert found.columns["track"].tolist() == [1, 3]


@pytest.mark.parametrize(
    ("text", "known"),
    [
        (HEADER + "1 0 1 1 1\n", True),
        (HEADER, True),
        ("# x/m\n\n1\t0\t1.5\t2\n", True),
        ("1 0 1 1 1\n", True),
        ("# a comment\n1 0 1 1 1\n", True),
        ("# a comment\n1 0.5 1 1 1\n", False),
        ("# a comment\n", False),
        ("# framerate: 25\n1,1,1,1,1,1\n", False),
        ("# framerate: 25\nname: x\n", False),
    ],
)
def test_it_is_told_by_comments_and_a_row(tmp_path: Path, text: str, known: bool) -> None:
    assert PEDPY_TEXT.recognises(tmp_path / "a.txt", text.encode()) is known
    assert not PETRACK.recognises(tmp_path / "a.txt", text.encode())
