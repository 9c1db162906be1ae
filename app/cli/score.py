"""`score`: results against truth."""

from __future__ import annotations

from app.cli.destination import check_folder, nearest_folder
from app.cli.output import print_json, print_line, print_lines, say
from app.cli.score_measurement import MeasureRequest, measure_all, yardstick_of
from app.cli.score_printer import document_of, text_of
from app.cli.sequences import pair_results
from tracking.scoring.report import check_score_folder, report_of, write_score_report
from tracking.translation import msg


def run_score(asked: MeasureRequest, *, as_json: bool) -> None:
    """Print the measures, and write a report where one is asked for.

    Raises:
        FormatError, SessionError: a file cannot be read, has nothing to be matched by, or no
            results belong to the truths.
        SettingsError: a range is none.
        OutputError: the report cannot be written where it is asked for.
    """
    if asked.report is not None:
        check_folder(nearest_folder(asked.report))
        check_score_folder(asked.report)
    pairing = pair_results(asked.results, asked.truth)
    for line in pairing.unmatched:
        say(msg("note: left out: {line}", line=line))
    yardstick = yardstick_of(asked)
    measured = measure_all(asked, pairing, yardstick)
    page = None
    if asked.report is not None:
        findings = [each.finding for each in measured if each.finding is not None]
        shown = {each.finding: each.shown for each in measured if each.finding and each.shown}
        page = write_score_report(asked.report, report_of(findings, yardstick), shown)
    if as_json:
        document = document_of(asked, pairing, measured)
        print_json(document if page is None else document | {"report": str(page)})
    else:
        print_lines(text_of(asked, pairing, measured))
        if page is not None:
            print_line()
            print_line(page)
