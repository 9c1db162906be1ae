"""Public detections beside some recordings: trackers of others over them, and ours."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.command import tell
from tests.benchmarks.footage.measures import Figures, box_figures
from tests.benchmarks.footage.recordings import Footage
from tests.benchmarks.runner import Case
from tests.peers.environments import TRACKERS
from tests.peers.follow_boxes import FOLLOWED
from tests.peers.sequences import read_tables, write_tables

DETECTIONS = "detections.txt"


def follow_public_detections(footage: Sequence[Footage]) -> dict[str, dict[str, Figures]]:
    """Figures by recording and tracker; none where the trackers are not installed."""
    seen = {one.name: _seen(one) for one in footage if has_detections(one)}
    if not seen:
        return {}
    if not TRACKERS.installed:
        tell(f"{TRACKERS.absent}: nobody is compared on public detections")
        return {}
    with tempfile.TemporaryDirectory() as folder:
        given, told = Path(folder) / "given.npz", Path(folder) / "told.npz"
        write_tables(given, seen)
        TRACKERS.run("follow_boxes.py", given, told)
        followed = read_tables(told)
    return {
        one.name: {
            tracker: box_figures(one, dict(zip(FOLLOWED, np.array(rows[one.name]).T, strict=True)))
            for tracker, rows in followed.items()
        }
        for one in footage
        if one.name in seen
    }


def with_detections(cases: Sequence[Case]) -> list[Case]:
    """The same with the public detections beside a recording."""
    given = ("detections.file", DETECTIONS)
    return [
        replace(case, settings=(*case.settings, given), name=f"{case} with detections")
        for case in cases
    ]


def has_detections(footage: Footage) -> bool:
    return footage.labelled and (footage.folder / DETECTIONS).is_file()


def _seen(footage: Footage) -> tuple[int, float, NDArray[np.float64]]:
    """Frames, frames a second, and (n, 6) by `follow_boxes.SEEN`."""
    with footage.open() as recording:
        frames, fps = recording.frame_count, recording.fps
    table = np.loadtxt(footage.folder / DETECTIONS, delimiter=",", ndmin=2)
    # Frames and pixels of MOT text count from 1; there is no id yet.
    rows = np.column_stack([table[:, 0] - 1, table[:, 2:4] - 1, table[:, 4:7]])
    return frames, fps, rows[np.argsort(rows[:, 0], kind="stable")]
