"""A finished run with one id for each person's whole stay."""

from __future__ import annotations

from tracking.geometry import View
from tracking.trackers.smoothing import smoothed
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run


def linked(run: Run, view: View, fps: float, given: Columns | None = None) -> Run:
    """The run with what was seen later taken into account, from both ends; see `smoothed`.

    Args:
        view: the camera the boxes were seen by. fps: frames a second.
        given: rows of frames before the run's that stand fast, as corrected by people.
    """
    return smoothed(run, view, fps, given)
