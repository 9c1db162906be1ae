"""Other tools read what is written here, and the other way round: `formats.py --runs 5`.

Each tool runs in an environment of its own, see `python -m tests.peers`. datumaro parses CVAT's
XML and COCO's JSON, pycocotools the JSON, JuPedSim opens its SQLite files, and what sleap-io writes
is read here. Label Studio's SDK shows its JSON and makes JSON_MIN of it, X-AnyLabeling makes MOT
text of its folders and saves their files anew; what both write is read here, too. PedPy's part is
in `make test`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tests.peers.environments import (
    DATUMARO,
    JUPEDSIM,
    LABEL_STUDIO,
    PYCOCOTOOLS,
    SLEAP_IO,
    X_ANYLABELING,
    Peer,
    require,
)
from tests.sweeps.random_tracks import BOX, FLOOR, SIZE_PX, exported, random_tracks
from tests.sweeps.runner import Worker, emptied, sweep
from tracking.formats import FORMATS
from tracking.formats.read_result import Filmed
from tracking.formats.track_writer import no_progress
from tracking.tracks import TrackTable

CASES, FRAMES, PEOPLE = 10, 60, 12
_UNSEEN_PX = 0.0051
"""Boxes that far off the straight way between keyframes are written as if on it."""
Rows = list[list[Any]]
Check = Callable[[Path, list[TrackTable]], Iterator[int]]
"""Writes tables, has a tool say what it reads, and gives the places of those that differ."""


def attack(worker: Worker) -> Iterator[str]:
    """Some other tables a run, through all tools."""
    for number in worker.numbers:
        seeds = [[worker.asked.seed, number, case] for case in range(CASES)]
        made = [random_tracks(seed, FRAMES, PEOPLE) for seed in seeds]
        for name, check in CHECKS.items():
            wrong = list(check(emptied(worker.folder / "files"), made))
            worker.count(f"cases of: {name}", CASES)
            if wrong:
                yield f"{name}: cases {wrong} of {CASES} differ"


def rows_of(made: TrackTable, names: tuple[str, ...]) -> Rows:
    """Frame, track and these columns of all rows in which they are known."""
    columns = made.columns()
    known = np.isfinite(columns[names[0]])
    lists = (columns[name][known].tolist() for name in ("frame", "track", *names))
    return [list(row) for row in zip(*lists, strict=True)]


def check_written(
    peer: Peer,
    format_: str,
    file: str,
    columns: tuple[str, ...] = BOX,
    within: float = 1e-9,
    tool: str = "",
) -> Check:
    """Says of cases written in a format which ones the tool reads otherwise.

    tool: its name in `other_tools.py`; "": as the peer's.
    """

    def check(folder: Path, made: list[TrackTable]) -> Iterator[int]:
        places = written_in(format_, folder, file, made)
        for case, found in enumerate(told_by(peer, places, tool)):
            if not alike(found, rows_of(made[case], columns), within):
                yield case

    return check


def check_sleap(ending: str) -> Check:
    """Says which cases that sleap-io wrote are read otherwise than it was told to write them."""

    def check(folder: Path, made: list[TrackTable]) -> Iterator[int]:
        places = [folder / f"{case}{ending}" for case in range(len(made))]
        for case, said in enumerate(told_by(SLEAP_IO, places)):
            if not alike(rows_read("sleap", places[case]), said, 1e-9):
                yield case

    return check


def check_label_studio(folder: Path, made: list[TrackTable]) -> Iterator[int]:
    """Says which cases Label Studio's SDK shows otherwise, or writes otherwise as JSON_MIN."""
    places = written_in("label-studio", folder, "task.json", made)
    for case, shown in enumerate(told_by(LABEL_STUDIO, places)):
        expected = rows_of(made[case], BOX)
        back = rows_read("label-studio", places[case].parent / "min" / "result.json")
        tracks = sorted({row[1] for row in expected})  # JSON_MIN has no ids: their order counts
        back = [[frame, tracks[track - 1], *box] for frame, track, *box in back]
        if not (alike(shown, expected, _UNSEEN_PX) and alike(back, expected, _UNSEEN_PX)):
            yield case


def check_x_anylabeling(folder: Path, made: list[TrackTable]) -> Iterator[int]:
    """Says which cases X-AnyLabeling tells otherwise as MOT text, or saves otherwise."""
    places = written_in("x-anylabeling", folder, "frames", made)
    for case, told in enumerate(told_by(X_ANYLABELING, places)):
        expected = rows_of(made[case], BOX)
        back = rows_read("x-anylabeling", places[case].parent / "saved")
        whole = [[*row[:2], *_in_whole_pixels(row[2:])] for row in expected]
        if not (alike(told, whole, 0) and alike(back, expected, 1e-9)):
            yield case


def _in_whole_pixels(box: list[float]) -> list[int]:
    """As X-AnyLabeling writes MOT text: edges within the picture, cut to whole pixels."""
    (width, height), (left, top, wide, high) = SIZE_PX, box
    x0, x1 = (int(max(0, min(x, width - 1))) for x in (left, left + wide))
    y0, y1 = (int(max(0, min(y, height - 1))) for y in (top, top + high))
    return [x0, y0, x1 - x0, y1 - y0]


def written_in(format_: str, folder: Path, file: str, made: list[TrackTable]) -> list[Path]:
    """Where cases are written in a format, each in a folder of its own."""
    write = FORMATS[format_].write
    assert write is not None
    places = [folder / str(case) / file for case in range(len(made))]
    for place, each in zip(places, made, strict=True):
        place.parent.mkdir(parents=True)
        write(place, exported(each, FRAMES), no_progress)
    return places


def rows_read(format_: str, path: Path) -> Rows:
    """frame, track and box of what is read here."""
    read = FORMATS[format_].read
    assert read is not None
    columns = read(path, Filmed(size_px=SIZE_PX)).columns
    rows = zip(*(columns[name].tolist() for name in ("frame", "track", *BOX)), strict=True)
    return [list(row) for row in rows]


def alike(found: Rows, expected: Rows, within: float) -> bool:
    """The same rows, numbers no farther apart than that."""
    if len(found) != len(expected):
        return False
    return bool(np.allclose(sorted(found), sorted(expected), rtol=0, atol=within))


def told_by(peer: Peer, places: list[Path], tool: str = "") -> list[Rows]:
    """What a tool reads of files, or has written into them, in its own environment."""
    rows: list[Rows] = peer.told("other_tools.py", tool or peer.name, *places)
    return rows


# datumaro keeps edges in hundredths of a pixel.
_NEAR_PX = 0.0102
_COCO = "annotations/instances_yard.json"
CHECKS: dict[str, Check] = {
    "datumaro parses CVAT's XML": check_written(
        DATUMARO, "cvat", "annotations.xml", within=_NEAR_PX
    ),
    "datumaro parses the JSON, with tracks": check_written(
        DATUMARO, "coco", _COCO, within=_NEAR_PX, tool="datumaro-coco"
    ),
    "pycocotools parses the JSON": check_written(PYCOCOTOOLS, "coco", "tracks.json"),
    "JuPedSim opens its SQLite files": check_written(
        JUPEDSIM, "jupedsim-sqlite", "tracks.sqlite", FLOOR
    ),
    "the analysis sleap-io writes is read": check_sleap(".h5"),
    "the project sleap-io writes is read": check_sleap(".slp"),
    "the CSV sleap-io writes is read": check_sleap(".csv"),
    "Label Studio's SDK shows its JSON, and JSON_MIN is read": check_label_studio,
    "X-AnyLabeling reads its folder, and what it saves is read": check_x_anylabeling,
}

if __name__ == "__main__":
    require(DATUMARO, PYCOCOTOOLS, JUPEDSIM, SLEAP_IO, LABEL_STUDIO, X_ANYLABELING)
    sys.exit(sweep(attack, 5))
