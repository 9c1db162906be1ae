"""Other tools read what is written here, and the other way round: `formats.py [CASES] [SEED]`.

Each tool runs in an environment of its own, see `python -m tests.peers`. datumaro parses CVAT's
XML, pycocotools the JSON, JuPedSim opens its SQLite files, and what sleap-io writes is read here.
PedPy's part is in `make test`.
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

from tests.peers.environments import DATUMARO, JUPEDSIM, PYCOCOTOOLS, SLEAP_IO, Peer
from tracking.formats import FORMATS
from tracking.formats.reading import Filmed, with_all_columns
from tracking.formats.writing import Exported, no_progress
from tracking.tracks import TrackLabel, TrackTable

FRAMES, PEOPLE = 60, 12
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
        made, frames=FRAMES, fps=12.5, size_px=(640, 480), name="yard", labels=labels
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
) -> Callable[[Path, list[TrackTable]], Iterator[int]]:
    """Says of cases written in a format which ones the tool reads otherwise."""

    def check(folder: Path, made: list[TrackTable]) -> Iterator[int]:
        write = FORMATS[format_].write
        assert write is not None
        places = [folder / peer.name / str(case) / file for case in range(len(made))]
        for place, each in zip(places, made, strict=True):
            place.parent.mkdir(parents=True)
            write(place, exported(each), no_progress)
        for case, found in enumerate(told_by(peer, places)):
            if not alike(found, expected(made[case]), within):
                yield case

    return check


def check_sleap(folder: Path, made: list[TrackTable]) -> Iterator[int]:
    """Says which cases that sleap-io wrote are read otherwise than it was told to write them."""
    read = FORMATS["sleap"].read
    assert read is not None
    places = [folder / "sleap-io" / f"{case}.h5" for case in range(len(made))]
    (folder / "sleap-io").mkdir()
    for case, said in enumerate(told_by(SLEAP_IO, places)):
        found = read(places[case], Filmed())
        columns = found.columns
        rows = zip(*(columns[name].tolist() for name in ("frame", "track", *BOX)), strict=True)
        if not alike([list(row) for row in rows], said, 1e-9):
            yield case


def alike(found: Rows, expected: Rows, within: float) -> bool:
    """The same rows, numbers no farther apart than that."""
    if len(found) != len(expected):
        return False
    return bool(np.allclose(sorted(found), sorted(expected), rtol=0, atol=within))


def told_by(peer: Peer, places: list[Path]) -> list[Rows]:
    """What a tool reads of files, or has written into them, in its own environment."""
    rows: list[Rows] = json.loads(peer.run("other_tools.py", peer.name, *places).splitlines()[-1])
    return rows


CHECKS: dict[str, Callable[[Path, list[TrackTable]], Iterator[int]]] = {
    # It keeps edges in hundredths of a pixel.
    "datumaro parses CVAT's XML": check_written(
        "cvat", "annotations.xml", DATUMARO, boxed, within=0.0102
    ),
    "pycocotools parses the JSON": check_written("coco", "tracks.json", PYCOCOTOOLS, boxed),
    "JuPedSim opens its SQLite files": check_written(
        "jupedsim-sqlite", "tracks.sqlite", JUPEDSIM, placed
    ),
    "what sleap-io writes is read": check_sleap,
}


if __name__ == "__main__":
    sys.exit(main())
