"""The peers' figures kept with the tests: `python -m tests.peers.golden [PAIRS]` makes them anew.

Small sequences are drawn, and some are written by hand; TrackEval and py-motmetrics measure them.
PAIRS is a folder of folders with `truth.txt` and `result.txt`, MOT text: of those only the figures
are kept.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from tests.peers.drawn_sequences import Sequence, drawn
from tests.peers.environments import MOTMETRICS, TRACKEVAL, Peer
from tests.peers.sequences import write_tables

KEPT = Path(__file__).parents[1] / "golden" / "scoring"
SCRIPTS = {TRACKEVAL.name: "trackeval_scores.py", MOTMETRICS.name: "motmetrics_scores.py"}
_DRAWN, _SEED = 12, 20261121
_MOST_ROWS = 400
_BOX = (10.0, 20.0, 8.0, 16.0)


def main() -> None:
    """Write `sequences.json` and a file of each peer's figures."""
    rounded = {
        f"drawn {name}": (np.round(truth, 2), np.round(result, 2))
        for name, (truth, result) in drawn(4 * _DRAWN, _SEED).items()
        if 0 < len(truth) < _MOST_ROWS
    }
    sequences = dict(list(rounded.items())[:_DRAWN]) | by_hand()
    KEPT.mkdir(parents=True, exist_ok=True)
    rows = {name: [_short(side) for side in both] for name, both in sequences.items()}
    _write("sequences.json", rows)
    _write("trackeval.json", told_by(TRACKEVAL, sequences))
    _write("py-motmetrics.json", told_by(MOTMETRICS, sequences))
    if len(sys.argv) > 1:
        pairs = {folder.name: _pair(folder) for folder in sorted(Path(sys.argv[1]).iterdir())}
        trackeval = told_by(TRACKEVAL, pairs)["box"]
        motmetrics = told_by(MOTMETRICS, pairs)["box"]
        _write("public-pairs.json", {"trackeval": trackeval, "py-motmetrics": motmetrics})


def told_by(peer: Peer, sequences: dict[str, Sequence]) -> dict[str, Any]:
    """A scorer's figures by way of matching and sequence."""
    with tempfile.TemporaryDirectory() as folder:
        rows = Path(folder) / "sequences.npz"
        write_tables(rows, sequences)
        told: dict[str, Any] = peer.told(SCRIPTS[peer.name], rows)
    return told


def by_hand() -> dict[str, Sequence]:
    """The cases that are easily got wrong."""
    here, near, there = 0.0, 2.0, 40.0
    two = [_row(frame, person, x) for frame in range(4) for person, x in ((1, here), (2, there))]
    return {
        "nothing": _both([], []),
        "no result": _both(two, []),
        "no truth": _both([], two),
        "a single frame": _both(two[:2], two[:2]),
        "kept partners match fewer": _both(
            # 7 stays with 1 although 1-8 and 2-7 would match both people.
            [_row(0, 1, here), _row(1, 1, here), _row(1, 2, near + 1.0)],
            [_row(0, 7, near - 1.0), _row(1, 7, near), _row(1, 8, here - 2.0)],
        ),
        "equal overlaps": _both(
            [_row(frame, person, x) for frame in range(3) for person, x in ((1, 0.0), (2, 4.0))],
            [_row(frame, 5, 2.0) for frame in range(3)],
        ),
        "everything twice": _both(
            [_row(frame, person, here) for frame in range(3) for person in (1, 2)],
            [_row(frame, 4 + (track + frame) % 2, here) for frame in range(3) for track in (0, 1)],
        ),
        "a don't-care takes its row away": _both(
            [*two[:6], _row(3, 1, here), _row(3, 2, there, 0.0)], [*two, _row(3, 9, 200.0)]
        ),
        "only don't-cares": _both([_row(frame, 1, here, 0.0) for frame in range(3)], two),
        "a frame without rows of the other side": _both(
            [*two, _row(6, 1, here)], [_row(frame, 3 + frame // 3, here) for frame in (0, 1, 4, 6)]
        ),
        "found in exactly four fifths": _both(
            [_row(frame, 1, here) for frame in range(10)],
            [_row(frame, 1, here) for frame in range(8)] + [_row(9, 2, there)],
        ),
    }


def _pair(folder: Path) -> Sequence:
    return _mot_rows(folder / "truth.txt"), _mot_rows(folder / "result.txt")


def _mot_rows(path: Path) -> np.ndarray:
    """Frames and pixels from 0, as the readers of the programs have them."""
    found = np.loadtxt(path, delimiter=",", ndmin=2)
    rows = np.zeros((len(found), 9))
    rows[:, :6] = found[:, :6] - [1, 0, 1, 1, 0, 0]
    rows[:, 8] = found[:, 6]
    return rows[np.argsort(rows[:, 0], kind="stable")]


def _row(frame: int, track: int, x: float, confidence: float = 1.0) -> tuple[float, ...]:
    left, top, width, height = _BOX
    return (frame, track, left + x, top, width, height, x / 10.0, 0.0, confidence)


def _both(truth: list[tuple[float, ...]], result: list[tuple[float, ...]]) -> Sequence:
    return _sorted(truth), _sorted(result)


def _sorted(rows: list[tuple[float, ...]]) -> np.ndarray:
    return np.array(sorted(rows, key=lambda row: row[0]), np.float64).reshape(-1, 9)


def _short(side: np.ndarray) -> list[list[float]]:
    """Whole numbers without a decimal point."""
    return [[int(one) if one.is_integer() else one for one in row] for row in side.tolist()]


def _write(name: str, content: dict[str, Any]) -> None:
    lines = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in content.items()]
    (KEPT / name).write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
