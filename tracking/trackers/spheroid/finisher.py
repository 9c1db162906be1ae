"""A finished run of the spheroid tracker looked over once more."""

from __future__ import annotations

from tracking.geometry import View
from tracking.trackers.linking import link_run
from tracking.trackers.shared.run_smoother import smooth_run
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run


def finish_run(run: Run, view: View, fps: float, given: Columns | None = None) -> Run:
    """The run with one id for each person, smoothed from both ends; see `link_run`.

    Beyond [Waechter2013]: behind pillars and other people somebody seen by one camera is lost and
    re-identified under a new id, and who meets somebody may be taken for them. Runs made as
    published keep the ids they were given.

    Args:
        given: rows of frames before the run's that stand fast, as corrected by people.
    """
    as_published = bool(run.settings.get("paper", False))
    return (smooth_run if as_published else link_run)(run, view, fps, given)
