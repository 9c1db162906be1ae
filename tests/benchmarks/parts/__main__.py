"""Body parts: `python -m tests.benchmarks.parts [--report] [--only SECTION ...]`."""

from __future__ import annotations

from typing import Any

import numpy as np

from tests.benchmarks.pages import Figures, Page
from tests.benchmarks.parts import clips
from tests.benchmarks.parts.cases import ADJUSTED, PLAIN, WHOLE
from tests.benchmarks.parts.loop import loops
from tests.benchmarks.parts.measures import crouching, detector, rates
from tracking.pages import Panel, svg
from tracking.scoring.parts import margin

AT_FRAME = 105
_SUBJECTS = ("head", "torso", "hip-leg", "person")
_FEWEST = 10  # a rate of fewer people is not drawn


def _detector(report: bool) -> dict[str, Any]:
    reported = (*clips.REPORTED, *clips.REPORTED_CROUCHING, *clips.REPORTED_ELSEWHERE)
    return detector(reported if report else clips.CHECKED)


def rates_picture(figures: Figures) -> str:
    """The paper's figure 4: a diagram a part and one for the person, as SVG."""
    panels = []
    for index, subject in enumerate(_SUBJECTS):
        curves = {
            name: _drawn(variant, index)
            for name, variant in figures["variants"].items()
            if not (name == WHOLE.name and subject != "person")
        }
        x = np.arange(len(next(iter(curves.values()))), dtype=float)
        axes = ("frames since the start", "people tracked rightly, %")
        panels.append(Panel(subject, curves, x, axes, (0.0, float(x[-1])), (0.0, 100.0)))
    return svg(panels)


def _drawn(variant: Figures, subject: int) -> Any:
    people = np.array(variant["people"])
    return np.where(people >= _FEWEST, 100 * np.array(variant["right"])[:, subject], np.nan)


def roc_picture(figures: Figures) -> str:
    """Share of failures found over share of false alarms, by machine, as SVG."""
    machines, grid = figures["machines"], 100 * np.array(figures["grid"])
    held = {name: machine["curve"] for name, machine in machines.items()}
    new = {name: machine["new"]["curve"] for name, machine in machines.items() if machine["new"]}
    axes = ("false alarms, %", "failures found, %")
    panels = []
    for title, curves in (("people held out", held), ("scenes never trained on", new)):
        shares = {name: 100 * np.array(curve) for name, curve in curves.items()}
        panels.append(Panel(title, shares, grid, axes, (0.0, 20.0), (0.0, 100.0)))
    return svg(panels)


PAGE = Page(
    subject="parts",
    about=__doc__ or "",
    measures={
        "rates": lambda report: rates(clips.REPORTED if report else clips.TUNED),
        "crouching": lambda report: crouching(
            clips.REPORTED_CROUCHING if report else clips.TUNED_CROUCHING
        ),
        "detector": _detector,
        "taught": loops,
    },
    words={
        "frame": AT_FRAME,
        "paper": {
            ADJUSTED.name: (95, 83, 91, 95),
            PLAIN.name: (67, 68, 64, ""),
            WHOLE.name: ("", "", "", 75),
        },
        "goals": dict(zip(_SUBJECTS, (97, 92, 95, 98), strict=True)),
        "margin": margin,
    },
    diagrams={"rates": ("rates", rates_picture), "detector": ("detector-roc", roc_picture)},
)

if __name__ == "__main__":
    PAGE.main()
