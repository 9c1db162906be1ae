"""How long all measures of a result take, beside other scorers: 20 people over 10,000 frames."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tests.peers.environments import HERE, MOTRICS, TRACKEVAL, Peer
from tests.peers.sequences import write_sequences

PEOPLE, FRAMES = 20, 10_000
_ROUNDS = 5
_SAME = 1e-9

Run = dict[str, float]
"""`seconds` of processor time, `peak_kib` of the process, and MOTA, IDF1 and HOTA."""


def walkers(people: int, frames: int) -> tuple[np.ndarray, np.ndarray]:
    """People on circles that cross, and a tracker that misses, mistakes and imagines some."""
    generator = np.random.default_rng(20)
    frame = np.repeat(np.arange(frames), people)
    person = np.tile(np.arange(1, people + 1), frames)
    angle = frame * (0.002 + 0.0005 * person) + person
    box = np.full((len(frame), 4), (0.0, 0.0, 50.0, 140.0))
    box[:, 0], box[:, 1] = 960 + 800 * np.cos(angle), 400 + 300 * np.sin(1.3 * angle)
    seen = generator.random(len(frame)) > 0.05
    track = person + people * (frame // (700 + 37 * person))
    noisy = box + generator.normal(0.0, 4.0, box.shape)
    imagined = np.full((frames, 4), (0.0, 0.0, 50.0, 140.0))
    imagined[:, :2] = generator.uniform(0.0, (1800.0, 900.0), (frames, 2))
    found = np.concatenate(
        [
            _rows(frame[seen], track[seen], noisy[seen]),
            _rows(np.arange(frames), 100_000 + np.arange(frames) // 20, imagined),
        ]
    )
    return _rows(frame, person, box), found[np.argsort(found[:, 0], kind="stable")]


def _rows(frame: np.ndarray, track: np.ndarray, box: np.ndarray) -> np.ndarray:
    rest = np.tile((0.0, 0.0, 1.0), (len(frame), 1))
    return np.column_stack([frame, track, np.round(box, 2), rest])


def measure() -> dict[str, float | None]:
    """`ms` of processor time; our least time and peak of memory over each peer's least.

    Every run is a process of its own on one thread; the peers take turns with us. A peer that is
    not installed (`python -m tests.peers`) is not measured.
    """
    peers = [peer for peer in (TRACKEVAL, MOTRICS) if _there(peer)]
    with tempfile.TemporaryDirectory() as folder:
        sequence = Path(folder) / "sequence.npz"
        write_sequences(sequence, {"walkers": walkers(PEOPLE, FRAMES)})
        rounds = [_round(sequence, peers) for _ in range(_ROUNDS)]
    ours = [own for own, _ in rounds]
    figures: dict[str, float | None] = {"ms": 1000.0 * _least(ours, "seconds")}
    for peer in (TRACKEVAL, MOTRICS):
        theirs = [told[peer.name] for _, told in rounds if peer.name in told]
        figures[f"vs_{peer.name}"] = _ratio(ours, theirs, "seconds")
        figures[f"memory_vs_{peer.name}"] = _ratio(ours, theirs, "peak_kib")
    return figures


def _ratio(ours: list[Run], theirs: list[Run], quantity: str) -> float | None:
    return _least(ours, quantity) / _least(theirs, quantity) if theirs else None


def _least(runs: list[Run], quantity: str) -> float:
    """Other work on the machine only ever adds."""
    return min(run[quantity] for run in runs)


def _there(peer: Peer) -> bool:
    if not peer.installed:
        print(peer.absent, file=sys.stderr)
    return peer.installed


def _round(sequence: Path, peers: list[Peer]) -> tuple[Run, dict[str, Run]]:
    """Ourselves once, and each peer once."""
    ours = _ours(sequence)
    theirs: dict[str, Run] = {}
    for peer in peers:
        told: Run = peer.told("timed.py", peer.name, sequence)
        apart = max(abs(told[name] - ours[name]) for name in ("IDF1", "HOTA"))
        if apart > _SAME:
            raise RuntimeError(f"{peer.name} measures something else: {told}, we {ours}")
        theirs[peer.name] = told
    return ours, theirs


def _ours(sequence: Path) -> Run:
    command = [sys.executable, HERE / "timed.py", "ours", sequence]
    one_thread = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    ended = subprocess.run(command, env=os.environ | one_thread, capture_output=True, check=True)
    told: Run = json.loads(ended.stdout)
    return told
