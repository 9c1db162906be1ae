"""The page of a score report: tables, curves, errors over time and on the map, switches."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import tracking
from tracking.pages import render
from tracking.scoring.conventions import Conventions
from tracking.scoring.errors import ErrorKind
from tracking.scoring.report import error_map, tables
from tracking.scoring.report.curves import PART_HEAD, hota_curves, part_curves, part_rows
from tracking.scoring.report.distances import NO_PLACES, distance_rows
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.ground_plan import GroundPlan, ground_plan
from tracking.scoring.report.marks import TITLES, mark
from tracking.scoring.report.measures import by_group
from tracking.scoring.report.missing_values import lacking_said
from tracking.scoring.report.over_time import errors_over_time
from tracking.scoring.report.page_pictures import Shown
from tracking.scoring.report.sources import sources_said
from tracking.scoring.similarity import FloorMatch
from tracking.translation import Message, joined, msg

KIND = "trackwright score report"


def page_of(report: ScoreReport, shown: Mapping[Finding, Shown]) -> str:
    """The page as HTML.

    Args:
        shown: pictures of findings; a finding may have none.
    """
    return render(
        "scoring/report/page.html",
        title=title_of(report),
        kind=KIND,
        report=report,
        how=how(report),
        cards=_cards(report) if len(report.results) == 1 else (),
        scores=[report.overall[result] for result in report.results],
        curves=hota_curves(report),
        groups=by_group(tables.measures_of(report)),
        names=[measure.name for measure in tables.main_measures(report)],
        by_recording={result: tables.sequence_rows(report, result) for result in report.results},
        views=[_view(one, report, shown.get(one, Shown())) for one in report.findings],
        marks=[mark(kind, 8, 8, title) for kind, title in TITLES.items()],
        no_places=NO_PLACES,
        passage_head=tables.PASSAGE_HEAD,
        part_head=PART_HEAD,
    )


def title_of(report: ScoreReport) -> Message:
    """What the report is on, in a line."""
    results, sequences = report.results, report.sequences
    what = results[0] if len(results) == 1 else msg("{n} results", n=len(results))
    where = sequences[0] if len(sequences) == 1 else msg("{n} recordings", n=len(sequences))
    if what == where:
        return msg("Score of {what}", what=what)
    return msg("{what} on {where}", what=what, where=where)


def how(report: ScoreReport) -> Message:
    """How it was measured, in a sentence."""
    match = report.yardstick.match
    return joined(
        " ",
        (
            msg(
                "A row of the ground truth and one of the result may be one person no farther "
                "apart on the floor than {radius:g} m.",
                radius=match.radius_m,
            )
            if isinstance(match, FloorMatch)
            else msg(
                "A row of the ground truth and one of the result may be one person where their "
                "boxes overlap by {threshold:g} or more (IoU).",
                threshold=match.threshold,
            ),
            msg("CLEAR and identity are counted as py-motmetrics counts them, HOTA as TrackEval.")
            if report.yardstick.conventions is Conventions.MOTMETRICS
            else msg("Everything is counted as TrackEval counts it."),
            msg("Frames count from 0."),
            msg("Made by trackwright {version}.", version=tracking.__version__),
        ),
    )


def _cards(report: ScoreReport) -> list[tuple[str, str]]:
    """The numbers that most people ask for."""
    score = report.overall[report.results[0]]
    error = score.position_error.mean
    cards = [
        ("HOTA", f"{score.hota.hota:.3f}"),
        ("MOTA", f"{score.clear.mota:.3f}"),
        ("IDF1", f"{score.identity.idf1:.3f}"),
        (msg("switches"), f"{score.clear.id_switches:,}"),
        (
            msg("people kept"),
            msg("{kept} of {detected}", kept=score.people.kept, detected=score.people.detected),
        ),
    ]
    return [*cards, (msg("position error"), f"{error:.2f} m")] if error == error else cards


def _view(finding: Finding, report: ScoreReport, shown: Shown) -> dict[str, Any]:
    """One result on one sequence, as the page has it."""
    over_time, plan, parts = errors_over_time(finding), ground_plan(finding.subject), finding.parts
    return {
        "finding": finding,
        "shown": shown,
        "sources": list(sources_said(finding)),
        "lacking": list(lacking_said(finding)),
        "over_time": over_time,
        "people_left": len(finding.people) - len(over_time.people),
        "map": plan and error_map.error_map(finding, plan, over_time.clock),
        "not_on_map": [] if plan is None else list(_not_on_map(finding, plan)),
        "switches": finding.errors.count(ErrorKind.SWITCH),
        "range_rows": tables.range_rows(finding, report),
        "distance_rows": distance_rows(finding.distances),
        "people_rows": tables.people_rows(finding),
        "passage_rows": tables.passage_rows(finding),
        "part_curves": parts and part_curves(parts),
        "part_rows": [] if parts is None else part_rows(parts),
    }


def _not_on_map(finding: Finding, plan: GroundPlan) -> Iterator[str]:
    if count := plan.beyond(finding.errors):
        yield msg(
            "{count:,} errors lie farther out than the map goes; their marks are on its edge.",
            count=count,
        )
    for kind, count in error_map.left_out(finding).items():
        lasts = kind in (ErrorKind.MISS, ErrorKind.FALSE_ALARM)
        yield msg(
            "{count:,} {errors} beyond {most} are not drawn.",
            count=count,
            errors=msg("ranges of {errors}", errors=TITLES[kind]) if lasts else TITLES[kind],
            most=error_map.MOST_MARKS,
        )
