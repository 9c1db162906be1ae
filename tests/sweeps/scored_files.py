"""Scorers read the text files written here and say what we say: `scored_files.py [CASES] [SEED]`.

TrackEval scores MOT text of both dialects and KITTI's labels from its own folders, with the
`seqinfo.ini` written beside; py-motmetrics scores MOT text. Tracks of results count from 0.
See `python -m tests.peers`.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np
from numpy.typing import NDArray

from tests.peers.environments import MOTMETRICS, TRACKEVAL, Peer
from tests.peers.motmetrics_names import motmetrics_figures
from tests.peers.trackeval_names import trackeval_figures
from tracking.formats import FORMATS, Exported, Filmed, no_progress, read_mot
from tracking.formats.read_result import in_order, with_all_columns
from tracking.scoring import Conventions, Score, ScoringTable, score
from tracking.tracks import Columns, TrackLabel, TrackTable

FRAMES, PEOPLE, NEAR = 80, 10, 1e-9
SIZE_PX = (1000, 1000)
"""People walk over its edges."""
BOX = ("left", "top", "width", "height")
Figures = dict[str, float | list[float]]


def main() -> int:
    """Write cases, have each scorer score them, and compare; 1 where something differs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", type=int, nargs="?", default=40)
    parser.add_argument("seed", type=int, nargs="?", default=random.SystemRandom().randrange(2**32))
    asked = parser.parse_args()
    print(f"seed {asked.seed}", flush=True)
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, check in CHECKS.items():
            places = [Path(folder) / name / str(case) for case in range(asked.cases)]
            pairs = [drawn(np.random.default_rng([asked.seed, n])) for n in range(asked.cases)]
            differing = check(places, pairs)
            wrong += len(differing)
            print(f"{name}: {asked.cases - len(differing)} of {asked.cases} cases agree")
            for line in differing[:5]:
                print(f"  {line}")
    return int(wrong > 0)


def drawn(chance: np.random.Generator) -> tuple[Exported, Exported]:
    """People in straight lines, and what a poor tracker makes of them: lost, exchanged, made up."""
    frame, person = np.nonzero(chance.random((FRAMES, PEOPLE)) < 0.85)
    start, speed = chance.uniform(0, 900, (2, PEOPLE)), chance.normal(0, 3, (2, PEOPLE))
    truth: dict[str, NDArray[np.float64]] = {
        "left": start[0, person] + frame * speed[0, person],
        "top": start[1, person] + frame * speed[1, person],
        "width": np.full(len(frame), 40.0),
        "height": chance.uniform(80, 120, PEOPLE)[person],
        "x": start[0, person] / 100,
        "y": start[1, person] / 100,
    }
    # How sure a tracker was of corrected rows: of ground truth they count in any case.
    truth["confidence"] = chance.choice([0.0, 0.59, 1.0, np.nan], len(frame))
    seen = chance.random(len(frame)) < 0.9
    result = {name: column[seen] for name, column in truth.items()}
    result["left"] = result["left"] + chance.normal(0, 6, seen.sum())
    result["confidence"] = chance.random(seen.sum())
    names = person[seen].copy()
    for first, second in chance.integers(0, PEOPLE, (6, 2)):
        later = frame[seen] >= chance.integers(0, FRAMES)
        both = [(names == first) & later, (names == second) & later]
        names[both[0]], names[both[1]] = second, first
    return (
        footage(frame, person, truth, corrected=True),
        footage(frame[seen], names, result),
    )


def footage(
    frame: NDArray[np.int64], person: NDArray[np.int64], rows: Columns, **known: bool
) -> Exported:
    """Rows of people, of whom two are no people to the truth."""
    labels = {}
    if known:
        labels = {3: TrackLabel(attributes={"class": "reflection"})}
        labels[4] = TrackLabel(attributes={"class": "car"})
    # All that is said of people's visibility, and where nothing is.
    seen = np.array([1.0, 0.5, 0.1, 0.0, np.nan], np.float32)[(frame // 8 + person) % 5]
    columns = with_all_columns({"frame": frame, "track": person + 1, "visibility": seen, **rows})
    about = {"frames": FRAMES, "fps": 20.0, "size_px": SIZE_PX, "name": "lobby", "labels": labels}
    return Exported.of_table(TrackTable(in_order(columns)), **about, **known)


def written(folder: Path, pair: tuple[Exported, Exported], dialect: str, benchmark: str) -> None:
    """A sequence in TrackEval's folders of MOTChallenge."""
    (folder / "truth" / "lobby" / "gt").mkdir(parents=True)
    (folder / "trackers" / "ours" / "data").mkdir(parents=True)
    (folder / "benchmark").write_text(benchmark)
    write(dialect, folder / "truth" / "lobby" / "gt" / "gt.txt", pair[0])
    # A tracker's eighth column is a class to TrackEval, whatever the benchmark.
    result = folder / "trackers" / "ours" / "data" / "lobby.txt"
    write("mot16", result, pair[1])
    count_from_zero(result)


def count_from_zero(path: Path) -> None:
    """Give every track of a text the id before its own, as trackers do that count from 0."""
    rows = [line.split(",") for line in path.read_text().splitlines()]
    path.write_text(
        "".join(",".join([row[0], str(int(row[1]) - 1), *row[2:]]) + "\n" for row in rows)
    )


def write(name: str, path: Path, exported: Exported) -> None:
    """A file in a format."""
    writes = FORMATS[name].write
    assert writes is not None
    writes(path, exported, no_progress)


def of_mot(dialect: str, benchmark: str) -> Callable[..., list[str]]:
    """Compares TrackEval's figures of MOT text with ours of the same files."""

    def check(places: list[Path], pairs: list[tuple[Exported, Exported]]) -> list[str]:
        for place, pair in zip(places, pairs, strict=True):
            written(place, pair, dialect, benchmark)
        told = told_by(TRACKEVAL, "mot", places)
        ours = [trackeval_figures(of_files(place)) for place in places]
        return differing(told, ours)

    return check


def of_files(folder: Path, conventions: Conventions = Conventions.TRACKEVAL) -> Score:
    """Our score of the files TrackEval reads."""
    truth = read_mot(folder / "truth" / "lobby" / "gt" / "gt.txt")
    ours = read_mot(folder / "trackers" / "ours" / "data" / "lobby.txt")
    return scored(truth, ours, conventions)


def scored(
    truth: Columns, ours: Columns, conventions: Conventions = Conventions.TRACKEVAL
) -> Score:
    """Our score of one sequence."""
    sides = ScoringTable.from_columns(truth, dont_cares=True), ScoringTable.from_columns(ours)
    return score(*sides, None, FRAMES, conventions)


def of_kitti(places: list[Path], pairs: list[tuple[Exported, Exported]]) -> list[str]:
    """Compares TrackEval's figures of KITTI's labels with ours of people alone."""
    ours = []
    for place, (truth, result) in zip(places, pairs, strict=True):
        (place / "truth" / "label_02").mkdir(parents=True)
        (place / "trackers" / "ours" / "data").mkdir(parents=True)
        seqmap = f"0000 empty 000000 {FRAMES:06d}\n"
        (place / "truth" / "evaluate_tracking.seqmap.training").write_text(seqmap * 2)
        files = place / "truth" / "label_02" / "0000.txt", place / "trackers/ours/data/0000.txt"
        for path, each in zip(files, (truth, result), strict=True):
            write("kitti", path, each)
        read = FORMATS["kitti"].read
        assert read is not None
        true, found = (read(path, Filmed()) for path in files)
        people = ~np.isin(true.columns["track"], list(true.labels))
        counted = {name: column[people] for name, column in true.columns.items()}
        ours.append(trackeval_figures(scored(counted, found.columns)))
    told = told_by(TRACKEVAL, "kitti", places)
    return differing(told, ours)


def of_motmetrics(places: list[Path], pairs: list[tuple[Exported, Exported]]) -> list[str]:
    """Compares py-motmetrics' figures of MOT text with ours by its conventions."""
    for place, pair in zip(places, pairs, strict=True):
        written(place, pair, "mot16", "MOT17")
    told = told_by(MOTMETRICS, "motmetrics", places)
    ours = [motmetrics_figures(of_files(place, Conventions.MOTMETRICS)) for place in places]
    return differing(told, ours)


def told_by(peer: Peer, kind: str, places: list[Path]) -> list[Figures]:
    """What a scorer makes of folders, in its own environment; it may say other things first."""
    said = peer.run("text_files.py", kind, *places).splitlines()
    told: list[Figures] = json.loads(said[-1])
    return told


def differing(told: list[Figures], ours: list[Figures]) -> list[str]:
    """What differs, a line each."""
    return [
        f"case {case}: {name} is {theirs[name]}, ours is {own[name]}"
        for case, (theirs, own) in enumerate(zip(told, ours, strict=True))
        for name in theirs
        if not np.allclose(theirs[name], own[name], rtol=0, atol=NEAR, equal_nan=True)
    ]


CHECKS = {
    "TrackEval, MOT text with classes": of_mot("mot16", "MOT17"),
    "TrackEval, MOT text with places": of_mot("mot", "MOT15"),
    "TrackEval, KITTI's labels": of_kitti,
    "py-motmetrics, MOT text": of_motmetrics,
}


if __name__ == "__main__":
    sys.exit(main())
