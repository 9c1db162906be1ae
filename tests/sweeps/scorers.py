"""Our scores against TrackEval's and py-motmetrics': `scorers.py --runs 8`, 50 sequences a run.

Random sequences are handed over in memory, each alone and all of them combined. People who walk are
written as text files of each kind, too, that the scorers read by themselves: TrackEval MOT text of
both dialects and KITTI's labels from its own folders, with the `seqinfo.ini` written beside,
py-motmetrics MOT text. Each scorer runs in an environment of its own, see `python -m tests.peers`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from tests.peers.drawn_sequences import GHOSTS, Sequence, drawn, tables, walking
from tests.peers.environments import MOTMETRICS, TRACKEVAL, require
from tests.peers.figures import COUNTS, Figures, differences, motmetrics_figures, trackeval_figures
from tests.peers.golden import SCRIPTS, told_by
from tests.peers.sequences import COLUMNS
from tests.sweeps.runner import Worker, emptied, sweep
from tracking.formats import FORMATS, Exported, Filmed, no_progress, read_mot
from tracking.formats.read_result import in_order, with_all_columns
from tracking.scoring import (
    BoxMatch,
    Conventions,
    FloorMatch,
    Match,
    Score,
    ScoringTable,
    combined,
    score,
)
from tracking.tracks import Columns, TrackLabel, TrackTable

SEQUENCES, NEAR = 50, 1e-9
WALKS, FRAMES, PEOPLE = 10, 80, 10
SIZE_PX = (150, 100)
"""People walk over its edges."""
WAYS: dict[str, Match] = {"box": BoxMatch(), "floor": FloorMatch(0.5)}
"""How rows are matched, by the names of the peers' scripts."""
Compared = tuple[str, dict[str, Figures], dict[str, Figures]]
"""With whom and how; our figures and theirs by sequence."""


def attack(worker: Worker) -> Iterator[str]:
    """Other sequences a run."""
    np.seterr(all="raise")
    for _ in worker.numbers:
        chance = worker.chance()
        sequences = drawn(SEQUENCES, chance.randrange(1 << 32))
        pairs = [walked(np.random.default_rng(chance.randrange(1 << 32))) for _ in range(WALKS)]
        for whom, ours, theirs in (*in_memory(sequences), *in_files(worker.folder, pairs)):
            worker.count(f"scores of {whom}", len(ours))
            for name, one in ours.items():
                for figure, far in differences(one, theirs[name]).items():
                    worker.count("figures")
                    if far > (0.0 if figure in COUNTS else NEAR):
                        yield f"{whom}, sequence {name}: {figure} is {far:g} away"


def in_memory(sequences: dict[str, Sequence]) -> Iterator[Compared]:
    """The same rows scored by all, each sequence alone and all together."""
    trackeval, motmetrics = told_by(TRACKEVAL, sequences), told_by(MOTMETRICS, sequences)
    for way, match in WAYS.items():
        scores = {name: score(*tables(one), match) for name, one in sequences.items()}
        ours = with_combined(scores, "COMBINED_SEQ", trackeval_figures)
        yield f"TrackEval, {way}", ours, trackeval[way]
        scores = {
            name: score(*tables(sequences[name]), match, conventions=Conventions.MOTMETRICS)
            for name in motmetrics[way]
            if name in sequences
        }
        theirs = motmetrics[way]
        if theirs["OVERALL"]["motp"] is None:
            # One sequence without a match makes its mean over all undefined; ours is not.
            del theirs["OVERALL"]["motp"]
        yield f"py-motmetrics, {way}", with_combined(scores, "OVERALL", motmetrics_figures), theirs


def with_combined(
    scores: dict[str, Score], name: str, figures: Callable[[Score], Figures]
) -> dict[str, Figures]:
    """Each score's figures, and those of all together under the peer's name for that."""
    found = {one: figures(each) for one, each in scores.items()}
    return found | {name: figures(combined(list(scores.values())))}


# Text files

Pair = tuple[Exported, Exported]
GROUND_TRUTH, RESULT = "truth/lobby/gt/gt.txt", "trackers/ours/data/lobby.txt"


def walked(random: np.random.Generator) -> Pair:
    """People who walk, and what a poor tracker makes of them: lost, exchanged, beside them."""
    truth, result = walking(random, PEOPLE, FRAMES, 6.0)
    result = result[result[:, 1] < GHOSTS]  # some are so small that KITTI does not count them
    # How sure a tracker was of corrected rows: of ground truth they count in any case.
    truth[:, 8] = random.choice([0.0, 0.59, 1.0, np.nan], len(truth))
    return footage(truth, corrected=True), footage(result)


def footage(rows: np.ndarray, **known: bool) -> Exported:
    """Rows of people, of whom two are no people to the truth."""
    table = dict(zip(COLUMNS, rows.T, strict=True))
    frame, track = (table[name].astype(int) for name in ("frame", "track"))
    # All that is said of people's visibility, and where nothing is.
    seen = np.array([1.0, 0.5, 0.1, 0.0, np.nan], np.float32)[(frame // 8 + track) % 5]
    shown = {"left": table["left"] - 100, "top": table["top"] - 40, "visibility": seen}
    columns = with_all_columns({**table, **shown, "frame": frame, "track": track})
    classes = {3: "reflection", 4: "car"} if known else {}
    labels = {id_: TrackLabel(attributes={"class": name}) for id_, name in classes.items()}
    about = {"frames": FRAMES, "fps": 20.0, "size_px": SIZE_PX, "name": "lobby", "labels": labels}
    return Exported.of_table(TrackTable(in_order(columns)), **about, **known)


def in_files(folder: Path, pairs: list[Pair]) -> Iterator[Compared]:
    """Files scored by those who read them, and by us."""
    for whom, (peer, kind, write_pair, figures) in FILES.items():
        places = {str(case): emptied(folder / "files" / str(case)) for case in range(len(pairs))}
        for place, pair in zip(places.values(), pairs, strict=True):
            write_pair(place, pair)
        told = peer.told(SCRIPTS[peer.name], kind, *places.values())
        ours = {case: figures(place) for case, place in places.items()}
        yield whom, ours, dict(zip(places, told, strict=True))


def mot_folders(dialect: str, benchmark: str) -> Callable[[Path, Pair], None]:
    """Writes a sequence into TrackEval's folders of MOTChallenge."""

    def write_folders(folder: Path, pair: Pair) -> None:
        (folder / "benchmark").write_text(benchmark)
        write(dialect, folder / GROUND_TRUTH, pair[0])
        # A tracker's eighth column is a class to TrackEval, whatever the benchmark.
        write("mot16", folder / RESULT, pair[1])
        # Tracks of results count from 0, as of trackers that do so.
        rows = [line.split(",") for line in (folder / RESULT).read_text().splitlines()]
        lines = [",".join([row[0], str(int(row[1]) - 1), *row[2:]]) for row in rows]
        (folder / RESULT).write_text("\n".join(lines))

    return write_folders


KITTI = "truth/label_02/0000.txt", "trackers/ours/data/0000.txt"


def kitti_folders(folder: Path, pair: Pair) -> None:
    """Writes a sequence into TrackEval's folders of KITTI."""
    for path, each in zip(KITTI, pair, strict=True):
        write("kitti", folder / path, each)
    seqmap = f"0000 empty 000000 {FRAMES:06d}\n"
    (folder / "truth" / "evaluate_tracking.seqmap.training").write_text(seqmap * 2)


def write(name: str, path: Path, exported: Exported) -> None:
    """A file in a format."""
    path.parent.mkdir(parents=True)
    writes = FORMATS[name].write
    assert writes is not None
    writes(path, exported, no_progress)


def mot_figures(folder: Path) -> Figures:
    """Ours of MOT text, by TrackEval's names."""
    truth, ours = (read_mot(folder / path) for path in (GROUND_TRUTH, RESULT))
    return trackeval_figures(scored(truth, ours))


def mot_figures_by_motmetrics(folder: Path) -> Figures:
    """Ours of MOT text, by py-motmetrics' conventions and names."""
    truth, ours = (read_mot(folder / path) for path in (GROUND_TRUTH, RESULT))
    return motmetrics_figures(scored(truth, ours, Conventions.MOTMETRICS))


def kitti_figures(folder: Path) -> Figures:
    """Ours of KITTI's labels, of people alone, by TrackEval's names."""
    read = FORMATS["kitti"].read
    assert read is not None
    truth, found = (read(folder / path, Filmed()) for path in KITTI)
    people = ~np.isin(truth.columns["track"], list(truth.labels))
    counted = {name: column[people] for name, column in truth.columns.items()}
    return trackeval_figures(scored(counted, found.columns))


def scored(
    truth: Columns, ours: Columns, conventions: Conventions = Conventions.TRACKEVAL
) -> Score:
    """Our score of one sequence."""
    sides = ScoringTable.from_columns(truth, dont_cares=True), ScoringTable.from_columns(ours)
    return score(*sides, None, FRAMES, conventions)


_WITH_CLASSES, _WITH_PLACES = mot_folders("mot16", "MOT17"), mot_folders("mot", "MOT15")
FILES = {
    "TrackEval, MOT text with classes": (TRACKEVAL, "mot", _WITH_CLASSES, mot_figures),
    "TrackEval, MOT text with places": (TRACKEVAL, "mot", _WITH_PLACES, mot_figures),
    "TrackEval, KITTI's labels": (TRACKEVAL, "kitti", kitti_folders, kitti_figures),
    "py-motmetrics, MOT text": (MOTMETRICS, "mot", _WITH_CLASSES, mot_figures_by_motmetrics),
}

if __name__ == "__main__":
    require(TRACKEVAL, MOTMETRICS)
    sys.exit(sweep(attack, 8))
