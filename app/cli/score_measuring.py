"""Every result on every sequence that `score` was pointed at."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from app.cli.output import progress
from app.cli.ranges import typed_range
from app.cli.score_passages import with_passages
from app.cli.scored import Loaded, loaded, part_rates, tell_oddities
from app.cli.sequences import Pairing
from tracking.errors import FormatError, SettingsError
from tracking.progress import Progress
from tracking.scoring import BoxMatch, Conventions, FloorMatch, Score
from tracking.scoring.parts import Rates
from tracking.scoring.report import (
    Finding,
    Shown,
    Subject,
    Yardstick,
    finding_of,
    place_picture,
    switch_pictures,
)
from tracking.tracks import CountingLine

_LONG_BYTES = 16 << 20
_END = 10**9


@dataclass(frozen=True, slots=True)
class Asked:
    """What is to be measured and told, as typed.

    Attributes:
        results, truth: files or folders.
        match: "box" or "floor". radius_m: for the floor. conventions: a name of `Conventions`.
        frames: A:B; None: all. ranges: A:B each, measured by themselves.
        per_person: a row each. lines: over which passages are counted; none: those in sessions.
        report: a folder; None: none.
        allow_outside: a recording outside of its session's folder may be opened.
    """

    results: tuple[Path, ...]
    truth: Path
    match: str = "box"
    radius_m: float = 0.5
    conventions: str = Conventions.TRACKEVAL
    frames: str | None = None
    ranges: tuple[str, ...] = ()
    per_person: bool = False
    lines: tuple[CountingLine, ...] = ()
    report: Path | None = None
    allow_outside: bool = False

    @property
    def is_detailed(self) -> bool:
        """Whether more is told than scores."""
        return self.per_person or bool(self.ranges) or self.report is not None


@dataclass(slots=True)
class Measured:
    """What was found, sequence by sequence.

    Attributes:
        scores: by result, then sequence. findings: where more than scores is told.
        shown: pictures for the report. parts: rates of body parts, of a single pair.
    """

    scores: dict[str, dict[str, Score]] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    shown: dict[Finding, Shown] = field(default_factory=dict)
    parts: Rates | None = None


def yardstick_of(asked: Asked) -> Yardstick:
    """How it is measured.

    Raises SettingsError where a range or radius is none.
    """
    match = FloorMatch(asked.radius_m) if asked.match == "floor" else BoxMatch()
    ranges = []
    for text in asked.ranges:
        start, stop = typed_range(text, _END) or (0, _END)
        if start >= stop:
            raise SettingsError(f"range {text} holds no frames; name one as A:B with A below B")
        ranges.append((start, stop))
    return Yardstick(match, Conventions(asked.conventions), tuple(ranges))


def measured_by(asked: Asked, pairing: Pairing, yardstick: Yardstick) -> Measured:
    """Every result on every sequence, read one sequence at a time.

    Raises as `run_score`.
    """
    measured = Measured({name: {} for name in pairing.results})
    total = len(pairing.results) * len(pairing.truths)
    with _progress(asked, pairing) as told:
        for number, (name, truth) in enumerate(pairing.truths.items()):
            files = {result: found[name] for result, found in pairing.results.items()}
            one = loaded(name, truth, files, asked.frames)
            tell_oddities(one)
            _measure(
                asked, one, yardstick, measured, partial(_tell, told, number * len(files), total)
            )
            if not pairing.is_batch and len(files) == 1:
                tracks = next(iter(one.results.values()))
                measured.parts = part_rates(tracks, asked.truth, one.frames)
    _check_ranges(asked, measured)
    return measured


def _tell(told: Progress, before: int, total: int, done: int) -> None:
    told(before + done, total)


def _measure(
    asked: Asked,
    one: Loaded,
    yardstick: Yardstick,
    measured: Measured,
    tell: Callable[[int], None],
) -> None:
    """Every result on one sequence."""
    with _footage(asked, one) as (subject, why_none):
        for number, result in enumerate(subject.results):
            tell(number)
            try:
                if not asked.is_detailed:
                    score = yardstick.score(subject, result)
                    score = with_passages(score, one, result, asked.lines)
                    measured.scores[result][subject.name] = score
                    continue
                finding = finding_of(subject, result, yardstick)
            except FormatError as error:
                raise FormatError(f"{result} on {subject.name}: {error}") from error
            score = with_passages(finding.score, one, result, asked.lines)
            finding = replace(finding, score=score)
            measured.scores[result][subject.name] = score
            measured.findings.append(finding)
            if asked.report is not None:
                measured.shown[finding] = _shown(finding, why_none)
        tell(len(subject.results))


@contextmanager
def _footage(asked: Asked, one: Loaded) -> Iterator[tuple[Subject, str]]:
    """The sequence, with its pictures where they are shown."""
    if asked.report is None:
        yield one.subject, ""
        return
    from app.cli.score_pictures import filmed  # brings what reads recordings

    with filmed(one, allow_outside=asked.allow_outside) as (subject, why_none):
        yield subject, why_none


def _shown(finding: Finding, why_none: str) -> Shown:
    switches = switch_pictures(finding, lambda *_: None)
    place = place_picture(finding.subject)
    return Shown(switches, place, why_none or "nobody knows where people stand in the pictures")


@contextmanager
def _progress(asked: Asked, pairing: Pairing) -> Iterator[Callable[[int, int], None]]:
    """Says how far it is, unless it is done in a moment."""
    files = [*pairing.truths.values(), *(p for r in pairing.results.values() for p in r.values())]
    size = sum(path.stat().st_size for path in files if path.is_file())
    many = pairing.is_batch or len(pairing.results) > 1
    if not many and asked.report is None and size < _LONG_BYTES:
        yield lambda *_: None
        return
    with progress("scoring") as told:
        yield told


def _check_ranges(asked: Asked, measured: Measured) -> None:
    """Refuse ranges that lie in no sequence."""
    if asked.ranges and not any(finding.ranges for finding in measured.findings):
        stop = max(finding.subject.stop for finding in measured.findings)
        raise SettingsError(
            f"range {asked.ranges[0]} is in neither result nor truth: choose one within 0:{stop}"
        )
