"""A finished run of the three-part trackers looked over once more."""

from __future__ import annotations

from tracking.geometry import View
from tracking.trackers.linking import link_run
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run

_OURS = ("adjust", "reidentify")


def finish_run(run: Run, view: View, fps: float, given: Columns | None = None) -> Run:
    """The run with one id for each person, smoothed from both ends; see `link_run`.

    Beyond [ZhaoLee2009], so runs without our re-identification stay as they were tracked. Parts
    keep their places and go with the ids.

    Args:
        given: rows of frames before the run's that stand fast, as corrected by people.
    """
    if not all(run.settings.get(name, False) for name in _OURS):
        return run
    return link_run(run, view, fps, given)
