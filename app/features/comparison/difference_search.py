"""Finding what differs between two versions of the tracks, in any thread."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial

from tracking.editing import (
    Difference,
    History,
    compare_runs,
    compare_to_table,
    find_protected,
)
from tracking.progress import Progress
from tracking.session import Session
from tracking.tracks import Labels, Run, TrackTable


@dataclass(frozen=True, slots=True, eq=False)
class ComparisonResult:
    """What comparing gave.

    Attributes:
        differences: by time. base: the version that is drawn solid.
        dashed: the run's rows under the ids of the base.
    """

    differences: tuple[Difference, ...]
    base: TrackTable
    dashed: TrackTable


def search_in(
    session: Session, run: int, base: int | None, frames: tuple[int, int] | None, fps: float
) -> Callable[[Progress], ComparisonResult]:
    """What compares a run with another one, or (base None) with the tracks as they are now."""
    if base is not None:
        return partial(_two_runs, session.runs[base], session.runs[run], fps)
    table, labels, history = session.tracks.snapshot(), session.labels, session.history.snapshot()
    return partial(_with_tracks, (table, labels, history), session.runs[run], frames, fps)


def _two_runs(base: Run, run: Run, fps: float, report: Progress) -> ComparisonResult:
    found, solid, dashed = compare_runs(base, run, fps=fps, progress=report)
    return ComparisonResult(_by_time(found), solid, dashed)


def _with_tracks(
    corrected: tuple[TrackTable, Labels, History],
    run: Run,
    frames: tuple[int, int] | None,
    fps: float,
    report: Progress,
) -> ComparisonResult:
    report(0, 1)
    protection = find_protected(*corrected, fps=fps)
    table = corrected[0]
    found, rows = compare_to_table(table, run, frames, protection, fps=fps, progress=report)
    return ComparisonResult(_by_time(found), table, TrackTable(rows))


def _by_time(found: Iterable[Difference]) -> tuple[Difference, ...]:
    return tuple(sorted(found, key=lambda one: one.start))
