"""HOTA and its parts over the strictness of matching."""

from __future__ import annotations

import math

import numpy as np

from tracking.pages import Panel, Plot
from tracking.scoring.hota import ALPHAS
from tracking.scoring.parts import SUBJECTS, Rates
from tracking.scoring.report.findings import ScoreReport
from tracking.translation import msg

PARTS = ("HOTA", "DetA", "AssA", "LocA")
PART_HEAD = (
    msg("body part"),
    msg("right, of all frames"),
    msg("of its rectangle, something else"),
)
_NAMED = 28


def hota_curves(report: ScoreReport) -> Plot:
    """One result: its curves in one diagram; several: a diagram for each curve."""
    says = msg("HOTA, DetA, AssA and LocA over the similarity from which rows match")
    if len(report.results) == 1:
        curves = report.overall[report.results[0]].hota
        return Plot(
            [_panel(msg("HOTA and its parts"), {p: curves.curve(p) for p in PARTS})], 1, says=says
        )
    panels = [
        _panel(part, {_short(n): report.overall[n].hota.curve(part) for n in report.results})
        for part in PARTS
    ]
    return Plot(panels, 2, says=says)


def part_curves(rates: Rates) -> Plot:
    """How many people's parts are tracked rightly, over the frames since a person's start."""
    length = int(np.count_nonzero(rates.people))
    curves = {_word(name): 100 * rates.right[:length, n] for n, name in enumerate(SUBJECTS)}
    panel = Panel(
        msg("body parts tracked rightly"),
        curves,
        np.arange(float(length)),
        (msg("frames since a person's start"), msg("people, %")),
        (0.0, float(max(length - 1, 1))),
        (0.0, 100.0),
    )
    return Plot([panel], 1, says=msg("how many people's body parts are tracked rightly over time"))


def part_rows(rates: Rates) -> list[tuple[str, str, str]]:
    """Each part, how often it is right, and how much of its rectangle holds something else."""
    foreign = (*rates.foreign.tolist(), math.nan)
    shares = zip(SUBJECTS, rates.overall.tolist(), foreign, strict=True)
    return [(_word(name), _percent(right), _percent(other)) for name, right, other in shares]


def _word(subject: str) -> str:
    return msg(subject.replace("_", "-"))


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %" if math.isfinite(share) else "–"


def _panel(
    title: str, curves: dict[str, np.ndarray[tuple[int, ...], np.dtype[np.float64]]]
) -> Panel:
    axes = (msg("similarity from which rows match (α)"), msg("share"))
    return Panel(title, curves, ALPHAS, axes, (0.0, 1.0), (0.0, 1.0))


def _short(name: str) -> str:
    """A name that leaves room for others in a legend; different ones stay so."""
    return name if len(name) <= _NAMED else f"{name[:12]}…{name[-15:]}"
