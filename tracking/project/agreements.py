"""How far annotators agree over all recordings of a project that two or more of them worked on."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from itertools import combinations

from tracking.errors import TrackwrightError
from tracking.progress import Progress, no_progress
from tracking.project.facts import NO_MESSAGE
from tracking.project.pairing import ProjectRow, SessionRow
from tracking.scoring import ScoringTable, agreement, stretch_gap
from tracking.session import Session
from tracking.translation import Message


@dataclass(frozen=True, slots=True)
class PairAgreement:
    """How far two sessions of a recording agree.

    Attributes:
        recording: its name. a, b: who made the sessions; with their files where one person made
            both, the files alone where nobody edited.
        idf1, kappa: see `Agreement`; NaN where both are empty.
        rows: person-frames that were compared. disagreements: stretches.
        problem: why they cannot be compared; empty: they were.
    """

    recording: str
    a: str
    b: str
    idf1: float = math.nan
    kappa: float = math.nan
    rows: int = 0
    disagreements: int = 0
    problem: Message = NO_MESSAGE


def compared_rows(rows: Iterable[ProjectRow]) -> list[ProjectRow]:
    """The recordings that have two or more sessions that can be read."""
    return [row for row in rows if len(_readable(row)) > 1]


def agreements(
    rows: Sequence[ProjectRow], report: Progress = no_progress
) -> tuple[PairAgreement, ...]:
    """How far each two sessions of each recording agree; nothing is claimed or written.

    A session that cannot be read is told in its pairs.
    """
    chosen = compared_rows(rows)
    found: list[PairAgreement] = []
    for number, row in enumerate(chosen):
        report(number, len(chosen))
        found += _of_recording(row)
    report(len(chosen), len(chosen))
    return tuple(found)


def pooled(pairs: Iterable[PairAgreement]) -> PairAgreement:
    """All pairs together: means of IDF1 and kappa, each pair weighted by its rows."""
    known = [pair for pair in pairs if pair.rows and not pair.problem]
    rows = sum(pair.rows for pair in known)

    def mean(name: str) -> float:
        values = [(getattr(pair, name), pair.rows) for pair in known]
        told = [(value, weight) for value, weight in values if not math.isnan(value)]
        total = sum(weight for _, weight in told)
        return sum(value * weight for value, weight in told) / total if total else math.nan

    disagreements = sum(pair.disagreements for pair in known)
    return PairAgreement("", "", "", mean("idf1"), mean("kappa"), rows, disagreements)


def _of_recording(row: ProjectRow) -> Iterator[PairAgreement]:
    tables: dict[SessionRow, tuple[ScoringTable, float] | Message] = {}
    names = _names(_readable(row))
    for session in _readable(row):
        try:
            tables[session] = _table(session)
        except TrackwrightError as error:
            tables[session] = error.message
    for one, other in combinations(_readable(row), 2):
        a, b = names[one], names[other]
        first, second = tables[one], tables[other]
        for table in (first, second):
            if isinstance(table, Message):
                yield PairAgreement(row.name, a, b, problem=table)
                break
        else:
            assert not isinstance(first, Message)
            assert not isinstance(second, Message)
            yield _compared(row.name, (a, b), (first, second))


def _compared(
    recording: str,
    names: tuple[str, str],
    tables: tuple[tuple[ScoringTable, float], tuple[ScoringTable, float]],
) -> PairAgreement:
    (a, fps), (b, _) = tables
    try:
        found = agreement(a, b, gap=stretch_gap(fps))
    except TrackwrightError as error:
        return PairAgreement(recording, *names, problem=error.message)
    return PairAgreement(
        recording, *names, found.idf1, found.kappa, found.rows, len(found.disagreements)
    )


def _table(row: SessionRow) -> tuple[ScoringTable, float]:
    """The corrected tracks of a session, and its frames a second. Raises SessionError."""
    with closing(Session.look_into(row.path)) as session:
        return ScoringTable.from_columns(session.tracks.columns()), session.recording.fps


def _readable(row: ProjectRow) -> list[SessionRow]:
    """In the order of their files, so that a pair is always the same way round."""
    readable = [one for one in row.sessions if one.is_readable and not one.note]
    return sorted(readable, key=lambda one: one.path)


def _names(sessions: Sequence[SessionRow]) -> dict[SessionRow, str]:
    """Who edited each session last, with its file where two are of one person; else its file."""
    last = {
        one: one.facts.authors[-1] if one.facts is not None and one.facts.authors else ""
        for one in sessions
    }
    names = list(last.values())
    return {
        one: name if names.count(name) == 1 else f"{name} ({_file_of(one)})"
        for one, name in last.items()
        if name
    } | {one: _file_of(one) for one, name in last.items() if not name}


def _file_of(row: SessionRow) -> str:
    return f"{row.path.parent.name}/{row.path.name}"
