"""The truth of body parts beside a recording is read with care, of parts and of who is seen."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.errors import FormatError
from tracking.scoring.parts import read_part_truth

PARTS = "frame,id,part,left,top,width,height,visible_pixels\n" + "".join(
    f"{frame},4,{part},1,2,3,4,9\n" for frame in (0, 1) for part in ("head", "torso", "hip_leg")
)
HEADER = "frame,id,visibility\n"


def beside(folder: Path, visibility: str) -> Path:
    (folder / "truth_parts.csv").write_text(PARTS, encoding="utf-8")
    (folder / "visibility.csv").write_text(visibility, encoding="utf-8")
    return folder


def test_who_is_not_named_is_not_seen(tmp_path: Path) -> None:
    truth = read_part_truth(beside(tmp_path, f"{HEADER}1,4,0.25\n0,9,1\n"), 2, (64, 48))
    assert truth.visibility.tolist() == [0.0, 0.25]
    truth = read_part_truth(beside(tmp_path, HEADER), 2, (64, 48))
    assert truth.visibility.tolist() == [0.0, 0.0]


@pytest.mark.parametrize(
    ("rows", "why"),
    [
        ("1,4,0.5\n0,4,1\n1,4,1\n", "line 4: line 2 gives the same person in the same frame"),
        ("1,4,1.5\n", "line 2: '1,4,1.5' is no visibility"),
        ("1,4\n", "line 2: '1,4' is no visibility"),
        ("-1,4,1\n", "line 2: '-1,4,1' is no visibility"),
    ],
)
def test_what_is_no_visibility_is_refused_by_its_line(tmp_path: Path, rows: str, why: str) -> None:
    with pytest.raises(FormatError, match=why) as told:
        read_part_truth(beside(tmp_path, HEADER + rows), 2, (64, 48))
    assert "visibility.csv" in str(told.value)


def test_a_table_larger_than_any_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = beside(tmp_path, HEADER + "0,4,1\n" * 50)
    monkeypatch.setattr("tracking.truth.table.MOST_BYTES", len(PARTS) + 20)
    with pytest.raises(FormatError, match=r"visibility\.csv has"):
        read_part_truth(folder, 2, (64, 48))
