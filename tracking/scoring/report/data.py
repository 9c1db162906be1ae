"""A score report as plain values, for programs."""

from __future__ import annotations

from typing import Any

import tracking
from tracking.arrays import Integers
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.per_person import PersonScore
from tracking.scoring.report.distances import distances_data
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.measures import finite
from tracking.scoring.report.sources import sources_data
from tracking.scoring.report.stretches import Stretches
from tracking.scoring.similarity import FloorMatch

FORMAT = "trackwright-score-report"


def data_of(report: ScoreReport) -> dict[str, Any]:
    """The report for `json.dumps(..., allow_nan=False)`: results, then sequences.

    Frames count from 0, ranges are half-open; misses and false alarms are ranges of frames.
    """
    match = report.yardstick.match
    paired: dict[str, Any] = {"match": "box", "threshold": match.threshold}
    if isinstance(match, FloorMatch):
        paired = {"match": "floor", "radius_m": match.radius_m}
    return {
        "format": FORMAT,
        "format_version": 1,
        "software": f"trackwright {tracking.__version__}",
        **paired,
        "conventions": str(report.yardstick.conventions),
        "results": {
            result: {
                "sequences": {one.subject.name: finding_data(one) for one in report.of(result)},
                "combined": report.overall[result].as_json(),
            }
            for result in report.results
        },
    }


def finding_data(finding: Finding) -> dict[str, Any]:
    """One result on one sequence."""
    return {
        **sources_data(finding),
        **finding.score.as_json(),
        "per_person": people_data(finding),
        "ranges": ranges_data(finding),
        "distances": distances_data(finding.distances),
        "errors": _errors(finding.errors),
        **({} if finding.parts is None else {"parts": finding.parts.as_json()}),
    }


def people_data(finding: Finding) -> list[dict[str, Any]]:
    """A row for each person of the truth."""
    return [_person(one) for one in finding.people]


def ranges_data(finding: Finding) -> list[dict[str, Any]]:
    """A score for each range of frames, measured as if there were no others."""
    return [
        {"start": start, "stop": stop, **score.as_json()}
        for (start, stop), score in finding.ranges.items()
    ]


def _person(one: PersonScore) -> dict[str, Any]:
    followed, error = one.followed, one.position_error
    return {
        "person": one.person,
        "start": one.start,
        "stop": one.end,
        "frames": one.frames,
        "matches": one.matches,
        "misses": one.misses,
        "similarity": finite(one.similarity),
        "tracks": list(one.tracks),
        "id_switches": followed.id_switches,
        "fragmentations": followed.fragmentations,
        "named": followed.named,
        "identity_matches": followed.identity_matches,
        "detected": followed.detected,
        "kept": followed.kept,
        "position_error_m": {"mean": finite(error.mean), "p95": finite(error.p95)},
    }


def _errors(found: ErrorTable) -> dict[str, Any]:
    missed = found.of_kind(ErrorKind.MISS)
    alarms = found.of_kind(ErrorKind.FALSE_ALARM)
    return {
        "switches": _instants(found.of_kind(ErrorKind.SWITCH)),
        "fragmentations": _instants(found.of_kind(ErrorKind.FRAGMENTATION)),
        "misses": _ranges(missed, missed.truth, "person"),
        "false_alarms": _ranges(alarms, alarms.result, "track"),
    }


def _instants(found: ErrorTable) -> list[dict[str, int]]:
    columns = (found.frame, found.truth, found.earlier, found.earlier_frame, found.result)
    names = ("frame", "person", "earlier_track", "earlier_frame", "track")
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return [dict(zip(names, row, strict=True)) for row in rows]


def _ranges(found: ErrorTable, who: Integers, name: str) -> list[dict[str, int]]:
    stretches = Stretches.of(found.frame, who, found.position)
    columns = (stretches.who, stretches.start, stretches.stop)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return [{name: one, "start": start, "stop": stop} for one, start, stop in rows]
