"""Text files nobody means well with: refused at once, in a line."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.pace import spent
from tracking.errors import CancelledError, FormatError
from tracking.formats import FORMATS, format_of, read_mot
from tracking.formats.line_survey import LONGEST_LINE
from tracking.formats.read_result import FEW_BAD, MOST_TOLD, Filmed, Imported
from tracking.formats.row_rules import MAX_FRAME

MOT_ROW = b"1,1,1,1,5,5\n"
KITTI_ROW = b"0 1 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10\n"


def imported(folder: Path, data: bytes, name: str) -> Imported:
    path = folder / "tracks.txt"
    path.write_bytes(data)
    read = FORMATS[name].read
    assert read is not None
    return read(path, Filmed())


def refused(folder: Path, data: bytes, name: str) -> str:
    """Why a file is refused, which takes little work."""
    with spent() as time, pytest.raises(FormatError) as told:
        imported(folder, data, name)
    assert time.paces < 150
    message = str(told.value)
    assert "\n" not in message
    assert len(message) < 600
    return message


@pytest.mark.parametrize("name", ["mot", "kitti", "csv"])
@pytest.mark.parametrize(
    "data",
    [
        b"1," * 5_000_000,
        b"\n" * 2_000_000,
        b"x\n" * 200_000,
        b"\xff\xfe" * 1000,
        b"\0" * 500_000,
        b"9" * 60_000,
        b'"' * 60_000,
    ],
    ids=["one line", "empty lines", "junk", "no utf-8", "zeros", "digits", "quotes"],
)
def test_what_is_no_table_is_refused(tmp_path: Path, data: bytes, name: str) -> None:
    assert "tracks.txt" in refused(tmp_path, data, name)


@pytest.mark.parametrize(
    ("name", "good", "bad"),
    [
        ("mot", MOT_ROW, b"1,2,3\n"),
        ("mot", MOT_ROW, MOT_ROW),
        ("mot", MOT_ROW, b"99999999999999999999999,1,1,1,1,1\n"),
        ("kitti", KITTI_ROW, b"a b c\n"),
        ("csv", b"frame,track\n1,1\n", b"1,nan\n"),
        ("csv", b"frame,track,name\n1,1,a\n", b"junk\n"),
    ],
)
def test_reading_ends_where_too_many_rows_are_bad(
    tmp_path: Path, name: str, good: bytes, bad: bytes
) -> None:
    message = refused(tmp_path, good + bad * (FEW_BAD + 5), name)
    assert f"more than {FEW_BAD} invalid rows, the first in line" in message


def test_of_many_bad_rows_some_are_kept_and_all_counted(tmp_path: Path) -> None:
    found = imported(tmp_path, MOT_ROW + b"no row\n" * 5000 + MOT_ROW, "mot")
    assert (len(found.bad_rows), found.bad_count) == (MOST_TOLD, 5001)
    assert found.bad_rows[0].place == "line 2"


def test_a_file_is_read_though_many_rows_are_bad_where_more_are_good(tmp_path: Path) -> None:
    good = b"".join(b"%d,1,1,1,5,5\n" % frame for frame in range(1, 2 * FEW_BAD))
    assert imported(tmp_path, good + b"no row\n" * (FEW_BAD + 1), "mot").bad_count == FEW_BAD + 1


@pytest.mark.parametrize("name", ["mot", "cvat", "coco"])
def test_reading_says_how_far_it_is_and_is_cancelled(tmp_path: Path, name: str) -> None:
    path = tmp_path / "tracks"
    path.write_bytes(
        {
            "mot": b"1,1,1,1,5,5\n" * 1000,
            "cvat": b"<annotations>" + b" " * 50_000 + b"</annotations>",
            "coco": b'{"annotations": []' + b" " * 50_000 + b"}",
        }[name]
    )
    told = []

    def cancel(done: int, total: int) -> None:
        told.append((done, total))
        raise CancelledError

    read = FORMATS[name].read
    assert read is not None
    with pytest.raises(CancelledError):
        read(path, Filmed(), cancel)
    size = path.stat().st_size
    assert told == [(size, size)]


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        (f"{MAX_FRAME + 1},1,1,1,5,5", "frame number"),
        ("-7,1,1,1,5,5", "frame number"),
        ("1e300,1,1,1,5,5", "frame number"),
        ("1,3000000000,1,1,5,5", "id is too large"),
        ("1,1,nan,1,5,5", "finite"),
        ("1,1,1,1e400,5,5", "finite"),
        ("1,1,1,1,5," + "9" * 300, "outside any image"),
        ("1,1,1,1,5,5,1e9", "no such number"),
    ],
)
def test_a_row_out_of_all_bounds_is_told(tmp_path: Path, row: str, reason: str) -> None:
    found = imported(tmp_path, f"{row}\n2,1,1,1,5,5{',1' * (row.count(',') - 5)}\n".encode(), "mot")
    assert (found.bad_count, found.bad_rows[0].place) == (1, "line 1")
    assert reason in found.bad_rows[0].reason
    assert format_of(tmp_path / "tracks.txt").name == "mot"


def test_a_line_just_short_enough_is_read(tmp_path: Path) -> None:
    padded = b"1,1,1,1,5,5".ljust(LONGEST_LINE - 1) + b"\n"
    assert len(imported(tmp_path, padded, "mot").columns["frame"]) == 1


@pytest.mark.parametrize("read", [format_of, read_mot])
def test_a_pipe_is_refused_and_not_waited_for(
    tmp_path: Path, read: Callable[[Path], object]
) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(FormatError, match="no file that can be read twice"):
        read(tmp_path / "pipe")


@pytest.mark.parametrize("name", [*FORMATS])
@pytest.mark.parametrize(
    "head", [b"", b"\0" * 99, b"{" * 60_000, b"<" * 60_000, b"1," * 30_000, b"1 " * 30_000]
)
def test_telling_a_format_is_quick_and_never_fails(tmp_path: Path, name: str, head: bytes) -> None:
    with spent() as time:
        assert FORMATS[name].recognises(tmp_path / "nowhere", head) in (True, False)
    assert time.paces < 80
