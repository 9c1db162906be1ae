"""The rows of the table that review items are searched in, with what the run noticed of each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats
from tracking.tracks import CLOTHES, Columns, Run, TrackTable, row_keys
from tracking.tracks.run_rows import rows_in_run

Rows = NDArray[np.int64]

BODY_M = 1.7
"""Usual height of a person; where there is no floor, boxes are measured by it."""
NAMES = (
    *("track", "frame", "x", "y", "left", "top", "width", "height"),
    *("predicted", "visibility", "source"),
)
"""Columns of the table that are looked at."""
_ON_FLOOR = 0.5
"""Share of rows with a place on the floor from which on distances are metres of the floor."""
LOOKS = ("height_m", *CLOTHES)


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """The rows of the table, one track behind the other, each track by frame.

    Attributes:
        track, frame: (n,) int64. key: (n,) `row_keys` of both, ascending.
        place: (n, 2) m: on the floor, or, where few rows stand on one, the feet's pixels in units
            of a usual body; NaN where unknown.
        box: (n, 4) left, top, width, height in px. predicted: (n,). visibility: (n,) 0 to 1.
        source: (n,) see `tracking.tracks.Source`.
        looks: (7, n) height in m and the CIELAB of upper and lower body; NaN where not noticed.
        spread_m, split: (n,) of the particles; NaN where not noticed.
        margin: (n,) of the association; NaN where there was none or no other choice.
        failed: (n,) which of the person's parts have failed: 1 head, 2 torso, 4 hip-leg, summed.
        fps: frames a second. stop: one past the footage's last frame that was tracked.
        on_floor: whether places are metres of the floor, not feet in units of a usual body.
    """

    track: Rows
    frame: Rows
    key: Rows
    place: Floats
    box: Floats
    predicted: Flags
    visibility: Floats
    source: NDArray[np.uint8]
    looks: NDArray[np.float32]
    spread_m: NDArray[np.float32]
    split: NDArray[np.float32]
    margin: NDArray[np.float32]
    failed: NDArray[np.int64]
    fps: float
    stop: int
    on_floor: bool = True

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.track)

    @property
    def goes_on(self) -> Flags:
        """(n - 1,) whether a row and the one behind it are of one track."""
        return np.asarray(self.track[1:] == self.track[:-1])

    def row_from(self, track: Rows, frame: Rows) -> Rows:
        """(k,) the first row of each track in or after each frame, or the next track's first."""
        return np.asarray(np.searchsorted(self.key, row_keys(track, frame)), np.int64)

    def later(self, rows: Rows, frames: int) -> Rows:
        """(k,) the same tracks' rows so many frames later, or earlier below 0; -1 for none."""
        wanted = self.key[rows] + frames
        at = np.clip(rows + frames, 0, len(self) - 1)
        missed = np.flatnonzero(self.key[at] != wanted)
        if len(missed):
            found = np.minimum(np.searchsorted(self.key, wanted[missed]), len(self) - 1)
            at[missed] = np.where(self.key[found] == wanted[missed], found, -1)
        return at

    def frames_of(self, seconds: float) -> int:
        """So many seconds in frames, at least one."""
        return max(1, round(seconds * self.fps))


def gather_evidence(table: TrackTable, run: Run | None, fps: float) -> Evidence:
    """The table's rows with what a run noticed of them.

    Args:
        table: the corrected tracks. run: the one they began as, or None. fps: frames a second.
    """
    columns = table.by_track(NAMES)
    stop = max(table.frame_stop, run.frames[1] if run else 0)
    return evidence_of(columns, run, fps, stop, body_px(columns))


def evidence_of(
    columns: Columns, run: Run | None, fps: float, stop: int, usual_px: int
) -> Evidence:
    """Rows with what a run noticed of them.

    Rows are found in the run by what they hold, as edits hand rows from track to track; of rows
    that a person drew the run noticed nothing.

    Args:
        columns: `NAMES`, by track, then frame. usual_px: see `body_px`.
    """
    box = boxes(columns)
    source = rows_in_run(columns, run)
    track = columns["track"].astype(np.int64)
    frame = columns["frame"].astype(np.int64)
    return Evidence(
        track=track,
        frame=frame,
        key=row_keys(track, frame),
        place=_places(columns, box, usual_px),
        box=box,
        predicted=columns["predicted"],
        visibility=np.nan_to_num(columns["visibility"].astype(np.float64), nan=1.0),
        source=columns["source"],
        looks=np.stack([source.signal(name) for name in LOOKS]),
        spread_m=source.signal("spread_m"),
        split=source.signal("split"),
        margin=source.margin(),
        failed=source.failed_parts(),
        fps=fps,
        stop=stop,
        on_floor=not usual_px,
    )


def body_px(columns: Columns) -> int:
    """The usual height of boxes in px where hardly anybody stands on a floor; else 0."""
    x, y, height = columns["x"], columns["y"], columns["height"]
    on_floor = np.isfinite(x) & np.isfinite(y)
    if not len(x) or on_floor.mean() > _ON_FLOOR:
        return 0
    # Whole, so that one box more or less leaves all distances what they were.
    return max(round(float(np.nanmedian(height))), 1) if np.isfinite(height).any() else 1


def boxes(columns: Columns) -> Floats:
    """(n, 4) left, top, width and height in px."""
    return np.stack([columns[name] for name in ("left", "top", "width", "height")], axis=1)


def _places(columns: Columns, box: Floats, usual_px: int) -> Floats:
    """(n, 2) m, or the feet in units of a usual body where hardly anybody stands on a floor."""
    if not usual_px:
        return np.stack((columns["x"], columns["y"]), axis=1)
    feet = np.stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]), axis=1)
    return np.asarray(feet * (BODY_M / usual_px))
