"""Other tools read what is written here, and the other way round: `formats.py [CASES] [SEED]`.

Each tool runs in an environment of its own, see `python -m tests.peers`. datumaro parses CVAT's
XML and COCO's JSON, pycocotools the JSON, JuPedSim opens its SQLite files, and what sleap-io writes
is read here. Label Studio's SDK shows its JSON and makes JSON_MIN of it, X-AnyLabeling makes MOT
text of its folders and saves their files anew; what both write is read here, too. PedPy's part is
in `make test`.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np
from numpy.typing import NDArray

from tests.peers.environments import (
    DATUMARO,
    JUPEDSIM,
    LABEL_STUDIO,
    PYCOCOTOOLS,
    SLEAP_IO,
    X_ANYLABELING,
    Peer,
)
from tracking.formats import FORMATS
from tracking.formats.read_result import Filmed, with_all_columns
from tracking.formats.track_writer import Exported, no_progress
from tracking.tracks import TrackLabel, TrackTable

_ANNOTATION = "annotation_tools.py"
FRAMES, PEOPLE = 60, 12
SIZE = (640, 480)
_UNSEEN_PX = 0.0051
"""Boxes that far off the straight way between keyframes are written as if on it."""
BOX = ("left", "top", "width", "height")
Rows = list[list[Any]]


def main() -> int:
    """Write cases, have each tool say what it reads, and compare; 1 where something differs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", type=int, nargs="?", default=50)
    parser.add_argument("seed", type=int, nargs="?", default=random.SystemRandom().randrange(2**32))
    asked = parser.parse_args()
    print(f"seed {asked.seed}", flush=True)
    made = [tracks(np.random.default_rng([asked.seed, case])) for case in range(asked.cases)]
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, check in CHECKS.items():
            wrong = list(check(Path(folder), made))
            failed += len(wrong)
            print(f"{name}: {len(made) - len(wrong)} of {len(made)} cases agree", flush=True)
            for case in wrong:
                print(f"  case {case} differs")
    return int(failed > 0)


def tracks(random: np.random.Generator) -> TrackTable:
    """People who come, vanish for a while and go; some rows without box, some without place."""
    frame, track = np.nonzero(random.random((FRAMES, PEOPLE)) < 0.7)
    count = len(frame)
    rows: dict[str, NDArray[Any]] = {
        "frame": frame,
        "track": np.sort(random.choice(10_000, PEOPLE, replace=False) + 1)[track],
        **{name: random.normal(300, 90, count) for name in ("left", "top")},
        **{name: random.uniform(0.1, 200, count) for name in ("width", "height")},
        **{name: random.normal(0, 9, count) for name in ("x", "y", "vx", "vy")},
        "visibility": random.random(count),
        "source": random.integers(0, 3, count),
    }
    for names in (BOX, ("x", "y")):
        lost = random.random(count) < 0.1
        for name in names:
            rows[name][lost] = np.nan
    return TrackTable(with_all_columns(rows))


def exported(made: TrackTable) -> Exported:
    """With what is known of the footage and of some people."""
    first, second = made.track_ids[:2]
    labels = {
        first: TrackLabel('Zoë "<&>', {"bag": "yes"}),
        second: TrackLabel("", {"class": "dog"}),
    }
    return Exported.of_table(
        made, frames=FRAMES, fps=12.5, size_px=SIZE, name="yard", labels=labels
    )


def boxed(made: TrackTable) -> Rows:
    """frame, track and box of all rows that have one."""
    return rows_of(made, BOX)


def placed(made: TrackTable) -> Rows:
    """frame, track and place of all rows that have one."""
    return rows_of(made, ("x", "y"))


def rows_of(made: TrackTable, names: tuple[str, ...]) -> Rows:
    columns = made.columns()
    known = np.isfinite(columns[names[0]])
    lists = (columns[name][known].tolist() for name in ("frame", "track", *names))
    return [list(row) for row in zip(*lists, strict=True)]


def check_written(
    format_: str,
    file: str,
    peer: Peer,
    expected: Callable[[TrackTable], Rows],
    within: float = 1e-9,
    tool: str = "",
) -> Callable[[Path, list[TrackTable]], Iterator[int]]:
    """Says of cases written in a format which ones the tool reads otherwise.

    tool: its name in `other_tools.py`; "": as the peer's.
    """
    tool = tool or peer.name

    def check(folder: Path, made: list[TrackTable]) -> Iterator[int]:
        places = written_in(format_, folder / tool, file, made)
        for case, found in enumerate(told_by(peer, places, tool)):
            if not alike(found, expected(made[case]), within):
                yield case

    return check


def check_sleap(ending: str) -> Callable[[Path, list[TrackTable]], Iterator[int]]:
    """Says which cases that sleap-io wrote are read otherwise than it was told to write them."""

    def check(folder: Path, made: list[TrackTable]) -> Iterator[int]:
        places = [folder / "sleap-io" / f"{case}{ending}" for case in range(len(made))]
        places[0].parent.mkdir(exist_ok=True)
        for case, said in enumerate(told_by(SLEAP_IO, places, SLEAP_IO.name)):
            if not alike(rows_read("sleap", places[case]), said, 1e-9):
                yield case

    return check


def check_label_studio(folder: Path, made: list[TrackTable]) -> Iterator[int]:
    """Says which cases Label Studio's SDK shows otherwise, or writes otherwise as JSON_MIN."""
    places = written_in("label-studio", folder / LABEL_STUDIO.name, "task.json", made)
    for case, shown in enumerate(told_by(LABEL_STUDIO, places, LABEL_STUDIO.name, _ANNOTATION)):
        expected = boxed(made[case])
        back = rows_read("label-studio", places[case].parent / "min" / "result.json")
        tracks = sorted({row[1] for row in expected})  # JSON_MIN has no ids: their order counts
        back = [[frame, tracks[track - 1], *box] for frame, track, *box in back]
        if not (alike(shown, expected, _UNSEEN_PX) and alike(back, expected, _UNSEEN_PX)):
            yield case


def check_x_anylabeling(folder: Path, made: list[TrackTable]) -> Iterator[int]:
    """Says which cases X-AnyLabeling tells otherwise as MOT text, or saves otherwise."""
    places = written_in("x-anylabeling", folder / X_ANYLABELING.name, "frames", made)
    for case, told in enumerate(told_by(X_ANYLABELING, places, X_ANYLABELING.name, _ANNOTATION)):
        expected = boxed(made[case])
        back = rows_read("x-anylabeling", places[case].parent / "saved")
        whole = [[*row[:2], *_in_whole_pixels(row[2:])] for row in expected]
        if not (alike(told, whole, 0) and alike(back, expected, 1e-9)):
            yield case


def _in_whole_pixels(box: list[float]) -> list[int]:
    """As X-AnyLabeling writes MOT text: edges within the picture, cut to whole pixels."""
    (width, height), (left, top, wide, high) = SIZE, box
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
        write(place, exported(each), no_progress)
    return places


def rows_read(format_: str, path: Path) -> Rows:
    """frame, track and box of what is read here."""
    read = FORMATS[format_].read
    assert read is not None
    columns = read(path, Filmed(size_px=SIZE)).columns
    rows = zip(*(columns[name].tolist() for name in ("frame", "track", *BOX)), strict=True)
    return [list(row) for row in rows]


def alike(found: Rows, expected: Rows, within: float) -> bool:
    """The same rows, numbers no farther apart than that."""
    if len(found) != len(expected):
        return False
    return bool(np.allclose(sorted(found), sorted(expected), rtol=0, atol=within))


def told_by(
    peer: Peer, places: list[Path], tool: str, script: str = "other_tools.py"
) -> list[Rows]:
    """What a tool reads of files, or has written into them, in its own environment."""
    rows: list[Rows] = json.loads(peer.run(script, tool, *places).splitlines()[-1])
    return rows


CHECKS: dict[str, Callable[[Path, list[TrackTable]], Iterator[int]]] = {
    # It keeps edges in hundredths of a pixel.
    "datumaro parses CVAT's XML": check_written(
        "cvat", "annotations.xml", DATUMARO, boxed, within=0.0102
    ),
    "datumaro parses the JSON, with tracks": check_written(
        "coco",
        "annotations/instances_yard.json",
        DATUMARO,
        boxed,
        within=0.0102,
        tool="datumaro-coco",
    ),
    "pycocotools parses the JSON": check_written("coco", "tracks.json", PYCOCOTOOLS, boxed),
    "JuPedSim opens its SQLite files": check_written(
        "jupedsim-sqlite", "tracks.sqlite", JUPEDSIM, placed
    ),
    "the analysis sleap-io writes is read": check_sleap(".h5"),
    "the project sleap-io writes is read": check_sleap(".slp"),
    "the CSV sleap-io writes is read": check_sleap(".csv"),
    "Label Studio's SDK shows its JSON, and JSON_MIN is read": check_label_studio,
    "X-AnyLabeling reads its folder, and what it saves is read": check_x_anylabeling,
}


if __name__ == "__main__":
    sys.exit(main())
