"""Small files as other tools write them, and those written here, checked by hand.

`written*` hold `WALK` in each format. Where a writer changes on purpose, write them anew with
`python tests/formats/test_golden_formats.py`, and check them by hand against the specification.
"""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from made_tracks import BOX, FLOOR, table

import tracking
from tracking.formats import FORMATS, format_of
from tracking.formats.reading import Filmed
from tracking.formats.writing import Exported, no_progress
from tracking.tracks import TrackLabel

KEPT = Path(__file__).parents[1] / "golden" / "formats"
NAN = np.nan
PERSON, BETWEEN, TRACKER = 1, 2, 0

WALK = Exported.of_table(
    table(
        [(0, 3), (1, 3), (1, 8), (2, 3), (5, 3)],
        [(10, 20, 30, 40), (11, 20, 30, 40), (-1.5, 0, 9, 9.25), (12, 20, 30, 40), (NAN,) * 4],
        [(0.5, 2), (NAN, NAN), (-1, 4.125), (0.75, 2), (1.25, 2)],
        source=[PERSON, BETWEEN, TRACKER, PERSON, TRACKER],
        visibility=[1, 1, 0.2, 1, 1],
    ),
    frames=8,
    fps=25.0,
    size_px=(640, 480),
    name="yard",
    labels={3: TrackLabel("Zoë", {"bag": "<no>"}), 8: TrackLabel("", {"class": "dog"})},
)
WRITTEN = {
    "cvat": "written-cvat.xml",
    "coco": "written-tao.json",
    "pedpy-txt": "written-pedpy.txt",
    "petrack": "written-petrack.txt",
    "pedpy-h5": "written-archive.h5.txt",
    "jupedsim-h5": "written-jupedsim.h5.txt",
    "jupedsim-sqlite": "written-jupedsim.sql",
}


def written(folder: Path, format_: str) -> str:
    """What is written in a format, as text that people can check."""
    write = FORMATS[format_].write
    assert write is not None
    path = folder / "tracks"
    write(path, WALK, no_progress)
    if format_.endswith("-h5"):
        text = told_of_hdf5(path)
    elif format_.endswith("-sqlite"):
        with closing(sqlite3.connect(path)) as database:
            text = "\n".join(database.iterdump()) + "\n"
    else:
        text = path.read_text(encoding="utf-8")
    return text.replace(tracking.__version__, "VERSION")


def told_of_hdf5(path: Path) -> str:
    """All a file of one table says."""
    with h5py.File(path, "r") as file:
        assert list(file) == ["trajectory"]
        rows = file["trajectory"]
        said = [f"{name} = {value!r}" for name, value in sorted(plain(file.attrs).items())]
        said += [f"/trajectory {name} = {value!r}" for name, value in plain(rows.attrs).items()]
        said.append(f"/trajectory {rows.dtype.descr}")
        said += map(str, rows[()].tolist())
    return "\n".join(said) + "\n"


def plain(attributes: Any) -> dict[str, Any]:
    return {name: getattr(value, "item", lambda v=value: v)() for name, value in attributes.items()}


@pytest.mark.parametrize("format_", WRITTEN)
def test_files_are_written_as_they_were_checked(tmp_path: Path, format_: str) -> None:
    assert written(tmp_path, format_) == (KEPT / WRITTEN[format_]).read_text(encoding="utf-8")


def rows_read(name: str, format_: str, columns: tuple[str, ...]) -> list[tuple[float, ...]]:
    """The rows of a kept file, which is told by its content."""
    found = format_of(KEPT / name)
    assert found.name == format_
    assert found.read is not None
    imported = found.read(KEPT / name, Filmed())
    assert imported.bad_count == 0
    lists = (imported.columns[column].tolist() for column in ("frame", "track", *columns))
    return list(zip(*lists, strict=True))


def test_a_task_of_cvat_is_read() -> None:
    # Track 0 becomes 2: ids are positive. Frame 7 is out of view; the last box holds to frame 19.
    assert rows_read("cvat.xml", "cvat", (*BOX, "visibility", "source")) == [
        (4, 1, 1, 2, 2, 3, 1, TRACKER),
        (4, 2, 100, 50, 40, 100, 1, PERSON),
        (5, 2, 102.5, 50, 40, 100, 1, BETWEEN),
        (6, 2, 105, 50, 40, 100, 0, PERSON),
        (18, 2, 0, 0, 640, 480, 1, PERSON),
        (19, 2, 0, 0, 640, 480, 1, BETWEEN),
    ]
    read = FORMATS["cvat"].read
    assert read is not None
    found = read(KEPT / "cvat.xml", Filmed())
    assert found.labels == {
        1: TrackLabel(attributes={"class": "car"}),
        2: TrackLabel(attributes={"bag": "yes"}),
    }
    assert (found.frames, found.size_px) == (20, (640, 480))


def test_annotations_of_tao_are_read() -> None:
    # frame_index counts from 0 where the pictures' names count from 1.
    assert rows_read("tao.json", "coco", BOX) == [
        (390, 4, 189, 80, 19, 44),
        (420, 4, 194, 83, 21, 46),
        (420, 5, 0, 0, 9, 9),
    ]


def test_an_export_of_petrack_is_read() -> None:
    assert rows_read("petrack.txt", "petrack", FLOOR) == [
        (0, 1, 13.7271, 1.02799),
        (1, 1, 13.7288, 1.03453),
        (4, 1, 13.7242, 1.02797),
        (4, 2, -3.5, 0.25),
    ]


def test_centimetres_of_the_archive_are_read() -> None:
    assert rows_read("archive-cm.txt", "pedpy-txt", FLOOR) == [
        (98, 3, pytest.approx(8.21), pytest.approx(131.57)),
        (99, 3, pytest.approx(8.41), pytest.approx(133.42)),
    ]


@pytest.mark.parametrize("format_", ["cvat", "coco", "pedpy-txt", "petrack"])
def test_what_was_written_is_told_by_its_content(format_: str) -> None:
    assert format_of(KEPT / WRITTEN[format_]).name == format_


if __name__ == "__main__":
    import tempfile

    for name, file in WRITTEN.items():
        with tempfile.TemporaryDirectory() as folder:
            (KEPT / file).write_text(written(Path(folder), name), encoding="utf-8")
