"""A report of the score, for others: everything the panel tells, and more, in a folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from app.core.document.document import Document
from app.core.document.track_sources import name_of_run
from app.core.i18n import tr
from app.features.scoring.subject import ScoreResult, ScoringInput
from tracking.errors import TrackwrightError
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.scoring import ScoringTable
from tracking.scoring.report import (
    Finding,
    Footage,
    Shown,
    Subject,
    Yardstick,
    check_score_folder,
    finding_of,
    report_of,
    shown_of,
    write_score_report,
)
from tracking.tracks import Run


@dataclass(frozen=True, slots=True)
class WrittenReport:
    """A report that was written: its page, and which runs are not in it, by name, and why."""

    page: Path
    left_out: Mapping[str, str]

    @property
    def words(self) -> str:
        """Which runs were left out; "" where none was."""
        said = (
            tr("Not in the report: {name} ({why}).", name=name, why=why)
            for name, why in self.left_out.items()
        )
        return "\n".join(said)


def prepare_report(
    document: Document, scored: ScoreResult, given: ScoringInput, name: str, folder: Path
) -> Callable[[Progress], WrittenReport]:
    """Takes hold of what is reported; what it gives writes the report, on any thread.

    Beside the tracks that are scored stand all runs over the same frames.

    Args:
        scored: against which truth, and how. given: the tracks. name: what they are called.
        folder: missing, empty, or with an earlier report in it.

    The work raises OutputError where something else is in the folder or it cannot be written, and
    what stands in the way of scoring the tracks in question. A run beside them that cannot be
    scored, e.g. one without boxes, is left out.
    """
    recording = document.recording
    beside, left_out = _runs_beside(document, scored)

    def work(report: Progress) -> WrittenReport:
        check_score_folder(folder)
        results = {name: ScoringTable.from_columns(given.load()), **_tables(beside)}
        subject = _subject(recording, scored, results)
        yardstick = Yardstick(scored.subject.matching.match)
        findings, unscored = _findings(subject, name, yardstick, report)
        shown: dict[Finding, Shown] = {}
        for done, finding in enumerate(findings):
            why_none = tr("the boxes of people in the images are unknown")
            tell = partial(_tell_of_results, report, done, len(findings))
            shown[finding] = shown_of(finding, len(findings), tell, why_none)
        page = write_score_report(folder, report_of(findings, yardstick), shown)
        report(len(findings), len(findings))
        return WrittenReport(page, {**left_out, **unscored})

    return work


def _runs_beside(document: Document, scored: ScoreResult) -> tuple[dict[str, Run], dict[str, str]]:
    """The runs over the frames that are scored, by what they are called; why others are not."""
    session = document.session
    runs = tuple(session.runs[n] for n in range(len(session.runs))) if session is not None else ()
    own, frames = scored.subject.track_source, scored.subject.frames
    beside: dict[str, Run] = {}
    left_out: dict[str, str] = {}
    for number, run in enumerate(runs):
        name = name_of_run(number, run.tracker)
        if number == own or _is_truth(scored, number):
            continue
        if run.frames == frames:
            beside[name] = run
        else:
            left_out[name] = tr("it covers other frames")
    return beside, left_out


def _findings(
    subject: Subject, name: str, yardstick: Yardstick, report: Progress
) -> tuple[list[Finding], dict[str, str]]:
    """Every result scored; of those beside the one in question (`name`) that cannot be, why."""
    findings: list[Finding] = []
    unscored: dict[str, str] = {}
    for done, result in enumerate(subject.results):
        report(done, len(subject.results))
        try:
            findings.append(finding_of(subject, result, yardstick))
        except TrackwrightError as error:
            if result == name:
                raise
            unscored[result] = error.reason
    return findings, unscored


def _tell_of_results(report: Progress, done: int, results: int, *_: int) -> None:
    """Say how many results are done while pictures of the next are cut; raises when cancelled."""
    report(done, results)


def _is_truth(scored: ScoreResult, run: int) -> bool:
    source = scored.subject.source
    return source.is_run and source.run == run


def _tables(runs: dict[str, Run]) -> dict[str, ScoringTable]:
    return {name: ScoringTable.from_columns(run.tracks) for name, run in runs.items()}


def _subject(
    recording: Recording, scored: ScoreResult, results: dict[str, ScoringTable]
) -> Subject:
    """What was tracked of the recording, frames counted from the first of it."""
    start, stop = scored.subject.frames
    return Subject(
        name=recording.name,
        truth=scored.truth.table.within(start, stop),
        results={name: table.within(start, stop) for name, table in results.items()},
        start=start,
        stop=stop,
        footage=Footage(recording.fps, recording.size, recording.view, recording),
    )
