"""A session's part labels with what the tracker saw: samples of the failure detector."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.failure import Samples, no_samples, samples_of
from tracking.review.run_rows import rows_in_run
from tracking.tracks import Columns, Labels, Run, TrackTable

_TELLING = ("frame", "track", "left", "top", "x", "y")
"""Columns by which a row of the corrected table is found in the run it came from."""


def samples_from(
    labels: Labels, tracks: TrackTable, run: Run | None, fps: float, recording: str
) -> Samples:
    """The samples that labels give with the run the tracks began as; fps and name of the recording.

    No samples without labels, or where the run followed no parts.
    """
    if run is None or not len(labels.parts) or not len(run.parts["frame"]):
        return no_samples()
    people = {label.track for label in labels.parts.values()}
    parts = parts_as_corrected(tracks, people, run)
    return samples_of(labels.parts.values(), parts, fps, recording)


def parts_as_corrected(tracks: TrackTable, people: set[int], run: Run) -> Columns:
    """The run's parts of some people, under the ids these have by now.

    A row that went from track to track keeps its box and is found by it; one whose box somebody
    moved is taken for the run's row of its own id and frame, unless another of them has that.

    Returns:
        `PART_COLUMNS` of the rows whose person is among `people`.
    """
    rows = tracks.by_track(_TELLING, people)
    key = rows_in_run(rows, run).key
    own = _keys(rows["track"], rows["frame"])
    key = np.where((key < 0) & ~np.isin(own, key), own, key)
    known = np.flatnonzero(key >= 0)
    known = known[np.argsort(key[known], kind="stable")]
    asked = _keys(run.parts["track"], run.parts["frame"])
    at = np.minimum(np.searchsorted(key[known], asked), max(len(known) - 1, 0))
    found = (key[known][at] == asked) if len(known) else np.zeros(len(asked), bool)
    parts = {name: column[found] for name, column in run.parts.items()}
    parts["track"] = rows["track"][known[at[found]]].astype(np.int32)
    return parts


def _keys(track: NDArray[np.integer], frame: NDArray[np.integer]) -> NDArray[np.int64]:
    return (track.astype(np.int64) << 32) + frame
