"""Frames that others are missing between, counted in ticks for whoever looks a run over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.recording import Recording
from tracking.tracks import Columns, Particles, Run

Finish = Callable[[Run, View | None, float, Columns | None], Run]

_LONGEST_S = 20.0
"""Between two frames; more is as much: nobody is waited for so long, and times may be nonsense."""
_MOST = 10_000_000
"""Ticks; more are nonsense, or no time in which to look for anybody."""
_TABLES = ("tracks", "detections", "associations", "signals", "parts", "embeddings")


@dataclass(frozen=True, slots=True, eq=False)
class Ticks:
    """When frames came, counted so that frames missing between two are made up for.

    Attributes:
        of_frame: (frame_count,) increasing numbers of ticks from 0, as many a second as the
            recording has frames. Each frame has its own: where they follow each other sooner than
            usual, they are a tick apart, too, as whoever counts rows expects.
    """

    of_frame: NDArray[np.int64]

    @classmethod
    def of(cls, recording: Recording) -> Ticks | None:
        """The ticks of a recording; None where frames come evenly, or too far apart to count."""
        times_s, fps = recording.uneven_times_s, recording.fps
        if times_s is None:
            return None
        between_s = np.diff(times_s).clip(0.0, max(_LONGEST_S, 1.0 / fps))
        steps = np.maximum(np.rint(between_s * fps).astype(np.int64), 1)
        of_frame = np.concatenate(([0], np.cumsum(steps)))
        return cls(of_frame) if of_frame[-1] <= _MOST else None

    def to_ticks(self, table: Columns) -> Columns:
        """The rows of a table at the ticks of their frames."""
        return {**table, "frame": self.of_frame[table["frame"]].astype(table["frame"].dtype)}

    def recorded(self, table: Columns) -> Columns:
        """The rows at ticks when a frame was recorded, at these frames."""
        frame = np.searchsorted(self.of_frame, table["frame"])
        nearest = self.of_frame[np.minimum(frame, len(self.of_frame) - 1)]
        rows = np.flatnonzero(nearest == table["frame"])
        own = {name: column[rows] for name, column in table.items()}
        return {**own, "frame": frame[rows].astype(table["frame"].dtype)}

    def particles_to_ticks(self, particles: Particles) -> Particles:
        """The particles by tick; none at ticks without a frame."""
        tick = np.arange(self.of_frame[-1] + 2)
        frame = np.searchsorted(self.of_frame, tick)
        start = particles.start[np.minimum(frame, len(particles.start) - 1)]
        return Particles(start, particles.columns)


def finish_with_ticks(
    finish: Finish,
    run: Run,
    view: View | None,
    fps: float,
    given: Columns | None,
    ticks: Ticks | None,
) -> Run:
    """The run finished by a tracker's `finish`, which takes frames for even time.

    Where some are missing, it sees ticks for frames, and rows that it adds where no frame was
    recorded are left out again. Runs with tracklets are seen as they are: points are followed from
    one frame to the next one, whenever that came.

    Args:
        view: the camera on its floor; None: no floor is known.
        given: rows of earlier frames that stand fast. ticks: of the recording, if there are any.
    """
    first, stop = run.frames
    if ticks is None or stop <= first or len(run.tracklets.columns["track"]):
        return finish(run, view, fps, given)
    even = replace(
        _with_tables(run, ticks.to_ticks),
        frames=(int(ticks.of_frame[first]), int(ticks.of_frame[stop - 1]) + 1),
        particles=ticks.particles_to_ticks(run.particles),
        part_particles=ticks.particles_to_ticks(run.part_particles),
    )
    found = finish(even, view, fps, None if given is None else ticks.to_ticks(given))
    return replace(
        _with_tables(found, ticks.recorded),
        frames=run.frames,
        particles=Particles(run.particles.start, found.particles.columns),
        part_particles=Particles(run.part_particles.start, found.part_particles.columns),
    )


def _with_tables(run: Run, changed: Callable[[Columns], Columns]) -> Run:
    """The run with the tables that hold frames changed."""
    tables: dict[str, Any] = {name: changed(getattr(run, name)) for name in _TABLES}
    return replace(run, **tables)
