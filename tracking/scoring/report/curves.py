"""HOTA and its parts over the strictness of matching."""

from __future__ import annotations

import numpy as np

from tracking.pages import Element, Panel, drawn
from tracking.scoring.hota import ALPHAS
from tracking.scoring.report.findings import ScoreReport

PARTS = ("HOTA", "DetA", "AssA", "LocA")
_NAMED = 28


def hota_curves(report: ScoreReport) -> Element:
    """One result: its curves in one diagram; several: a diagram for each curve."""
    says = "HOTA, DetA, AssA and LocA over the similarity from which rows match"
    if len(report.results) == 1:
        curves = report.overall[report.results[0]].hota
        return drawn(
            [_panel("HOTA and its parts", {p: curves.curve(p) for p in PARTS})], 1, says=says
        )
    panels = [
        _panel(part, {_short(n): report.overall[n].hota.curve(part) for n in report.results})
        for part in PARTS
    ]
    return drawn(panels, 2, says=says)


def _panel(
    title: str, curves: dict[str, np.ndarray[tuple[int, ...], np.dtype[np.float64]]]
) -> Panel:
    axes = ("similarity from which rows match (α)", "share")
    return Panel(title, curves, ALPHAS, axes, (0.0, 1.0), (0.0, 1.0))


def _short(name: str) -> str:
    """A name that leaves room for others in a legend; different ones stay so."""
    return name if len(name) <= _NAMED else f"{name[:12]}…{name[-15:]}"
