"""The parts that a run saw of a person, under the id the person has by now."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.review.run_rows import rows_in_run
from tracking.tracks import PART_COLUMNS, Columns, Run, between, empty


def parts_behind(rows: Columns, run: Run | None) -> Columns:
    """`PART_COLUMNS` of whoever stands in some rows, with the ids they have there.

    An edit hands rows from track to track; what the run saw of the parts goes with them. Rows that
    a person drew or moved have none.

    Args:
        rows: of one track, or of one frame; at least `frame, track, left, top, x, y`.
        run: the one the rows began as.
    """
    if run is None or not len(run.parts["frame"]) or not len(rows["frame"]):
        return empty(PART_COLUMNS)
    first, stop = int(rows["frame"].min()), int(rows["frame"].max()) + 1
    near = between(run.tracks["frame"], first, stop)
    made = {name: column[near] for name, column in run.tracks.items()}
    keys = rows_in_run(rows, replace(run, tracks=made)).key
    seen = between(run.parts["frame"], first, stop)
    parts = {name: column[seen] for name, column in run.parts.items()}
    return _renamed(parts, keys, rows["track"])


def _renamed(parts: Columns, keys: NDArray[np.int64], ids: NDArray[np.int32]) -> Columns:
    """The parts whose track and frame are among the keys, each with the id that stands there."""
    known = keys >= 0
    wanted, ids = keys[known], ids[known]
    order = np.argsort(wanted, kind="stable")
    wanted, ids = wanted[order], ids[order]
    own = (parts["track"].astype(np.int64) << 32) + parts["frame"]
    at = np.searchsorted(wanted, own)
    at = np.minimum(at, max(len(wanted) - 1, 0))
    mine = wanted[at] == own if len(wanted) else np.zeros(len(own), bool)
    kept = {name: column[mine] for name, column in parts.items()}
    return {**kept, "track": ids[at[mine]].astype(np.int32) if len(wanted) else kept["track"]}
