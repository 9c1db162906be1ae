"""Which row of a run each row of the corrected table is."""

from __future__ import annotations

import numpy as np

from tracking.tracks.columns import (
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    empty,
    typed,
)
from tracking.tracks.run import Particles, Run
from tracking.tracks.run_rows import rows_in_run, run_within


def _rows(frames: range, track: int = 1, left: float = 10.0) -> Columns:
    count = len(frames)
    values = {name: np.zeros(count) for name in TRACK_COLUMNS}
    values |= {"frame": np.array(frames), "track": np.full(count, track)}
    values |= {"left": left + np.arange(count), "width": np.full(count, 20.0)}
    return typed(values, TRACK_COLUMNS)


def _run(tracks: Columns) -> Run:
    return Run(
        tracker="flow",
        settings={},
        seed=0,
        frames=(0, 20),
        tracks=tracks,
        detections=empty(DETECTION_COLUMNS),
        particles=Particles(np.zeros(21, np.int64), empty(PARTICLE_COLUMNS)),
    )


def test_rows_are_found_by_what_they_hold_also_under_another_id() -> None:
    run = _run(_rows(range(5, 10)))
    swapped = {**_rows(range(5, 10)), "track": np.full(5, 7, np.int32)}
    assert rows_in_run(swapped, run).row.tolist() == [0, 1, 2, 3, 4]


def test_rows_somebody_moved_are_of_no_run() -> None:
    assert rows_in_run(_rows(range(5, 10), left=400.0), _run(_rows(range(5, 10)))).row.max() == -1


def test_where_a_run_has_nobody_rows_are_of_no_run() -> None:
    nowhere = run_within(_run(_rows(range(5, 10))), 0, 5)
    found = rows_in_run(_rows(range(5)), nowhere)
    assert (found.row == -1).all()
    assert np.isnan(found.margin()).all()
    assert not found.failed_parts().any()
    assert np.isnan(found.signal("jump")).all()
