"""A report of the score, for others: everything the panel tells, and more, in a folder."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from app.presenters.document.document import Document
from app.presenters.runs.whose import name_of_run
from app.presenters.scoring.subject import Held, Scored
from app.presenters.words import tr
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


def reporting(
    document: Document, scored: Scored, held: Held, name: str, folder: Path
) -> Callable[[Progress], Path]:
    """Takes hold of what is reported; what it gives writes the report, on any thread.

    Beside the tracks that are scored stand all runs over the same frames.

    Args:
        scored: against which truth, and how. held: the tracks. name: what they are called.
        folder: missing, empty, or with an earlier report in it.

    The work raises OutputError where something else is in the folder or it cannot be written, and
    gives the page.
    """
    session, recording = document.session, document.recording
    runs = tuple(session.runs[n] for n in range(len(session.runs))) if session is not None else ()
    own, frames = scored.subject.whose, scored.subject.frames
    beside = {
        name_of_run(number, run.tracker): run
        for number, run in enumerate(runs)
        if number != own and run.frames == frames and not _is_truth(scored, number)
    }

    def work(report: Progress) -> Path:
        check_score_folder(folder)
        results = {name: ScoringTable.from_columns(held.load()), **_tables(beside)}
        subject = _subject(recording, scored, results)
        yardstick = Yardstick(scored.subject.matching.match)
        findings: list[Finding] = []
        shown: dict[Finding, Shown] = {}
        for done, result in enumerate(results):
            report(done, len(results))
            finding = finding_of(subject, result, yardstick)
            findings.append(finding)
            why_none = tr("nobody knows where people stand in the pictures")
            tell = partial(_tell_of_results, report, done, len(results))
            shown[finding] = shown_of(finding, len(results), tell, why_none)
        page = write_score_report(folder, report_of(findings, yardstick), shown)
        report(len(results), len(results))
        return page

    return work


def _tell_of_results(report: Progress, done: int, results: int, *_: int) -> None:
    """Say how many results are done while pictures of the next are cut; raises when cancelled."""
    report(done, results)


def _is_truth(scored: Scored, run: int) -> bool:
    source = scored.subject.source
    return source.is_run and source.run == run


def _tables(runs: dict[str, Run]) -> dict[str, ScoringTable]:
    return {name: ScoringTable.from_columns(run.tracks) for name, run in runs.items()}


def _subject(recording: Recording, scored: Scored, results: dict[str, ScoringTable]) -> Subject:
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
