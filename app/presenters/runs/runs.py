"""The runs of a session in words and figures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.presenters.panels import local_time
from app.presenters.words import counted, tr
from tracking.formats import read_mot
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.scoring import ScoringTable, score
from tracking.session import Session
from tracking.trackers import TRACKERS, changed_settings
from tracking.tracks import Columns, Run

CORRECTED = -1
"""Stands for the corrected tracks where a run's number is asked for."""


@dataclass(frozen=True, slots=True)
class RunRow:
    """One run, or the corrected tracks.

    Attributes:
        number: of the run, or `CORRECTED`. name: e.g. "run 2".
        settings: those that differ from the tracker's defaults, "" for none. made: when.
        idf1, hota, switches: figures against the truth over the run's frames, "" without.
    """

    number: int
    name: str
    tracker: str
    settings: str
    frames: str
    made: str
    people: int
    idf1: str = ""
    hota: str = ""
    switches: str = ""


@dataclass(frozen=True, slots=True)
class RunsScene:
    """All runs of a session. `scored`: there is a truth; `can_drop`: the last run can go."""

    rows: tuple[RunRow, ...]
    scored: bool
    can_drop: bool


class RunList:
    """The runs of a session and, once they were scored, their figures."""

    def __init__(self, session: Session, recording: Recording) -> None:
        self._session = session
        self._recording = recording
        self._figures: dict[int, Mapping[str, Any]] = {}

    def scene(self) -> RunsScene:
        """The runs as they stand."""
        session = self._session
        rows = [self._corrected(), *(self._row(n, run) for n, run in enumerate(session.runs))]
        last = len(session.runs) - 1
        can_drop = last >= 0 and session.adopted_run != last and not session.read_only
        return RunsScene(tuple(rows), self._recording.truth_path is not None, can_drop)

    def scoring(self) -> Callable[[Progress], dict[int, Mapping[str, Any]]]:
        """What scores all of them against the truth; to be called in any thread.

        Each run over the frames it went through. What it gives is for `take`.
        """
        truth_path = self._recording.truth_path
        assert truth_path is not None
        whole = (0, self._recording.frame_count)
        tables: list[tuple[int, Columns, tuple[int, int]]] = [
            (CORRECTED, self._session.tracks.snapshot().columns(), whole)
        ]
        runs = self._session.runs
        tables += [(n, runs[n].tracks, runs[n].frames) for n in range(len(runs))]

        def work(report: Progress) -> dict[int, Mapping[str, Any]]:
            truth = read_mot(truth_path)
            figures = {}
            for done, (number, columns, frames) in enumerate(tables):
                report(done, len(tables))
                figures[number] = _scored(truth, columns, frames)
            return figures

        return work

    def take(self, figures: Mapping[int, Mapping[str, Any]]) -> None:
        """Take the figures that scoring gave."""
        self._figures = dict(figures)

    def _corrected(self) -> RunRow:
        session = self._session
        edits = sum(not entry.undone for entry in session.history)
        return RunRow(
            CORRECTED,
            tr("corrected tracks"),
            counted(edits, "{n} edit", "{n} edits"),
            "",
            _range_text((0, self._recording.frame_count)),
            "",
            len(session.tracks.track_ids),
            **self._figures_of(CORRECTED),
        )

    def _row(self, number: int, run: Run) -> RunRow:
        name = tr("run {n}", n=number)
        if number == self._session.adopted_run:
            name = tr("run {n}, being corrected", n=number)
        return RunRow(
            number,
            name,
            run.tracker,
            _settings_text(run),
            _range_text(run.frames),
            local_time(run.made) if run.made else "",
            len(np.unique(run.tracks["track"])),
            **self._figures_of(number),
        )

    def _figures_of(self, number: int) -> dict[str, str]:
        figures = self._figures.get(number)
        if figures is None:
            return {}
        return {
            "idf1": _share_text(figures.get("IDF1")),
            "hota": _share_text(figures.get("HOTA")),
            "switches": str(figures.get("id_switches", "")),
        }


def _scored(truth: Columns, columns: Columns, frames: tuple[int, int]) -> Mapping[str, Any]:
    """The figures over a range of frames, as `score --json` names them."""
    parts = []
    for table in (truth, columns):
        inside = (table["frame"] >= frames[0]) & (table["frame"] < frames[1])
        parts.append({name: column[inside] for name, column in table.items()})
    wanted = ScoringTable.from_columns(parts[0], dont_cares=True)
    found = ScoringTable.from_columns(parts[1])
    figures: Mapping[str, Any] = score(wanted, found, frames=frames[1]).as_json()
    return figures


def _settings_text(run: Run) -> str:
    """The settings that are not the tracker's defaults; of an unknown tracker, none."""
    known = changed_settings(run.tracker, run.settings) if run.tracker in TRACKERS else {}
    changed = [f"{name} {value}" for name, value in known.items()]
    if run.seed:
        changed.append(tr("seed {n}", n=run.seed))
    return ", ".join(changed)


def _range_text(frames: tuple[int, int]) -> str:
    return f"{frames[0]} \u2013 {frames[1] - 1}"


def _share_text(value: float | None) -> str:
    return "" if value is None or value != value else f"{value:.3f}"
