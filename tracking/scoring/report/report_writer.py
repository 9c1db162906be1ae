"""A score report in a folder: the page, and the same as Markdown and JSON beside it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from tracking.pages import check_report_folder, write_report_folder
from tracking.scoring.report.data import data_of
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.markdown import markdown_of
from tracking.scoring.report.page import KIND, page_of
from tracking.scoring.report.page_pictures import Shown

PAGE, TEXT, DATA = "report.html", "report.md", "report.json"


def check_score_folder(folder: Path) -> None:
    """Refuse a folder with anything in it but an earlier report; raises OutputError."""
    check_report_folder(folder, (PAGE, TEXT, DATA), KIND)


def write_score_report(
    folder: Path, report: ScoreReport, shown: Mapping[Finding, Shown] | None = None
) -> Path:
    """Write the three files, or none of them; the page's path.

    Args:
        folder: missing, empty, or with an earlier report in it, which is replaced.
        shown: pictures of findings.

    Raises:
        OutputError: something else is in the folder, or it cannot be written.
    """
    data = json.dumps(data_of(report), indent=1, allow_nan=False) + "\n"
    files = {PAGE: page_of(report, shown or {}), TEXT: markdown_of(report), DATA: data}
    write_report_folder(folder, files, KIND)
    return folder / PAGE
