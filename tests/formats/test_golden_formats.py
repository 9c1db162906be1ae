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
from tracking.formats.read_result import Filmed
from tracking.formats.track_writer import Exported, no_progress
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
    "label-studio": "written-label-studio.json",
    "x-anylabeling": "written-xanylabeling.txt",
    "viame": "written-viame.csv",
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
    elif path.is_dir():
        files = sorted(path.iterdir())
        text = "".join(f"{file.name}\n{file.read_text(encoding='utf-8')}" for file in files)
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
    imported = found.read(KEPT / name, Filmed(size_px=(640, 480)))
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


def test_own_files_of_petrack_are_read() -> None:
    # Everybody has number 0 there: people are counted in their order.
    assert rows_read("petrack-v5.trc", "petrack-trc", ("left", "top", "confidence")) == [
        (3, 1, 10.5, 20.25, 1),
        (4, 1, 11, 20.5, pytest.approx(0.79)),
        (5, 1, 12.5, 21, 1),
        (5, 2, 300, -4.5, pytest.approx(0.95)),
    ]
    assert rows_read("petrack-v1.trc", "petrack-trc", ("left", "top")) == [
        (0, 1, 10, 20),
        (1, 1, 11, 21),
    ]
    read = FORMATS["petrack-trc"].read
    assert read is not None
    said = {"comment": "carries a bag", "height_cm": "172.5", "marker": "17"}
    assert read(KEPT / "petrack-v5.trc", Filmed()).labels == {1: TrackLabel(attributes=said)}


def test_the_csv_of_sleap_is_read() -> None:
    # track_0 is id 1 as in SLEAP's HDF5, though it comes second.
    assert rows_read("sleap.csv", "sleap", BOX) == [
        (0, 1, 30, 40, 0, 0),
        (0, 2, 10, 20, 4, 30),
        (2, 1, 31, 39, 4.5, 2),
    ]


def test_the_csv_of_viame_is_read() -> None:
    assert rows_read("viame.csv", "viame", (*BOX, "confidence", "visibility")) == [
        (0, 5, 10, 20, 30, 40, 0.75, 1),
        (1, 4, 100.5, 50, 39.5, 101.25, 0.25, 1),
        (1, 5, 11, 20, 30, 40, 0.5, 0),
    ]
    read = FORMATS["viame"].read
    assert read is not None
    found = read(KEPT / "viame.csv", Filmed())
    assert found.fps == 12.5
    assert found.labels == {
        4: TrackLabel(attributes={"class": "dog"}),
        5: TrackLabel("Zoë Quill", {"bag": "yes"}),
    }


@pytest.mark.parametrize("name", ["xanylabeling", "xanylabeling/frame_00010.json"])
def test_a_folder_of_x_anylabeling_is_read(name: str) -> None:
    assert format_of(KEPT / name).name == "x-anylabeling"
    read = FORMATS["x-anylabeling"].read
    assert read is not None
    found = read(KEPT / name, Filmed())
    columns = (*BOX, "confidence")
    rows = [found.columns[each].tolist() for each in ("frame", "track", *columns)]
    np.testing.assert_equal(
        list(zip(*rows, strict=True)),
        [
            (2, 3, 10, 20, 30, 40, 0.5),
            (2, 4, 100, 45.5, 20, 34.5, 0),  # around a polygon, and difficult: not counted
            (10, 3, 12, 20, 30, 40, NAN),  # two corners, as before version 2.2
        ],
    )
    assert found.size_px == (640, 480)
    assert found.labels[3] == TrackLabel("Zoë", {"bag": "yes"})
    assert [note for note in found.notes if note.startswith("1 ")] == [
        "1 shape without group id is left out",
        "1 point or line is left out",
    ]


def test_a_task_of_label_studio_is_read() -> None:
    # Percent of 640 x 480. The second region is turned by a quarter round its corner.
    assert rows_read("label-studio.json", "label-studio", (*BOX, "source")) == [
        (0, 4, 272, 240, pytest.approx(48), 64, PERSON),
        (1, 5, 64, 120, 32, 240, PERSON),
        (2, 5, 80, 120, 32, 240, BETWEEN),
        (3, 5, 96, 120, 32, 240, PERSON),  # not enabled: it is still shown, then out of view
        (10, 5, 320, 120, 64, 240, PERSON),
        (11, 5, 320, 120, 64, 240, BETWEEN),  # holds until framesCount
    ]
    read = FORMATS["label-studio"].read
    assert read is not None
    found = read(KEPT / "label-studio.json", Filmed(size_px=(640, 480)))
    assert (found.frames, found.fps) == (12, 25)
    assert found.labels == {4: TrackLabel(attributes={"class": "Dog"}), 5: TrackLabel("Zoë")}


def test_the_smaller_json_of_label_studio_is_read() -> None:
    assert rows_read("label-studio-min.json", "label-studio", (*BOX, "source")) == [
        (1, 1, 64, 120, 32, 240, PERSON),
        (2, 1, 64, 120, 32, 240, BETWEEN),
        (3, 1, 64, 120, 32, 240, BETWEEN),
    ]


@pytest.mark.parametrize(
    "format_", ["cvat", "coco", "pedpy-txt", "petrack", "label-studio", "viame"]
)
def test_what_was_written_is_told_by_its_content(format_: str) -> None:
    assert format_of(KEPT / WRITTEN[format_]).name == format_


if __name__ == "__main__":
    import tempfile

    for name, file in WRITTEN.items():
        with tempfile.TemporaryDirectory() as folder:
            (KEPT / file).write_text(written(Path(folder), name), encoding="utf-8")
