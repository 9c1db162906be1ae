"""A training report as a page: curves, confusions and mistakes, in one file that needs no other."""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Mapping
from html import escape
from pathlib import Path

import numpy as np

from tracking.errors import OutputError
from tracking.failure.training.report import Mistake, QuestionReport, TrainingReport
from tracking.replacing import replacing

PAGE, DATA = "index.html", "report.json"

_SIDE = 240
_STYLE = """
:root { color-scheme: light dark; --line: #8886; --ours: #1a6fd4; --bad: #c03030; }
@media (prefers-color-scheme: dark) { :root { --ours: #6fb1ff; --bad: #ff7a7a; } }
body { font: 15px/1.45 system-ui, sans-serif; max-width: 68rem; }
body { margin: 2rem auto; padding: 0 1rem; }
h1, h2 { font-weight: 600; } h2 { margin-top: 2.5rem; }
table { border-collapse: collapse; margin: .6rem 0; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--line); text-align: right; }
th:first-child, td:first-child { text-align: left; }
.row { display: flex; flex-wrap: wrap; gap: 2rem; align-items: flex-start; }
.mistakes { display: flex; flex-wrap: wrap; gap: .8rem; }
figure { margin: 0; width: 8.5rem; font-size: 12px; }
figure img { width: 100%; display: block; border-radius: 4px; }
svg text { font-size: 11px; fill: currentColor; }
.note { opacity: .75; }
"""


def write_report(
    folder: Path, report: TrainingReport, pictures: Mapping[int, bytes] | None = None
) -> tuple[Path, Path]:
    """Write the page and its data into a folder, which is made where it is missing.

    Args:
        pictures: JPEG images of mistakes, by the row of the sample.

    Raises OutputError where it cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(f"cannot make folder {folder}: {reason}; choose another") from error
    page, data = folder / PAGE, folder / DATA
    with replacing(data) as stream:
        json.dump(report.as_json(), stream, indent=2, allow_nan=False)
        stream.write("\n")
    with replacing(page) as stream:
        stream.write(page_of(report, pictures or {}))
    return page, data


def page_of(report: TrainingReport, pictures: Mapping[int, bytes]) -> str:
    """The page as HTML."""
    sections = "".join(_section(question, pictures) for question in report.questions)
    return (
        "<!doctype html><html lang=en><head><meta charset=utf-8>"
        "<meta name=viewport content='width=device-width'>"
        f"<title>Part-failure detector</title><style>{_STYLE}</style></head><body>"
        f"<h1>Part-failure detector</h1>{_summary(report)}{sections}</body></html>\n"
    )


def _summary(report: TrainingReport) -> str:
    origin = report.detector.origin
    rows = "".join(
        f"<tr><td>{escape(question.name)}</td><td>{question.confusion[1].sum()}</td>"
        f"<td>{question.confusion[0].sum()}</td><td>{_share(question.found)}</td>"
        f"<td>{_share(question.false_alarms)}</td><td>{_share(question.curve.area())}</td></tr>"
        for question in report.questions
    )
    names = ", ".join(origin.recordings[:8])
    more = f" and {len(origin.recordings) - 8} more" if len(origin.recordings) > 8 else ""
    measured = "sizes of the person" if report.by_size else "pixels"
    return (
        f"<p>{origin.people} people of {escape(names)}{more}; {report.folds} folds, split by "
        f"recording and person; features in {measured}; fingerprint "
        f"{report.detector.fingerprint}; {escape(origin.software)}.</p>"
        "<table><tr><th></th><th>off its part</th><th>on its part</th><th>failures found</th>"
        f"<th>false alarms</th><th>area under the curve</th></tr>{rows}</table>"
        "<p class=note>Every rate is of people whom the machine that judged them had not seen. "
        "Parameters and thresholds were chosen by these rates, so others may fare a little worse. "
        "The row several counts instants at which a part is lost: off its part where others are "
        "lost, too, on its part where it is the only one; a false alarm takes one for several.</p>"
    )


def _section(question: QuestionReport, pictures: Mapping[int, bytes]) -> str:
    sides = ("one part", "several") if question.name == "several" else ("on its part", "off it")
    said = ("said: one", "said: several") if question.name == "several" else ("said: on", "failed")
    rows = "".join(
        f"<tr><td>{side}</td>{''.join(f'<td>{count}</td>' for count in counts)}</tr>"
        for side, counts in zip(sides, question.confusion.tolist(), strict=True)
    )
    best = sorted(question.tried, key=lambda one: -one.worth)[:5]
    tried = "".join(f"<tr><td>{one.candidate}</td><td>{one.worth:.3f}</td></tr>" for one in best)
    mistakes = "".join(_mistake(one, pictures) for one in question.mistakes)
    shown = (
        "<h3>Most informative mistakes</h3><p class=note>Green rectangles are labelled on their "
        f"part, red ones off it.</p><div class=mistakes>{mistakes}</div>"
    )
    return (
        f"<h2>{escape(question.name)}</h2><div class=row>{_curve(question)}<div>"
        f"<table><tr><th>truth</th><th>{said[0]}</th><th>{said[1]}</th></tr>{rows}</table>"
        f"<p>{escape(question.candidate)}; fails above {question.threshold:.3f}</p>"
        f"<table><tr><th>best of the grid</th><th>found while alarms are few</th></tr>{tried}"
        f"</table></div></div>{shown if mistakes else ''}"
    )


def _curve(question: QuestionReport) -> str:
    """The curve of failures found over false alarms, with the operating point."""
    points = question.curve.points()
    points = points[np.unique(np.linspace(0, len(points) - 1, 400).round().astype(int))]
    line = " ".join(
        f"{_SIDE * alarms:.1f},{_SIDE * (1 - found):.1f}" for _, alarms, found in points
    )
    at_x, at_y = _SIDE * question.false_alarms, _SIDE * (1 - question.found)
    ticks = "".join(
        f"<text x={_SIDE * share:.0f} y={_SIDE + 15} text-anchor=middle>{share:.0%}</text>"
        f"<text x=-6 y={_SIDE * (1 - share) + 4:.0f} text-anchor=end>{share:.0%}</text>"
        for share in (0, 0.5, 1)
    )
    return (
        f"<svg width={_SIDE + 80} height={_SIDE + 55} viewBox='-50 -10 {_SIDE + 80} {_SIDE + 55}'>"
        f"<rect width={_SIDE} height={_SIDE} fill=none stroke='var(--line)'/>"
        f"<polyline points='0,{_SIDE} {line}' fill=none stroke='var(--ours)' stroke-width=2 />"
        f"<circle cx={at_x:.1f} cy={at_y:.1f} r=4 fill='var(--bad)'/>{ticks}"
        f"<text x={_SIDE / 2} y={_SIDE + 34} text-anchor=middle>false alarms</text>"
        f"<text transform='translate(-38 {_SIDE / 2}) rotate(-90)' text-anchor=middle>"
        "failures found</text></svg>"
    )


def _mistake(mistake: Mistake, pictures: Mapping[int, bytes]) -> str:
    said = "said: failed" if mistake.failed else "said: on its part"
    picture = pictures.get(mistake.sample)
    image = ""
    if picture is not None:
        data = base64.b64encode(picture).decode()
        image = f"<img alt='' src='data:image/jpeg;base64,{data}'>"
    return (
        f"<figure>{image}<figcaption>{escape(mistake.recording)}, track {mistake.track}, "
        f"frame {mistake.frame}<br>{said}, {mistake.score:+.2f}</figcaption></figure>"
    )


def _share(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.1%}"
