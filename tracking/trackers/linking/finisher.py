"""The finisher of runs: the same steps for every tracker, what differs passed as values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from tracking.geometry import View
from tracking.trackers.shared.run_smoother import PATH_MEMORY_S, smooth_run
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run

Relabel = Callable[[Run, View, float, Columns | None], Run]
Extend = Callable[[Run, View, float], Run]
ExtendInPixels = Callable[[Run, float], Run]


@dataclass(frozen=True, slots=True)
class Published:
    """The settings with which a tracker works as its source does.

    Attributes:
        settings: names and values, any of which suffices; a setting that a run lacks is False.
        smoothed: whether such runs are smoothed; else they stay as they were live.
    """

    settings: tuple[tuple[str, bool], ...]
    smoothed: bool = True

    def has_made(self, settings: Mapping[str, Any]) -> bool:
        """Whether a run with these settings was tracked so."""
        return any(bool(settings.get(name, False)) == value for name, value in self.settings)


@dataclass(frozen=True, slots=True)
class Finisher:
    """How a tracker's finished runs are looked over from both ends: relabel, smooth, extend.

    Attributes:
        relabel: (run, camera, frames a second, rows that stand fast) -> the run with one id for
            each person; None: ids stay as they were live.
        path_memory_s: of the smoothed paths, see `smooth_run`.
        extend: (smoothed run, camera, frames a second) -> the run with people before their first
            row and after the last; None: nobody is added.
        extend_in_pixels: (run, frames a second) -> the same where no floor is known, for trackers
            that need none; None: such runs stay as they were live.
        published: runs of these settings are smoothed at most.
    """

    relabel: Relabel | None = None
    path_memory_s: float = PATH_MEMORY_S
    extend: Extend | None = None
    extend_in_pixels: ExtendInPixels | None = None
    published: Published | None = None

    def finish(self, run: Run, view: View | None, fps: float, given: Columns | None = None) -> Run:
        """The run with what came later taken into account.

        Args:
            view: the camera the boxes were seen by; None: no floor is known.
            fps: frames a second.
            given: rows of frames before the run's that stand fast, as corrected by people.
        """
        published = self.published
        as_published = published is not None and published.has_made(run.settings)
        if view is None:
            extend = None if as_published else self.extend_in_pixels
            return run if extend is None else extend(run, fps)
        if published is not None and as_published:
            return smooth_run(run, view, fps, given) if published.smoothed else run
        if self.relabel is not None:
            run = self.relabel(run, view, fps, given)
        run = smooth_run(run, view, fps, given, memory_s=self.path_memory_s)
        return run if self.extend is None else self.extend(run, view, fps)
