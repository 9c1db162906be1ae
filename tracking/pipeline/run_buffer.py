"""What a tracker found so far, kept in little memory however long the footage is."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import tracking
from tracking.pipeline.spool import IN_MEMORY_BYTES, Spool
from tracking.pipeline.spool_tables import SpooledTable
from tracking.pipeline.ticks import Ticks, finish_with_ticks
from tracking.recording import Recording
from tracking.trackers import (
    ASSOCIATION_COLUMNS,
    Resume,
    StepResult,
    detector_of,
    tracker_named,
)
from tracking.tracks import (
    DETECTION_COLUMNS,
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    Run,
    empty,
)
from tracking.tracks.growable_columns import GrowingTable

_log = logging.getLogger(__name__)
_SPOOLED = {
    "detections": DETECTION_COLUMNS,
    "associations": ASSOCIATION_COLUMNS,
    "signals": SIGNAL_COLUMNS,
    "parts": PART_COLUMNS,
    "particles": PARTICLE_COLUMNS,
    "part_particles": PART_PARTICLE_COLUMNS,
    "tracklets": TRACKLET_COLUMNS,
    "network_boxes": NETWORK_BOX_COLUMNS,
    "embeddings": EMBEDDING_COLUMNS,
}
_WAITING = 32
"""Steps are put into the tables by so many: one by one would take several times as long."""
_TIED_S = 1.0
"""Of corrected tracks before the first frame, which smoothed tracks begin at."""


class KeptSteps:
    """The steps of a tracker in order: the tracks in memory, all else in a spool.

    Particles take 16 bits a value there: positions are rounded to 1/1024 m, at most 0.5 mm off,
    weights to half precision (11 bits), at most 0.05 percent off. `add` and `run` belong to one
    thread, everything else may be asked by another one meanwhile.
    """

    def __init__(
        self, folder: Path | None = None, first: int = 0, in_memory: int = IN_MEMORY_BYTES
    ) -> None:
        """Nothing yet.

        Args:
            folder, in_memory: where what is too much for the memory is put aside, and from how
                many bytes on; see `Spool`.
            first: the frame where steps are to begin; they tell it themselves once they come.
        """
        self._spool = Spool(folder, in_memory)
        self._tracks = GrowingTable(TRACK_COLUMNS)
        self._spooled = {n: SpooledTable(self._spool, n, types) for n, types in _SPOOLED.items()}
        self._first = first
        # How many steps are in the tables, and those behind them: replaced together.
        self._state: tuple[int, list[StepResult]] = (0, [])

    @property
    def frames(self) -> tuple[int, int]:
        """The half-open range of frames so far."""
        settled, waiting = self._state
        return self._first, self._first + settled + len(waiting)

    def add(self, steps: Iterable[StepResult]) -> None:
        """Take further steps. Raises OutputError where there is no room for their particles."""
        for step in steps:
            settled, waiting = self._state
            if not settled and not waiting:
                self._first = step.frame
            waiting.append(step)
            if len(waiting) >= _WAITING:
                self._settle()

    def rows(self, table: str, start: int, stop: int) -> Columns:
        """The rows of some frames (half-open) in one of the tables of a `StepResult`.

        Raises OutputError where the disk fails.
        """
        parts = self.parts(table, start, stop)
        if len(parts) == 1:
            return parts[0]
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def parts(self, table: str, start: int, stop: int) -> list[Columns]:
        """The same in pieces one behind the other, without a copy of tables in memory."""
        settled, waiting = self._state
        until = settled + len(waiting)
        low, high = (min(max(0, frame - self._first), until) for frame in (start, stop))
        stored = self._tracks if table == "tracks" else self._spooled[table]
        early = stored.rows(min(low, settled), min(max(low, high), settled))
        late = waiting[max(0, low - settled) : max(0, high - settled)]
        return [early, *(getattr(step, table) for step in late)]

    def run(
        self,
        tracker: str,
        settings: Mapping[str, Any],
        seed: int,
        recording: Recording,
        resume: Resume | None = None,
        *,
        finish: bool = True,
    ) -> Run:
        """All so far as one immutable run; see `run_of_steps`.

        Args:
            finish: False: the tracks stay as the tracker gave them, whatever the settings say.
        """
        self._settle()
        first, stop = self.frames
        stored, count = self._spooled, recording.frame_count
        run = Run(
            tracker=tracker,
            settings=settings,
            seed=seed,
            frames=(first, stop),
            tracks=self._tracks.columns,
            detections=stored["detections"].columns(),
            particles=stored["particles"].particles(first, count),
            associations=stored["associations"].columns(),
            signals=stored["signals"].columns(),
            parts=stored["parts"].columns(),
            part_particles=stored["part_particles"].particles(first, count),
            tracklets=stored["tracklets"].particles(first, count),
            embeddings=stored["embeddings"].columns(),
            network_boxes=stored["network_boxes"].particles(first, count),
            software=f"trackwright {tracking.__version__}",
            detector=detector_of(tracker, settings),
            known_tracks=resume.highest_track if resume is not None else 0,
        )
        if finish:
            return _finished(run, recording, resume)
        return replace(run, embeddings=empty(EMBEDDING_COLUMNS))

    def run_so_far(
        self,
        tracker: str,
        settings: Mapping[str, Any],
        seed: int,
        recording: Recording,
        resume: Resume | None = None,
    ) -> Run | None:
        """The run of a tracker that could not go on; None: nothing can be kept of it.

        Where finishing is what fails, the tracks are as the tracker gave them.
        """
        for finish in (True, False):
            try:
                run = self.run(tracker, settings, seed, recording, resume, finish=finish)
            except Exception:  # it has failed already: what can be kept counts
                _log.info("the run so far cannot be made", exc_info=True)
            else:
                return run if run.frames[0] < run.frames[1] else None
        return None

    def _settle(self) -> None:
        """Put what waits into the tables; where there is no room, it is lost as a whole.

        Raises OutputError then; the tables hold what they held before.
        """
        settled, waiting = self._state
        if not waiting:
            return
        try:
            for name, table in self._spooled.items():
                table.extend([getattr(step, name) for step in waiting])
            self._tracks.extend([step.tracks for step in waiting])
        except BaseException:
            for table in self._spooled.values():
                table.cut(settled)
            self._state = (settled, [])
            raise
        self._state = (settled + len(waiting), [])


def _finished(run: Run, recording: Recording, resume: Resume | None) -> Run:
    """The run finished, where its settings want it; without embeddings, which are for that."""
    bare = replace(run, embeddings=empty(EMBEDDING_COLUMNS))
    if not run.settings.get("smooth"):
        return bare
    given = resume.last(_TIED_S) if resume is not None else None
    finisher = tracker_named(run.tracker).finisher.finish
    finished = finish_with_ticks(
        finisher, run, recording.view, recording.fps, given, Ticks.of(recording)
    )
    return replace(finished, embeddings=bare.embeddings)


def run_of_steps(
    steps: Sequence[StepResult],
    tracker: str,
    settings: Mapping[str, Any],
    seed: int,
    start: int,
    recording: Recording,
    resume: Resume | None = None,
) -> Run:
    """The steps of a tracker, in order from frame `start` on, as one immutable run.

    `settings` are plain values by their dotted names. With `smooth` among them, the tracks take
    into account what came later (see `TrackerSpec.finisher`); the steps stay as they were.
    `resume`: what the tracker went on from, if it did; the smoothed tracks begin there.
    """
    kept = KeptSteps(first=start)
    kept.add(steps)
    return kept.run(tracker, settings, seed, recording, resume)
