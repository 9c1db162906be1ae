"""The runs of a session in words and figures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from app.core.commands.conditions import read_only
from app.core.document.detector_choice import DETECTOR, DetectorChoice
from app.core.document.edit_history import local_time
from app.core.fact_texts import setting_text
from app.core.i18n import count_text, joined_text, sentence, tr
from app.core.scenes.score_figures import figure_named
from app.features.runs.tracker_state import why_not_tracked
from tracking.formats import read_mot
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.scoring import Score, ScoringTable, score
from tracking.session import Session
from tracking.trackers import TRACKERS, changed_settings
from tracking.tracks import Columns, Run
from tracking.translation import tr as translated

Range = tuple[int, int]
"""Half-open, of frames."""
CORRECTED = -1
"""Stands for the corrected tracks where a run's number is asked for."""


_NAMES = (
    "IDF1",
    "HOTA",
    "MOTA",
    "People kept",
    "Switches",
    "Misses",
    "False alarms",
    "Position error (median)",
)
RUN_FIGURES: Final = tuple(figure_named(name) for name in _NAMES)
"""What runs are chosen by, in the order of the columns."""


@dataclass(frozen=True, slots=True)
class RunRow:
    """One run, or the corrected tracks.

    Attributes:
        number: of the run, or `CORRECTED`. name: e.g. "run 2".
        settings: those that differ from the tracker's defaults, "" for none. made: when.
        people: in the frames that are scored; "" while they are not, and differ from its own.
        figures: against the truth, one for each of `RUN_FIGURES`; () without.
        why_not_corrected: why the corrected tracks cannot begin as it; "" where they can.
        why_not_again: why nothing can be tracked with its settings; "" where it can.
        why_not_compared: why it cannot be compared with the corrected tracks; "" where it can.
        notes: what was told of the tracking, in lines; "" for nothing.
    """

    number: int
    name: str
    tracker: str
    settings: str
    frames: str
    made: str
    people: str
    figures: tuple[str, ...] = ()
    why_not_corrected: str = ""
    why_not_compared: str = ""
    why_not_again: str = ""
    notes: str = ""


@dataclass(frozen=True, slots=True)
class RunsScene:
    """All runs of a session.

    Attributes:
        proposed: the number of the newest run that is not the one being corrected; of this one
            where there is no other, `CORRECTED` where there is none at all.
        scored: there is a truth.
        why_not_dropped: why the last run cannot be deleted; "" where it can, or there is none.
        share_text: what offers to score all rows over the frames they share; "" where all have the
            same frames, or none are in all of them. over: which frames the figures are about.
    """

    rows: tuple[RunRow, ...]
    scored: bool
    why_not_dropped: str
    share_text: str
    over: str
    proposed: int = CORRECTED


class RunList:
    """The runs of a session and, once they were scored, their figures.

    Attributes:
        shared: rows are scored over the frames that all of them have, where there are any: else
            their figures could not be compared.
    """

    def __init__(self, session: Session, recording: Recording, *, live: bool = False) -> None:
        """`live`: a tracker is at work on the recording."""
        self._session, self._live = session, live
        self._recording = recording
        self._figures: dict[int, Score] = {}
        self.shared = True

    def scene(self) -> RunsScene:
        """The runs as they stand."""
        session = self._session
        rows = [self._corrected(), *(self._row(n, run) for n, run in enumerate(session.runs))]
        scored = self._recording.truth_path is not None
        common, share_text = self._common, ""
        if scored and common is not None:
            share_text = tr("Score all rows over frames {frames}", frames=_range_text(common))
        over = self._over_text(common)
        return RunsScene(
            tuple(rows), scored, self._why_not_dropped, share_text, over, self._proposed
        )

    @property
    def _why_not_dropped(self) -> str:
        session = self._session
        last = len(session.runs) - 1
        if session.read_only:
            return read_only()
        if last >= 0 and session.adopted_run == last:
            return tr("The last run is the one being corrected: correct another one first.")
        return ""

    @property
    def _proposed(self) -> int:
        numbers = range(len(self._session.runs))
        others = [number for number in numbers if number != self._session.adopted_run]
        return max(others or numbers, default=CORRECTED)

    def _over_text(self, common: Range | None) -> str:
        """Of which truth the figures are, and which frames, where rows differ in theirs."""
        truth = self._recording.truth_path
        if truth is None:
            return ""
        against = tr("Scored against {name} beside the recording.", name=truth.name)
        return f"{against} {self._frames_text(common)}".rstrip()

    def _frames_text(self, common: Range | None) -> str:
        if not self._frames_differ:
            return ""
        if common is not None and self.shared:
            return tr(
                "Only frames that all rows have are scored, so that the figures can be compared."
            )
        return tr(
            "Each row is scored over its own frames. Do not compare rows with different frames: "
            "some frames are harder than others."
        )

    @property
    def _ranges(self) -> dict[int, Range]:
        """The frames of every row, by its number."""
        runs = self._session.runs
        own: dict[int, Range] = {n: runs[n].frames for n in range(len(runs))}
        return {CORRECTED: (0, self._recording.frame_count), **own}

    @property
    def _frames_differ(self) -> bool:
        return len(set(self._ranges.values())) > 1

    @property
    def _common(self) -> Range | None:
        """The frames all rows have; None where there are none, or all have the same."""
        ranges = self._ranges.values()
        start, stop = max(one[0] for one in ranges), min(one[1] for one in ranges)
        return (start, stop) if self._frames_differ and start < stop else None

    def scoring(self) -> Callable[[Progress], dict[int, Score]]:
        """What scores all of them against the truth; to be called in any thread.

        Over the frames they share, or each over its own: see `shared`. It gives what `take` takes.
        """
        truth_path = self._recording.truth_path
        assert truth_path is not None
        runs, common = self._session.runs, self._common if self.shared else None
        tracks: dict[int, Columns] = {CORRECTED: self._session.tracks.snapshot().columns()}
        tracks |= {n: runs[n].tracks for n in range(len(runs))}
        tables = [(n, tracks[n], common or frames) for n, frames in self._ranges.items()]

        def work(report: Progress) -> dict[int, Score]:
            truth = read_mot(truth_path)
            figures = {}
            for done, (number, columns, frames) in enumerate(tables):
                report(done, len(tables))
                figures[number] = _scored(truth, columns, frames)
            return figures

        return work

    def take(self, figures: Mapping[int, Score]) -> None:
        """Take the figures that scoring gave."""
        self._figures = dict(figures)

    @property
    def _edits(self) -> int:
        """How many edits are in force."""
        return sum(not entry.undone for entry in self._session.history)

    def _corrected(self) -> RunRow:
        session = self._session
        return RunRow(
            CORRECTED,
            tr("corrected tracks"),
            count_text(self._edits, "{n} edit", "{n} edits"),
            "",
            _range_text((0, self._recording.frame_count)),
            "",
            self._people(CORRECTED, len(session.tracks.track_ids)),
            self._figures_of(CORRECTED),
            why_not_corrected=tr("Select a run to correct it."),
            why_not_again=tr("Select a run to track again with its settings."),
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
            self._people(number, len(np.unique(run.tracks["track"]))),
            self._figures_of(number),
            why_not_corrected=self._why_not_corrected(number),
            why_not_compared=self._why_not_compared(number),
            why_not_again=self._why_not_again(run),
            notes="\n".join(map(tr, run.notes)),
        )

    def _why_not_corrected(self, number: int) -> str:
        if number == self._session.adopted_run:
            return tr("This run is the one being corrected.")
        if self._live:
            return tr("A tracker is running: stop it first.")
        return read_only() if self._session.read_only else ""

    def _why_not_again(self, run: Run) -> str:
        if self._live:
            return tr("A tracker is running: stop it first.")
        if run.tracker not in TRACKERS:
            return tr("Its tracker is not installed here.")
        if why := why_not_tracked(run.tracker, self._recording):
            return sentence(why)
        return read_only() if self._session.read_only else ""

    def _why_not_compared(self, number: int) -> str:
        if number == self._session.adopted_run and not self._edits:
            return tr("The corrected tracks equal this run: nothing has been edited yet.")
        return ""

    def _people(self, number: int, own: int) -> str:
        """How many of a row are beside its figures: in the frames those are about."""
        if number in self._figures:
            return str(self._figures[number].result_tracks)
        scored = self._recording.truth_path is not None
        partly = scored and self.shared and self._common not in (None, self._ranges[number])
        return "" if partly else str(own)

    def _figures_of(self, number: int) -> tuple[str, ...]:
        score = self._figures.get(number)
        return () if score is None else tuple(one.text(score) for one in RUN_FIGURES)


def _scored(truth: Columns, columns: Columns, frames: tuple[int, int]) -> Score:
    """The figures over a range of frames."""
    parts = []
    for table in (truth, columns):
        inside = (table["frame"] >= frames[0]) & (table["frame"] < frames[1])
        parts.append({name: column[inside] for name, column in table.items()})
    wanted = ScoringTable.from_columns(parts[0], dont_cares=True)
    found = ScoringTable.from_columns(parts[1])
    return score(wanted, found, frames=frames[1])


def _settings_text(run: Run) -> str:
    """The settings that are not the tracker's defaults; of an unknown tracker, none."""
    known = changed_settings(run.tracker, run.settings) if run.tracker in TRACKERS else {}
    changed = [f"{name} {_value_text(name, value)}" for name, value in known.items()]
    if run.seed:
        changed.append(tr("seed {n}", n=run.seed))
    return joined_text(", ", changed)


def _value_text(name: str, value: object) -> str:
    """A setting as `info` tells it; a detector that was trained here by when, not by its path."""
    if name == DETECTOR and isinstance(value, str):
        return DetectorChoice(value).name
    return translated(setting_text(value))


def _range_text(frames: tuple[int, int]) -> str:
    return f"{frames[0]} \u2013 {frames[1] - 1}"
