"""Large texts: what is refused takes hardly any memory, what is read takes it by its rows."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.pace import spent
from tracking.errors import FormatError
from tracking.formats import FORMATS, people_in_mot
from tracking.formats.read_result import Filmed

SIZE = 60 << 20
MOST_MIB = 200
ROWS_ARE_REFUSED = [
    ("mot", b"1,1,10,20,30,40,1\n", b"the quick brown fox\n"),
    ("mot", b"", b"1,1,10,20,30,40,1,-1,-1,-1\n"),
    ("mot", b"", b"0.5,1,10,20,30,40,1,-1,-1,-1\n"),
    ("mot", b"1,1,10,20,30,40,1\n", b"7"),
    ("mot", b"1,1,10,20,30,40,1\n", b"\n"),
    ("csv", b"frame,track,left\n1,1,2\n", b"fox,dog\n"),
    ("csv", b"frame,track\n1,1\n", b"1,1\n"),
    ("csv", b"frame,track\n1,1\n", b"\n"),
    ("kitti", b"", b"0 1 Car 0 0 0 1 1 2 2 1 1 1 0 0 0 0\n"),
    ("pedpy-txt", b"# framerate: 25 fps\n# id frame x/m y/m\n", b"1 1 1 1\n"),
    ("viame", b"# 1: Detection or Track-id\n", b"1,,0,1,2,3,4,1,-1,person,1\n"),
    ("sleap", b"track,frame_idx,instance.score,a.x,a.y\n", b"track_0,0.5,1,1,1\n"),
    ("sleap", b"track,frame_idx,instance.score,a.x,a.y\n", b"track_0,1,1,1,1\n"),
]
CVAT_BOX = b'<box frame="1" xtl="1" ytl="1" xbr="2" ybr="2" outside="0" occluded="0"/>\n'
COCO_BOX = b'{"id":1,"image_id":1,"track_id":1,"category_id":1,"bbox":[1,2,3,4]},'
TREES_ARE_REFUSED = [
    ("cvat", b"<annotations>", b"<x/>", b"</annotations>", "without boxes"),
    ("cvat", b"<annotations><track id='1'>", b"<x/>", b"</track></annotations>", "without boxes"),
    ("cvat", b"<annotations>", b'<image id="1"/>', b"</annotations>", "CVAT for images"),
    ("cvat", b"<annotations><track id='1' label='person'>", CVAT_BOX, b"<box", "is cut short"),
    ("cvat", b"<annotations><track id='1' label='person'>", CVAT_BOX, b"", "is cut short"),
    ("coco", b'{"images":[],', b'"a":1,', b'"z":1}', "more members"),
    ("coco", b'{"videos":[', b'{"id":1},', b'{"id":2}]}', "more than 10000 videos"),
    ("coco", b'{"annotations":[', COCO_BOX, b'{"id":', "is cut short"),
    ("label-studio", b'[{"id":1,"annotations":[{"result":[', b"1,", b"1]}]}]", "is no object"),
    ("label-studio", b"[", b'{"id":1,"annotations":[]},', b"{}]", "20000 annotations"),
    ("label-studio", b"[{", b'"id":1,', b'"z":1}]', "more members"),
]
READ = """
import sys
from pathlib import Path
from tracking.errors import FormatError
from tracking.formats import FORMATS, people_in_mot
from tracking.formats.read_result import Filmed, Stated

name, path = sys.argv[1], Path(sys.argv[2])
try:
    if name == "people":
        print(people_in_mot(path), "people")
    else:
        found = FORMATS[name].read(path, Filmed(stated=Stated("m", 25.0)))
        print(len(found.columns["frame"]), "rows")
except FormatError as error:
    print("refused:", error)
status = Path("/proc/self/status").read_text("ascii").splitlines()
print(next(line.split()[1] for line in status if line.startswith("VmHWM")))
"""


def outcome(name: str, path: Path) -> tuple[str, int]:
    """What becomes of a file in a process of its own, and the most memory it took, MiB."""
    done = subprocess.run(
        [sys.executable, "-c", READ, name, str(path)],
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    said, peak_kib = done.stdout.splitlines()
    return said, int(peak_kib) >> 10


def written(folder: Path, head: bytes, again: bytes, tail: bytes = b"") -> Path:
    """A file that begins so, goes on with the same again and again, and ends so."""
    path = folder / "tracks.txt"
    many = again * -(-(1 << 20) // len(again))
    with path.open("wb") as stream:
        stream.write(head)
        while stream.tell() < SIZE:
            stream.write(many)
        stream.write(tail)
    return path


@pytest.mark.parametrize(("name", "head", "again"), ROWS_ARE_REFUSED)
def test_a_large_text_that_is_refused_takes_little_memory_and_work(
    tmp_path: Path, name: str, head: bytes, again: bytes
) -> None:
    path = written(tmp_path, head, again)
    with spent() as time:
        said, peak_mib = outcome(name, path)
    assert said.startswith("refused: ")
    assert peak_mib < MOST_MIB
    assert time.paces < 300


@pytest.mark.parametrize(("name", "head", "again", "tail", "why"), TREES_ARE_REFUSED)
def test_large_xml_and_json_that_is_refused_takes_little_memory_and_work(
    tmp_path: Path, name: str, head: bytes, again: bytes, tail: bytes, why: str
) -> None:
    path = written(tmp_path, head, again, tail)
    with spent() as time:
        said, peak_mib = outcome(name, path)
    assert said.startswith("refused: ")
    assert why in said
    assert peak_mib < MOST_MIB
    assert time.paces < 400


def rows_of_mot(frames: int, people: int) -> bytes:
    return b"".join(
        b"%d,%d,%d.25,20.5,30.5,40.5,1,1.25,2.5,0\n" % (frame, person, person)
        for frame in range(1, frames + 1)
        for person in range(1, people + 1)
    )


def test_a_large_text_is_read_in_memory_by_its_rows(tmp_path: Path) -> None:
    few, many = tmp_path / "few.txt", tmp_path / "many.txt"
    few.write_bytes(rows_of_mot(100, 40))
    many.write_bytes(rows_of_mot(10_000, 40))
    (_, least_mib), (said, peak_mib) = outcome("mot", few), outcome("mot", many)
    assert said == "400000 rows"
    assert ((peak_mib - least_mib) << 20) / 400_000 < 220


@pytest.mark.parametrize("with_classes", [False, True])
def test_rows_of_viame_are_read_in_memory_by_their_numbers(
    tmp_path: Path, *, with_classes: bool
) -> None:
    row = b"%d,,%d,1,2,3,4,0.5,-1" + b",car,0.5" * with_classes + b"\n"
    few, many = tmp_path / "few.csv", tmp_path / "many.csv"
    for path, frames in ((few, 100), (many, 8_000)):
        rows = (row % (person, frame) for frame in range(frames) for person in range(1, 26))
        path.write_bytes(b"".join(rows))
    (_, least_mib), (said, peak_mib) = outcome("viame", few), outcome("viame", many)
    assert said == "200000 rows"
    assert ((peak_mib - least_mib) << 20) / 200_000 < 220


def test_a_file_of_viame_with_an_id_a_row_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path, b"", b"".join(b"%d,,0,1,2,3,4,1,-1,c,1\n" % n for n in range(1 << 18)))
    said, peak_mib = outcome("viame", path)
    assert "has more than 200000 tracks" in said
    assert peak_mib < MOST_MIB + 50


def test_people_of_a_large_text_are_counted_without_its_rows(tmp_path: Path) -> None:
    few, many = tmp_path / "few.txt", tmp_path / "many.txt"
    few.write_bytes(rows_of_mot(2_000, 40))
    many.write_bytes(rows_of_mot(10_000, 40))
    (_, least_mib), (said, peak_mib) = outcome("people", few), outcome("people", many)
    assert said == "40 people"
    assert peak_mib - least_mib < 16


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        (b"1,2,3\n", "line 3: 3 values"),
        (b"1,2,nan,4,5,6\n", "line 3: a value is not a finite number"),
        (b"0,2,3,4,5,6\n", "line 3: the frame number is not one of"),
    ],
)
def test_people_are_not_counted_where_a_row_is_invalid(
    tmp_path: Path, row: bytes, reason: str
) -> None:
    path = tmp_path / "truth.txt"
    path.write_bytes(b"1,1,3,4,5,6\n1,2,3,4,5,6\n" + row)
    with pytest.raises(FormatError, match=f"truth.txt, {reason}"):
        people_in_mot(path)


@pytest.mark.parametrize("ending", [b"\n", b"\r\n"])
def test_rows_of_pieces_are_all_read_with_their_lines(tmp_path: Path, ending: bytes) -> None:
    """The file is longer than a piece, its last line has no end."""
    path = tmp_path / "tracks.txt"
    rows = [b"%d,1,10.5,20.5,30.5,40.5" % frame for frame in range(1, 60_001)]
    path.write_bytes(ending.join([*rows[:40_000], b"", b"# nothing", b"bad", *rows[40_000:]]))
    read = FORMATS["mot"].read
    assert read is not None
    found = read(path, Filmed())
    assert found.columns["frame"].tolist() == list(range(60_000))
    assert found.bad_rows[0].place == "line 40003"
    assert found.place_of is not None
    assert (found.place_of(39_999), found.place_of(59_999)) == ("line 40000", "line 60003")
