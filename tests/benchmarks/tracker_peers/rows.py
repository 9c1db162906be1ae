"""Figures of a tracker over clips, the same for all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.tracker_peers.clips import Clip
from tests.peers.followers import Followed
from tracking.scoring import FloorMatch, ScoringTable, combined, score

RADIUS_M = 0.5
"""A row is a person's at most this far from where the person stands."""


@dataclass(frozen=True, slots=True)
class Figures:
    """What is told of a tracker over all clips together.

    Attributes:
        id_switches, people, kept: counts; `kept` as in the papers' tracking accuracy.
        idf1, hota, mota, tracking_accuracy: shares.
        floor_error_m: mean distance of matched rows.
        ms: mean milliseconds of processor time a frame.
    """

    id_switches: int
    people: int
    kept: int
    idf1: float
    hota: float
    mota: float
    tracking_accuracy: float
    floor_error_m: float
    ms: float


@dataclass(frozen=True, slots=True)
class PeerRow:
    """A tracker beside the others.

    Attributes:
        tracker: its name.
        ours: whether it is one of the catalogue's.
        colour: whether it was given colours.
        finished: whether the run was looked over as a whole; else rows are told as frames come.
        figures: None where it could not be measured.
        absent: why not; "" where it was.
    """

    tracker: str
    ours: bool
    colour: bool
    finished: bool
    figures: Figures | None
    absent: str = ""


def figures_of(clips: Sequence[Clip], followed: Mapping[str, Followed]) -> Figures:
    """The figures of rows by the names of the clips, matched on the floor."""
    match = FloorMatch(RADIUS_M)
    scores = [score(clip.truth, _table(followed[clip.name][0]), match) for clip in clips]
    told = combined(scores)
    seconds = sum(float(followed[clip.name][1].sum()) for clip in clips)
    return Figures(
        id_switches=told.clear.id_switches,
        people=told.people.detected,
        kept=told.people.kept,
        idf1=told.identity.idf1,
        hota=told.hota.hota,
        mota=told.clear.mota,
        tracking_accuracy=told.tracking_accuracy,
        floor_error_m=float(told.position_error.distances_m.mean()),
        ms=1000.0 * seconds / sum(len(clip.observations) for clip in clips),
    )


def _table(rows: NDArray[np.float64]) -> ScoringTable:
    unknown = np.full(len(rows), np.nan)
    return ScoringTable.from_columns(
        {
            "frame": rows[:, 0].astype(np.int64),
            "track": rows[:, 1].astype(np.int64),
            **dict.fromkeys(("left", "top", "width", "height"), unknown),
            "x": rows[:, 2],
            "y": rows[:, 3],
        }
    )
