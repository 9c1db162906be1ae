"""PeTrack's own files."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.errors import FormatError
from tracking.formats import format_of
from tracking.formats.petrack_trc import import_trc
from tracking.formats.read_result import Filmed, Imported
from tracking.tracks import TrackLabel

STEREO = "-1 -1 -1 "
PERSON = "0 -100000 4 5 1 -1 -1 -1"


def of_version(version: int, comment: str = "") -> str:
    """A person of two points from frame 4 on, as that version has them."""
    stereo = STEREO if version > 1 else ""
    marker = " -1" if version > 2 else ""
    head = f"{PERSON}{' -1' if version > 3 else ''} 2\n"
    head += f"{comment}\n" if version > 2 else ""
    first = f"version {version}\n" if version > 1 else ""
    points = "".join(f"{x} 20.5 {stereo}100 0 0 -1 -1 -1{marker}\n" for x in (10, 11))
    return f"{first}1\n{head}{points}\n"


def imported(folder: Path, text: str) -> Imported:
    path = folder / "t.trc"
    path.write_text(text, encoding="utf-8")
    return import_trc(path, Filmed())


@pytest.mark.parametrize("version", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_every_version_is_told_by_content_and_read(tmp_path: Path, version: int, end: str) -> None:
    found = imported(tmp_path, of_version(version).replace("\n", end))
    assert format_of(tmp_path / "t.trc").name == "petrack-trc"
    assert found.columns["frame"].tolist() == [4, 5]
    assert found.columns["left"].tolist() == [10, 11]
    assert found.columns["top"].tolist() == [20.5, 20.5]
    assert found.bad_count == 0
    assert "no size" in found.notes[0]


def test_a_comment_that_looks_like_a_person_is_one(tmp_path: Path) -> None:
    found = imported(tmp_path, of_version(5, f"{PERSON} -1 7"))
    assert found.labels == {1: TrackLabel(attributes={"comment": f"{PERSON} -1 7"})}
    assert len(found.columns["frame"]) == 2


def test_an_invalid_point_is_told_and_those_after_it_keep_their_frames(tmp_path: Path) -> None:
    text = of_version(5).replace("10 20.5", "nan 20.5")
    found = imported(tmp_path, text)
    assert found.columns["frame"].tolist() == [5]
    assert [bad.place for bad in found.bad_rows] == ["line 5"]


def test_points_set_by_a_person_are_as_sure_as_can_be(tmp_path: Path) -> None:
    found = imported(tmp_path, of_version(5).replace("100 0 0", "110 0 0", 1))
    assert found.columns["confidence"].tolist() == [1, 1]
    worse = imported(tmp_path, of_version(5).replace("100 0 0", "-1 0 0", 1))
    assert "quality" in worse.bad_rows[0].reason


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("version 5", "version 6", "is of version 6; versions 1 to 5 are read"),
        ("5\n1\n", "5\n2\n", "is cut short: it ends within person 1 of 2"),
        ("5\n1\n", "5\n0\n", "more than the 0 people"),
        (" -1 2\n", " -1 3\n", "ends within person 1"),
        (" -1 2\n", " -1 1\n", "more than the 1 people"),
        (" -1 2\n", " 2\n", "9 values where a person has 10"),
        (" -1 2\n", " -1 0\n", "0 points from frame 4"),
        ("100000 4 5", "100000 four 5", "not all numbers"),
    ],
)
def test_a_file_that_says_otherwise_than_it_holds_is_refused(
    tmp_path: Path, old: str, new: str, reason: str
) -> None:
    text = of_version(5)
    assert old in text
    with pytest.raises(FormatError, match=reason) as told:
        imported(tmp_path, text.replace(old, new))
    assert "\n" not in str(told.value)
