"""Frames that come unevenly, counted in ticks of even time for whoever looks a run over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.recording import Recording
from tracking.tracks import Columns, Run

Finish = Callable[[Run, View, float, Columns | None], Run]
Ticks = NDArray[np.int64]

_LONGEST_S = 20.0
"""Between two frames; more is as much: nobody is waited for so long, and times may be nonsense."""
_TABLES = ("tracks", "detections", "associations", "signals", "parts")


def ticks_of(recording: Recording) -> Ticks | None:
    """(frame_count,) when each frame came, in frames at the recording's rate, increasing.

    None where they come evenly, or too far apart to be counted. Each frame has a tick of its own,
    so that two that follow each other at once are a frame apart.
    """
    times_s = recording.uneven_times_s
    if times_s is None:
        return None
    between_s = np.diff(times_s, prepend=times_s[:1]).clip(0.0, _LONGEST_S)
    number = np.arange(len(times_s))
    nearest = np.rint(np.cumsum(between_s) * recording.fps).astype(np.int64)
    ticks = np.asarray(np.maximum.accumulate(nearest - number) + number)
    return ticks if ticks[-1] <= np.iinfo(np.int32).max else None


def finished(
    finish: Finish, run: Run, view: View, fps: float, given: Columns | None, ticks: Ticks | None
) -> Run:
    """The run looked over by a tracker's `finish`, which takes frames for even time.

    Where they are not, it sees ticks for frames, and rows that it adds where no frame was recorded
    are left out again. Runs with tracklets are seen as they are: points are followed from one
    frame to the next one, whenever that came.

    Args:
        given: rows of earlier frames that stand fast. ticks: of the recording, see `ticks_of`.
    """
    if ticks is None or len(run.tracklets.columns["track"]):
        return finish(run, view, fps, given)
    first, stop = run.frames
    even = _with_tables(run, lambda table: _at_ticks(table, ticks))
    if stop > first:
        even = replace(even, frames=(int(ticks[first]), int(ticks[stop - 1]) + 1))
    found = finish(even, view, fps, None if given is None else _at_ticks(given, ticks))
    found = _with_tables(found, lambda table: _recorded(table, ticks))
    return replace(found, frames=run.frames)


def _with_tables(run: Run, changed: Callable[[Columns], Columns]) -> Run:
    """The run with the tables that tell frames changed."""
    tables: dict[str, Any] = {name: changed(getattr(run, name)) for name in _TABLES}
    return replace(run, **tables)


def _at_ticks(table: Columns, ticks: Ticks) -> Columns:
    """The same rows at the ticks of their frames."""
    return {**table, "frame": ticks[table["frame"]].astype(table["frame"].dtype)}


def _recorded(table: Columns, ticks: Ticks) -> Columns:
    """The rows at ticks when a frame was recorded, at these frames."""
    frame = np.searchsorted(ticks, table["frame"])
    rows = np.flatnonzero(ticks[np.minimum(frame, len(ticks) - 1)] == table["frame"])
    own = {name: column[rows] for name, column in table.items()}
    return {**own, "frame": frame[rows].astype(table["frame"].dtype)}
