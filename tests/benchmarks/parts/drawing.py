"""Curves as an SVG picture, written as plain text."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_INK, _FAINT, _PAPER = "#24292f", "#d0d7de", "#ffffff"
_PANEL = (400.0, 230.0)
_MARGIN = (62.0, 40.0)  # left of and above a panel
_GAP = (86.0, 84.0)
_LEGEND = 44.0


@dataclass(frozen=True, slots=True)
class Line:
    """A curve's look: colour and dash pattern ("" is solid)."""

    colour: str
    dashes: str = ""


LINES = (
    Line("#0969da"),
    Line("#cf222e", "7 4"),
    Line("#1a7f37", "2 3"),
    Line("#8250df", "10 3 2 3"),
    Line("#9a6700", "14 4"),
)
"""In the order of curves: told apart without colours too."""


@dataclass(frozen=True, slots=True, eq=False)
class Panel:
    """One diagram.

    Attributes:
        title: over it.
        curves: y by label, over `x`; NaN is a gap.
        x: shared by all curves.
        axes: what x and y are.
        y_range, x_range: lowest and highest value shown.
    """

    title: str
    curves: Mapping[str, Floats]
    x: Floats
    axes: tuple[str, str]
    x_range: tuple[float, float]
    y_range: tuple[float, float]


def svg(panels: Sequence[Panel], columns: int = 2) -> str:
    """The picture of panels side by side under one legend; labels keep their look in all."""
    labels = list(dict.fromkeys(label for panel in panels for label in panel.curves))
    rows = -(-len(panels) // columns)
    width = 2 * _MARGIN[0] + columns * _PANEL[0] + (columns - 1) * _GAP[0] - 20
    height = _LEGEND + _MARGIN[1] + rows * (_PANEL[1] + _GAP[1])
    body = [_legend(labels)]
    for index, panel in enumerate(panels):
        left = _MARGIN[0] + (index % columns) * (_PANEL[0] + _GAP[0])
        top = _LEGEND + _MARGIN[1] + (index // columns) * (_PANEL[1] + _GAP[1])
        body.append(f'<g transform="translate({left:g} {top:g})">{_panel(panel, labels)}</g>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
        f'width="{width:g}" height="{height:g}" font-family="sans-serif" font-size="13" '
        f'fill="{_INK}"><rect width="{width:g}" height="{height:g}" fill="{_PAPER}"/>'
        + "\n".join(body)
        + "</svg>\n"
    )


def _legend(labels: Sequence[str]) -> str:
    parts, x = [], _MARGIN[0]
    for label, line in zip(labels, LINES, strict=False):
        parts.append(f'<line x1="{x:g}" y1="30" x2="{x + 34:g}" y2="30" {_stroke(line)}/>')
        parts.append(f'<text x="{x + 42:g}" y="35">{label}</text>')
        x += 66 + 7.2 * len(label)
    return "".join(parts)


def _stroke(line: Line) -> str:
    dashes = f' stroke-dasharray="{line.dashes}"' if line.dashes else ""
    return f'fill="none" stroke="{line.colour}" stroke-width="2"{dashes}'


def _panel(panel: Panel, labels: Sequence[str]) -> str:
    width, height = _PANEL
    parts = [f'<text x="0" y="-12" font-weight="bold">{panel.title}</text>']
    for value in _ticks(panel.y_range):
        y = _place(value, panel.y_range, height, upward=True)
        parts.append(f'<line x1="0" x2="{width:g}" y1="{y:.1f}" y2="{y:.1f}" stroke="{_FAINT}"/>')
        parts.append(f'<text x="-8" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
    for value in _ticks(panel.x_range):
        x = _place(value, panel.x_range, width)
        parts.append(
            f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{height:g}" y2="{height + 5:g}" stroke="{_INK}"/>'
        )
        parts.append(f'<text x="{x:.1f}" y="{height + 20:g}" text-anchor="middle">{value:g}</text>')
    parts.append(
        f'<rect width="{width:g}" height="{height:g}" fill="none" stroke="{_INK}"/>'
        f'<text x="{width / 2:g}" y="{height + 40:g}" text-anchor="middle">{panel.axes[0]}</text>'
        f'<text transform="translate(-44 {height / 2:g}) rotate(-90)" text-anchor="middle">'
        f"{panel.axes[1]}</text>"
    )
    for label, curve in panel.curves.items():
        look = LINES[labels.index(label) % len(LINES)]
        parts.append(f'<path d="{_path(panel, curve)}" {_stroke(look)}/>')
    return "".join(parts)


def _path(panel: Panel, curve: Floats) -> str:
    moves, pen_down = [], False
    for x, y in zip(panel.x, curve, strict=True):
        if not np.isfinite(y):
            pen_down = False
            continue
        across = _place(float(x), panel.x_range, _PANEL[0])
        down = _place(float(np.clip(y, *panel.y_range)), panel.y_range, _PANEL[1], upward=True)
        moves.append(f"{'L' if pen_down else 'M'}{across:.1f} {down:.1f}")
        pen_down = True
    return " ".join(moves)


def _place(
    value: float, span: tuple[float, float], length: float, *, upward: bool = False
) -> float:
    share = (value - span[0]) / (span[1] - span[0])
    return length * (1.0 - share if upward else share)


def _ticks(span: tuple[float, float]) -> list[float]:
    """Round numbers within a span, about five of them."""
    rough = (span[1] - span[0]) / 5
    size = 10.0 ** np.floor(np.log10(rough))
    step = min((m * size for m in (1, 2, 2.5, 5, 10)), key=lambda s: abs(s - rough))
    first = np.ceil(span[0] / step - 1e-9)
    count = int(np.floor(span[1] / step + 1e-9) - first) + 1
    return [float(round((first + k) * step, 10)) for k in range(count)]
