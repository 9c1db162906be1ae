"""Every result on every sequence that `score` was pointed at."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import typer

from app.cli.output import progress
from app.cli.ranges import ANY_END, parse_range
from app.cli.score_inputs import (
    LoadedSequence,
    load_sequence,
    part_rates,
    tell_oddities,
    tell_unlike,
)
from app.cli.score_passages import with_passages
from app.cli.sequences import Pairing
from tracking.errors import FormatError, SettingsError
from tracking.formats import Stated
from tracking.scoring import BoxMatch, Conventions, FloorMatch, Score, check_distances
from tracking.scoring.parts import Rates
from tracking.scoring.report import (
    Finding,
    Shown,
    Subject,
    Yardstick,
    finding_of,
    shown_of,
)
from tracking.tracks import CountingLine
from tracking.translation import msg

_RADIUS_M = 0.5
_LONG_BYTES = 16 << 20


@dataclass(frozen=True, slots=True)
class MeasureRequest:
    """What is to be measured and told, as typed.

    Attributes:
        results, truth: files or folders.
        match: "box" or "floor". radius_m: for the floor. conventions: a name of `Conventions`.
        frames: A:B; None: all. ranges: A:B each, measured by themselves.
        distances: edges in metres from the camera, with commas between; None: not told.
        per_person: a row each. lines: over which passages are counted; none: those in sessions.
        report: a folder; None: none.
        allow_outside: a recording outside of its session's folder may be opened.
        stated: what is said of texts of places that do not say it.
    """

    results: tuple[Path, ...]
    truth: Path
    match: str = "box"
    radius_m: float = _RADIUS_M
    conventions: str = Conventions.TRACKEVAL
    frames: str | None = None
    ranges: tuple[str, ...] = ()
    distances: str | None = None
    per_person: bool = False
    lines: tuple[CountingLine, ...] = ()
    report: Path | None = None
    allow_outside: bool = False
    stated: Stated = field(default_factory=Stated)

    @property
    def is_detailed(self) -> bool:
        """Whether more is told than scores."""
        told = self.per_person or bool(self.ranges) or self.distances is not None
        return told or self.report is not None


@dataclass(frozen=True, slots=True, eq=False)
class SequenceMeasurement:
    """One result on one sequence.

    Attributes:
        result, sequence: their names. score: of it.
        parts: rates of body parts; None where nobody followed any.
        finding: where more than scores is told. shown: its pictures, where there is a report.
    """

    result: str
    sequence: str
    score: Score
    parts: Rates | None = None
    finding: Finding | None = None
    shown: Shown | None = None


def radius_of(match: str, radius_m: float | None) -> float:
    """The radius that was typed, or the usual one; raises BadParameter where it has no use."""
    if radius_m is None:
        return _RADIUS_M
    if match != "floor":
        raise typer.BadParameter(
            msg("distances count only with --match floor; add it, or leave the radius out"),
            param_hint="--radius",
        )
    return radius_m


def yardstick_of(asked: MeasureRequest) -> Yardstick:
    """How it is measured.

    Raises SettingsError where a range, a radius or distances are none.
    """
    match = FloorMatch(asked.radius_m) if asked.match == "floor" else BoxMatch()
    ranges = tuple(parse_range(text, None, "--range") or (0, ANY_END) for text in asked.ranges)
    distances_m = () if asked.distances is None else _distances(asked.distances)
    return Yardstick(match, Conventions(asked.conventions), ranges, distances_m)


def _distances(text: str) -> tuple[float, ...]:
    """Edges as typed. Raises SettingsError where they are none."""
    try:
        edges_m = tuple(float(each) for each in text.split(","))
    except ValueError as error:
        raise SettingsError(
            "distances {text!r} are not numbers with commas between, e.g. --distances 0,5,10",
            text=text,
        ) from error
    check_distances(edges_m)
    return edges_m


def measure_all(
    asked: MeasureRequest, pairing: Pairing, yardstick: Yardstick
) -> list[SequenceMeasurement]:
    """Every result on every sequence, sequence by sequence, of which one is in memory at a time.

    Raises as `run_score`.
    """
    measured: list[SequenceMeasurement] = []
    total = len(pairing.results) * len(pairing.truths)
    with _progress(asked, pairing) as told:
        for name, truth in pairing.truths.items():
            files = {result: found[name] for result, found in pairing.results.items()}
            one = load_sequence(name, truth, files, asked.frames, asked.stated)
            tell_oddities(one)
            with _footage(asked, one) as (subject, why_none):
                for result in files:
                    told(len(measured), total)
                    found = _measured(asked, one, subject, result, yardstick)
                    tell_unlike(one, result, found.score)
                    if asked.report is not None and found.finding is not None:
                        why_none = why_none or msg("the boxes of people in the images are unknown")
                        shown = shown_of(found.finding, total, lambda *_: None, why_none)
                        found = replace(found, shown=shown)
                    measured.append(found)
        told(total, total)
    _check_ranges(asked, measured)
    return measured


def _measured(
    asked: MeasureRequest, one: LoadedSequence, subject: Subject, result: str, yardstick: Yardstick
) -> SequenceMeasurement:
    """One result on one sequence.

    Args:
        subject: what is measured of the sequence, with its pictures where they are shown.
    """
    parts = part_rates(one.results[result], one.truth.path, one.frames)
    try:
        if not asked.is_detailed:
            score = yardstick.score(subject, result)
            score = with_passages(score, one, result, asked.lines)
            return SequenceMeasurement(result, subject.name, score, parts)
        finding = finding_of(subject, result, yardstick)
    except FormatError as error:
        raise FormatError(
            "{result} on {name}: {error}", result=result, name=subject.name, error=error
        ) from error
    score = with_passages(finding.score, one, result, asked.lines)
    finding = replace(finding, score=score, parts=parts)
    return SequenceMeasurement(result, subject.name, score, parts, finding)


@contextmanager
def _footage(asked: MeasureRequest, one: LoadedSequence) -> Iterator[tuple[Subject, str]]:
    """The sequence, with its pictures where they are shown."""
    if asked.report is None:
        yield one.subject, ""
        return
    from app.cli.score_pictures import open_recording_of  # brings what reads recordings

    with open_recording_of(one, allow_outside=asked.allow_outside) as (subject, why_none):
        yield subject, why_none


@contextmanager
def _progress(asked: MeasureRequest, pairing: Pairing) -> Iterator[Callable[[int, int], None]]:
    """Says how far it is, unless it is done in a moment."""
    files = [*pairing.truths.values(), *(p for r in pairing.results.values() for p in r.values())]
    size = sum(path.stat().st_size for path in files if path.is_file())
    many = pairing.is_batch or len(pairing.results) > 1
    if not many and asked.report is None and size < _LONG_BYTES:
        yield lambda *_: None
        return
    with progress("scoring") as told:
        yield told


def _check_ranges(asked: MeasureRequest, measured: Sequence[SequenceMeasurement]) -> None:
    """Refuse ranges that lie in no sequence."""
    findings = [each.finding for each in measured if each.finding is not None]
    if asked.ranges and not any(finding.ranges for finding in findings):
        stop = max(finding.subject.stop for finding in findings)
        raise SettingsError(
            "range {range} is in neither result nor ground truth: choose one within 0:{stop}",
            range=asked.ranges[0],
            stop=stop,
        )
