"""docs/results/flow.md, written from the figures that were measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from tests.benchmarks.flow import words
from tests.benchmarks.flow.counts import STRETCH_S
from tests.benchmarks.pages import Figures, met, table
from tracking.counting import PAPER_STEP_S
from tracking.pages import Panel, svg

PAPER = {"lane": (963, 1057), "two-way": (865, 801)}
"""True and counted sums of [Yoneji2013] table 2."""

MOST_OFF, LEAST_HIT = 5.0, 95.0
"""Goals, in per cent."""

MOST_MS, LEAST_GAIN = 10.0, 2.0
"""Goals: milliseconds a frame, and how much faster a warm start is."""

OURS = "flow"


def writers() -> Mapping[str, Callable[[Any], str]]:
    """A writer for each section, in the page's order."""
    return {"scenes": _scenes, "real": _real, "speed": _speed}


def _scenes(rows: Sequence[Figures]) -> str:
    stretch = words.STRETCHES.format(stretch=STRETCH_S).strip()
    return "\n\n".join(
        (
            words.SCENES.strip(),
            _sums_table(rows),
            _hits_table(rows, "scene"),
            _goals(rows),
            words.PICTURE.strip(),
            stretch,
            _stretches_table([row for row in rows if row["tracker"] == OURS]),
        )
    )


def _sums_table(rows: Sequence[Figures]) -> str:
    cells = [
        [f"{scene}: paper", "", "", str(true), str(counted), _off(true, counted), ""]
        for scene, (true, counted) in PAPER.items()
    ]
    cells += [
        [
            f"{row['scene']} {row['seed']}: {row['tracker']}",
            str(row["most"]),
            str(row["seen_sum"]),
            str(row["true_sum"]),
            str(row["sum"]),
            _off(row["true_sum"], row["sum"]),
            f"{row['mean_difference']:.2f}",
        ]
        for row in rows
    ]
    head = (
        "sums", "most at once", "seen", "true", "counted", "off", "mean difference a step",
    )  # fmt: skip
    return table(head, cells)


def _off(true: int, counted: int) -> str:
    return f"{100 * (counted - true) / true:+.1f} %" if true else "-"


def _hits_table(rows: Sequence[Figures], named: str) -> str:
    cells = [
        [
            " ".join(
                str(row[key]) for key in dict.fromkeys((named, "seed", "tracker")) if key in row
            ),
            *(str(row[name]) for name in ("happened", "found", "hit")),
            _share(row["hit"], row["happened"]),
            _share(row["hit"], row["found"]),
            ", ".join(f"{name}: {100 * rate:.0f}" for name, rate in row.get("by_line", {}).items()),
        ]
        for row in rows
    ]
    head = (
        "passages", "happened", "counted", "hit", "of those that happened", "of those counted",
        "hit by line, %",
    )  # fmt: skip
    return table(head, cells)


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %" if whole else "-"


def _goals(rows: Sequence[Figures]) -> str:
    cells = []
    for scene in PAPER:
        own = [row for row in rows if row["scene"] == scene and row["tracker"] == OURS]
        sums = {name: sum(row[name] for row in own) for name in _SUMMED}
        if not sums["true_sum"] or not sums["happened"]:
            continue
        off = abs(100 * (sums["sum"] - sums["true_sum"]) / sums["true_sum"])
        hit = 100 * sums["hit"] / sums["happened"]
        cells.append([f"{scene}: sum off, %", f"{MOST_OFF:g}", f"{off:.1f}"])
        cells[-1].append(met(off, MOST_OFF, at_most=True))
        cells.append([f"{scene}: passages hit, %", f"{LEAST_HIT:g}", f"{hit:.1f}"])
        cells[-1].append(met(hit, LEAST_HIT))
    return table(("over all clips of a scene", "goal", "ours", ""), cells)


_SUMMED = ("true_sum", "sum", "happened", "hit")


def _stretches_table(rows: Sequence[Figures]) -> str:
    cells = []
    for row in rows:
        for index, (true, counted) in enumerate(row["stretches"]):
            start = index * STRETCH_S
            name = f"{row['scene']} {row['seed']}, {start:g} to {start + STRETCH_S:g} s"
            cells.append([name, str(true), str(counted), _off(true, counted)])
    return table(("stretch", "true", "counted", "off"), cells)


def counts_picture(rows: Sequence[Figures]) -> str:
    """The paper's figure 10: people in the region over time, true and counted, as SVG."""
    panels = []
    for row in rows:
        if row["tracker"] != OURS:
            continue
        true, ours = np.array(row["true_steps"], float), np.array(row["steps"], float)
        x = PAPER_STEP_S * np.arange(len(true))
        top = max(float(true.max(initial=1.0)), float(ours.max(initial=1.0))) + 1.0
        curves = {"true": true, "counted": ours}
        title = f"{row['scene']} {row['seed']}"
        axes = ("seconds", "people in the region")
        panels.append(Panel(title, curves, x, axes, (0.0, float(x[-1])), (0.0, top)))
    return svg(panels)


def _real(figures: Figures) -> str:
    parts = []
    if "overhead" in figures:
        parts += [words.OVERHEAD.strip(), _hits_table(figures["overhead"], "tracker")]
        parts.append(_said(figures["overhead"]))
    if "pets" in figures:
        parts += [words.PETS.strip(), _pets_sums(figures["pets"])]
        parts.append(_hits_table(figures["pets"], "tracker"))
    return "\n\n".join(parts)


def _said(rows: Sequence[Figures]) -> str:
    lines = []
    for row in rows:
        said = [
            f"frame {frame} {'to the right' if ahead else 'to the left'}"
            for frame, ahead in row["passages"]
        ]
        lines.append(f"- {row['tracker']}: {', '.join(said) or 'none'}")
    return "Counted there:\n\n" + "\n".join(lines)


def _pets_sums(rows: Sequence[Figures]) -> str:
    cells = [
        [
            row["tracker"],
            str(row["true_sum"]),
            str(row["sum"]),
            _off(row["true_sum"], row["sum"]),
            f"{row['mean_difference']:.2f}",
        ]
        for row in rows
    ]
    return table(("sums", "true", "counted", "off", "mean difference a step"), cells)


def _speed(figures: Figures) -> str:
    rows = [[name, "-" if value is None else f"{value:.2f}"] for name, value in figures.items()]
    goals = [
        ["a frame, ms", f"{MOST_MS:g}", f"{figures['ms']:.1f}"],
        ["warm start, times as fast", f"{LEAST_GAIN:g}", f"{figures['warm_vs_cold']:.1f}"],
    ]
    goals[0].append(met(figures["ms"], MOST_MS, at_most=True))
    goals[1].append(met(figures["warm_vs_cold"], LEAST_GAIN))
    parts = (
        words.SPEED.strip(),
        table(("figure", ""), rows),
        table(("", "goal", "ours", ""), goals),
    )
    return "\n\n".join(parts)
