"""What is true of a rendered clip: who stands where, and how much of them is seen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring import ScoringTable
from tracking.truth.true_parts import VISIBILITY, read_visibility

Columns = Mapping[str, NDArray[np.generic]]
Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]

SEEN = 0.3
"""Share of a person from which on it counts: less is a don't-care in truth.txt."""


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """Everybody of whom anything is seen, by frame.

    Attributes:
        frame, person: (n,) from 0; ids.
        box: (n, 4) left, top, width, height in px of the whole person, hidden or outside too.
        place: (n, 2) x, y in metres.
        share: (n,) of the person that is seen.
        columns: the same as read from truth.txt.
        size: width and height of the picture.
        fps: frames a second.
    """

    frame: Integers
    person: Integers
    box: Floats
    place: Floats
    share: Floats
    columns: Columns
    size: tuple[int, int]
    fps: float

    @property
    def table(self) -> ScoringTable:
        """As it is scored, with don't-cares."""
        return ScoringTable.from_columns(dict(self.columns), dont_cares=True)

    def of(self, person: int, first: int, last: int) -> Integers:
        """Rows of a person within frames, both included."""
        start, end = np.searchsorted(self.frame, (first, last + 1))
        return np.asarray(start + np.flatnonzero(self.person[start:end] == person))

    def beside(self, row: int) -> Integers:
        """Rows of everybody else in that row's frame."""
        start, end = np.searchsorted(self.frame, (self.frame[row], self.frame[row] + 1))
        rows = np.arange(start, end)
        return np.asarray(rows[rows != row])


def truth_of(folder: Path) -> Truth:
    """The truth beside a rendered recording."""
    with open_recording(folder) as recording:
        size, fps = recording.size, recording.fps
    columns = read_mot(folder / "truth.txt")
    order = np.lexsort((columns["track"], columns["frame"]))
    columns = {name: column[order] for name, column in columns.items()}
    return Truth(
        frame=columns["frame"].astype(np.int64),
        person=columns["track"].astype(np.int64),
        box=np.column_stack([columns[name] for name in ("left", "top", "width", "height")]),
        place=np.column_stack([columns["x"], columns["y"]]),
        share=_shares(folder, columns),
        columns=columns,
        size=size,
        fps=fps,
    )


def visible_for(truth: Truth, seconds: float) -> frozenset[int]:
    """Who is seen, at least three tenths of them, for so long without a break."""
    least = round(seconds * truth.fps)
    seen = truth.share >= SEEN
    found = set()
    for person in np.unique(truth.person[seen]).tolist():
        frames = truth.frame[seen & (truth.person == person)]
        breaks = np.flatnonzero(np.diff(frames) > 1)
        ends = np.concatenate(([-1], breaks, [len(frames) - 1]))
        if np.diff(ends).max() >= least:
            found.add(person)
    return frozenset(found)


def _shares(folder: Path, columns: Columns) -> Floats:
    """(n,) what is seen of each row of the truth."""
    seen = read_visibility(folder / VISIBILITY)
    known = dict(
        zip(zip(seen.frame.tolist(), seen.person.tolist(), strict=True), seen.share, strict=True)
    )
    rows = zip(columns["frame"].tolist(), columns["track"].tolist(), strict=True)
    return np.array([known.get(row, 0.0) for row in rows], float)
