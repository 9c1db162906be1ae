"""Exact truth of a rendered clip as tables by frame and person."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

PARTS = ("head", "torso", "hip_leg")

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """Where everybody's parts are; f frames, n people, NaN where somebody is not seen.

    Attributes:
        track: (n,) ids.
        parts: (f, n, 3, 4) left, top, right, bottom in px, hidden or not.
        visibility: (f, n) share of the person that is seen; 0 where not.
        size_px: width and height of the pictures.
    """

    track: NDArray[np.int32]
    parts: Floats
    visibility: Floats
    size_px: tuple[int, int]

    @property
    def people(self) -> Floats:
        """(f, n, 4) left, top, right, bottom of whole people."""
        return bounding(self.parts)

    @property
    def whole(self) -> Bools:
        """(f, n) whether all of somebody lies in the picture."""
        box = self.people
        width, height = self.size_px
        inside = (box[..., 0] >= 0) & (box[..., 1] >= 0)
        return np.asarray(
            inside & (box[..., 2] <= width - 1) & (box[..., 3] <= height - 1), np.bool_
        )


def bounding(corners: Floats) -> Floats:
    """The smallest boxes (..., 4) round several (..., k, 4); NaN where one of them is."""
    return np.concatenate((corners[..., :2].min(axis=-2), corners[..., 2:].max(axis=-2)), axis=-1)


def read_truth(folder: Path, frames: int, size_px: tuple[int, int]) -> Truth:
    """The truth beside a rendered clip of so many frames."""
    rows = list(_rows(folder / "truth_parts.csv"))
    ids = np.unique([int(row[1]) for row in rows]).astype(np.int32)
    parts = np.full((frames, len(ids), len(PARTS), 4), np.nan)
    for frame, track, part, left, top, width, height, _ in rows:
        low = float(left), float(top)
        place = int(frame), int(np.searchsorted(ids, int(track))), PARTS.index(part)
        parts[place] = (*low, low[0] + float(width), low[1] + float(height))
    seen = np.zeros((frames, len(ids)))
    for frame, track, share in _rows(folder / "visibility.csv"):
        seen[int(frame), np.searchsorted(ids, int(track))] = float(share)
    return Truth(ids, parts, seen, size_px)


def _rows(path: Path) -> Iterable[list[str]]:
    lines = path.read_text(encoding="utf-8").splitlines()[1:]
    return (line.split(",") for line in lines)
