"""docs/results/parts.md, written from the figures that were measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tests.benchmarks.parts.tracker_runs import ADJUSTED, PLAIN, WHOLE
from tests.benchmarks.parts.words import (
    CROUCHING,
    DETECTOR,
    EQUALISATION,
    HOW_RATES,
    INTRODUCTION,
    PICTURE,
    REAL,
    SHADOWS,
    SHORT,
    SPEED,
)
from tracking.pages import Panel, svg
from tracking.scoring.parts import SUBJECTS, margin

Figures = Mapping[str, Any]

AT_FRAME = 105
PAPER = {
    ADJUSTED.name: {"head": 95, "torso": 83, "hip_leg": 91, "person": 95},
    PLAIN.name: {"head": 67, "torso": 68, "hip_leg": 64},
    WHOLE.name: {"person": 75},
}
GOALS = {"head": 97, "torso": 92, "hip_leg": 95, "person": 98}
TITLES = {"head": "head", "torso": "torso", "hip_leg": "hip-leg", "person": "person"}
MOST_FALSE_ALARMS = 0.1
_FEWEST = 10  # a rate of fewer people is not drawn


def results(figures: Figures) -> str:
    """The whole page; sections that were not measured say so."""
    writers = {
        "rates": _rates,
        "crouching": _crouching,
        "equalisation": _equalisation,
        "detector": _detector,
        "real": _real,
        "speed": _speed,
    }
    parts = [INTRODUCTION]
    for name, write in writers.items():
        if name in figures:
            parts.append(write(figures[name]))
    return "\n\n".join(part.strip() for part in parts) + "\n"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table; the first column is text, the others are numbers."""
    lines = [head, ["---", *["---:"] * (len(head) - 1)], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def rates_picture(figures: Figures) -> str:
    """The paper's figure 4: a diagram a part and one for the person, as SVG."""
    panels = []
    for index, subject in enumerate(SUBJECTS):
        curves = {
            name: _drawn(variant, index)
            for name, variant in figures["variants"].items()
            if not (name == WHOLE.name and subject != "person")
        }
        x = np.arange(len(next(iter(curves.values()))), dtype=float)
        axes = ("frames since the start", "people tracked rightly, %")
        panels.append(Panel(TITLES[subject], curves, x, axes, (0.0, float(x[-1])), (0.0, 100.0)))
    return svg(panels)


def _drawn(variant: Figures, subject: int) -> Any:
    people = np.array(variant["people"])
    return np.where(people >= _FEWEST, 100 * np.array(variant["right"])[:, subject], np.nan)


def rates_tables(figures: Figures) -> str:
    """Both readings and what the rectangles hold besides, without words."""
    variants = figures["variants"]
    return "\n\n".join(
        (
            _rates_table(variants, "right"),
            _rates_table(variants, "unbroken"),
            _foreign_table(variants),
        )
    )


def _rates(figures: Figures) -> str:
    variants = figures["variants"]
    sections = [HOW_RATES.format(clips=len(figures["clips"])).strip()]
    sections.append(_rates_table(variants, "right"))
    sections += [_verdicts(variants), SHORT.strip()]
    sections.append("![rates over frames](parts-rates.svg)")
    sections.append(PICTURE.strip())
    sections.append(
        f"The stricter reading: right in *every* frame from the start to frame {AT_FRAME}, so\n"
        "that a part which comes back stays lost."
    )
    sections.append(_rates_table(variants, "unbroken"))
    sections += [SHADOWS.strip(), _foreign_table(variants)]
    return "\n\n".join(sections)


def _rates_table(variants: Figures, reading: str) -> str:
    rows = []
    for name, variant in variants.items():
        people = variant["people"][AT_FRAME]
        for source, cells in (
            ("paper", [_paper_cell(name, subject) for subject in SUBJECTS]),
            ("ours", [_cell(variant, name, reading, i) for i in range(len(SUBJECTS))]),
        ):
            if source == "paper" and (name not in PAPER or reading != "right"):
                continue
            count = str(people) if source == "ours" else "72 at the start"
            rows.append([f"{name}, {source}", *cells, count])
    head = (f"at frame {AT_FRAME}, %", *TITLES.values(), "people")
    return table(head, rows)


def _paper_cell(name: str, subject: str) -> str:
    value = PAPER.get(name, {}).get(subject)
    return "" if value is None else str(value)


def _cell(variant: Figures, name: str, reading: str, subject: int) -> str:
    if name == WHOLE.name and SUBJECTS[subject] != "person":
        return ""
    share, people = variant[reading][AT_FRAME][subject], variant["people"][AT_FRAME]
    return f"{100 * share:.1f} ± {100 * margin(share, people):.1f}" if people else "-"


def _verdicts(variants: Figures) -> str:
    """Which goals are met, said of the best of ours and of the gain."""
    if not {ADJUSTED.name, PLAIN.name} <= set(variants):
        return ""
    rows = []
    with_, without = (variants[name]["right"][AT_FRAME] for name in (ADJUSTED.name, PLAIN.name))
    for index, subject in enumerate(SUBJECTS):
        ours, gain = 100 * with_[index], 100 * (with_[index] - without[index])
        met = "met" if ours >= GOALS[subject] else f"short by {GOALS[subject] - ours:.1f}"
        gained = "met" if gain >= 15 else f"short by {15 - gain:.1f}"
        rows.append(
            [TITLES[subject], str(GOALS[subject]), f"{ours:.1f}", met, f"{gain:+.1f}", gained]
        )
    head = ("with adjustment", "goal", "ours", "", "gain over none", "goal of 15")
    return table(head, rows)


def _foreign_table(variants: Figures) -> str:
    rows = [
        [name, *(f"{100 * share:.1f}" for share in variant["foreign"])]
        for name, variant in variants.items()
        if name != WHOLE.name
    ]
    return table(("outside of the part, %", "head", "torso", "hip-leg"), rows)


def _crouching(figures: Figures) -> str:
    words = CROUCHING.format(clips=len(figures["clips"]))
    return words + "\n\n" + crouching_table(figures)


def crouching_table(figures: Figures) -> str:
    """What became of everybody who went down, by tracker."""
    rows = []
    for name, counted in figures["variants"].items():
        stoops = counted["stoops"]
        rows.append(
            [
                name,
                f"{stoops} ({counted['bent']} bent over)",
                f"{counted['kept']} of {stoops}",
                f"{counted['recovered']} of {stoops}",
                "-" if counted["median_s"] is None else f"{counted['median_s']:.2f} s",
                "-" if counted["longest_s"] is None else f"{counted['longest_s']:.2f} s",
                str(counted["not_recovered"]),
            ]
        )
    head = (
        "tracker", "times down", "person kept", "all parts right within 1 s", "median", "longest",
        "never",
    )  # fmt: skip
    return table(head, rows)


def _equalisation(figures: Figures) -> str:
    rows = [
        [
            TITLES[part],
            *(f"{found[name]:.3f}" for name in ("with", "without")),
            *(f"{found[name]:.2f}" for name in ("paper_with", "paper_without")),
            "met" if found["with"] <= MOST_FALSE_ALARMS else "missed",
        ]
        for part, found in figures["parts"].items()
    ]
    head = (
        "false alarms, %", "equalised", "not equalised", "paper: equalised", "not", "goal of 0.1",
    )  # fmt: skip
    return EQUALISATION.strip() + "\n\n" + table(head, rows)


def _detector(figures: Figures) -> str:
    rows = []
    for name, machine in figures["machines"].items():
        found = [f"{100 * machine['found'][share]:.1f}" for share in ("0.01", "0.02", "0.05")]
        row = [name, str(machine["on"]), str(machine["off"]), f"{machine['area']:.3f}", *found]
        rows.append([*row, *_on_new_scenes(machine["new"])])
    head = (
        "machine", "on", "off", "area", "found at 1 %", "at 2 %", "at 5 %",
        "new scenes: off", "area", "false alarms, %", "found, %",
    )  # fmt: skip
    text = DETECTOR.format(
        people=figures["people"], recordings=figures["recordings"], clips=figures["new_clips"]
    )
    return "\n\n".join(
        (text.strip(), table(head, rows), "![receiver operating curves](parts-detector-roc.svg)")
    )


def _on_new_scenes(new: Figures | None) -> list[str]:
    if new is None:
        return ["", "", "", ""]
    shares = [f"{100 * new[name]:.1f}" for name in ("false_alarms", "found")]
    return [str(new["off"]), f"{new['area']:.3f}", *shares]


def roc_picture(figures: Figures) -> str:
    """Share of failures found over share of false alarms, by machine, as SVG."""
    grid = np.array(figures["grid"])
    machines = figures["machines"]
    held = {name: machine["curve"] for name, machine in machines.items()}
    new = {name: machine["new"]["curve"] for name, machine in machines.items() if machine["new"]}
    axes = ("false alarms, %", "failures found, %")
    panels = [
        Panel(
            title,
            {name: 100 * np.array(curve) for name, curve in curves.items()},
            100 * grid,
            axes,
            (0.0, 20.0),
            (0.0, 100.0),
        )
        for title, curves in (("people held out", held), ("scenes never trained on", new))
    ]
    return svg(panels)


def _real(figures: Figures) -> str:
    rows = [
        [
            name,
            str(kept["people"]),
            str(kept["in_view"]),
            *(f"{count} of {kept['people']}" for count in kept["parts"]),
            f"{kept['at_end']} of {kept['people']}",
            f"{kept['throughout']} of {kept['people']}",
            f"{kept['person']} of {kept['people']}",
        ]
        for name, kept in figures.items()
    ]
    head = (
        "recording", "people", "in view for 100 frames", "head", "torso", "hip-leg", "all three",
        "all three, throughout", "person",
    )  # fmt: skip
    return REAL + "\n\n" + table(head, rows)


def _speed(figures: Figures) -> str:
    words = SPEED.format(fps=figures["fps"], frames=int(figures["frames"]))
    stages = {name: value for name, value in figures.items() if name.endswith("_ms")}
    rows = [
        [name.removesuffix("_ms").replace("_", " "), "-" if value is None else f"{value:.2f}"]
        for name, value in stages.items()
    ]
    return words.strip() + "\n\n" + table(("stage", "ms a frame"), rows)
