"""Plots: axes with round numbers, and curves in panels under one legend."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from tracking.arrays import Floats
from tracking.pages.templates import render
from tracking.translation import joined, shown

_PANEL = (400.0, 230.0)
_MARGIN = (62.0, 40.0)  # left of and above a panel
_GAP = (86.0, 84.0)
_LEGEND = 44.0
_LOOKS = 5
_LETTER = 7.2


@dataclass(frozen=True, slots=True)
class Axis:
    """One side of a drawing.

    Attributes:
        span: lowest and highest value shown. length: of the side, drawn.
        upward: greater values stand higher, as y does; else farther right.
    """

    span: tuple[float, float]
    length: float
    upward: bool = False

    def place(self, value: float) -> float:
        """Where a value stands; those beyond the span stand at its end."""
        return float(self.places(np.array([value]))[0])

    def places(self, values: Floats, *, beyond: bool = False) -> Floats:
        """The same for (n,) values; with beyond those outside of the span stand outside."""
        low, high = self.span
        share = ((values if beyond else np.clip(values, low, high)) - low) / (high - low)
        return np.asarray(self.length * (1.0 - share if self.upward else share))

    def ticks(self, about: int = 5) -> list[float]:
        """Round numbers within the span."""
        low, high = self.span
        rough = (high - low) / about
        size = 10.0 ** np.floor(np.log10(rough))
        step = min((m * size for m in (1, 2, 2.5, 5, 10)), key=lambda s: abs(s - rough))
        first = np.ceil(low / step - 1e-9)
        count = int(np.floor(high / step + 1e-9) - first) + 1
        return [float(round((first + k) * step, 10)) for k in range(count)]


@dataclass(frozen=True, slots=True)
class Axes:
    """Both sides and what they are called."""

    x: Axis
    y: Axis
    titles: tuple[str, str]


@dataclass(frozen=True, slots=True)
class Shape:
    """A line, a mark or an area of a drawing.

    Attributes:
        path: as SVG writes it. look: its class. says: what a pointer over it says.
    """

    path: str
    look: str
    says: str = ""


@dataclass(frozen=True, slots=True)
class Bar:
    """An upright rectangle of a drawing; opacity "" is full."""

    x: float
    y: float
    width: float
    height: float
    look: str
    says: str
    opacity: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Panel:
    """One diagram.

    Attributes:
        title: over it.
        curves: y by label, over `x`; NaN is a gap.
        x: shared by all curves.
        axes: what x and y are.
        x_range, y_range: lowest and highest value shown.
        points: single places that are marked, by what a pointer over them says.
    """

    title: str
    curves: Mapping[str, Floats]
    x: Floats
    axes: tuple[str, str]
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    points: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Placed:
    """A panel in its plot."""

    right: float
    down: float
    title: str
    axes: Axes
    curves: list[Shape]
    points: list[tuple[str, float, float]]


class Plot:
    """Panels side by side; a label keeps its look in all of them.

    Attributes:
        width, height: drawn. says: what they show, for those who hear the page.
        legend: place, label and look of each curve; none where there is one only.
        placed: the panels.
    """

    def __init__(self, panels: Sequence[Panel], columns: int = 2, *, says: str) -> None:
        """So many columns of panels."""
        labels = list(dict.fromkeys(label for panel in panels for label in panel.curves))
        top = _LEGEND if len(labels) > 1 else 0.0
        rows = -(-len(panels) // columns)
        self.width = 2 * _MARGIN[0] + columns * _PANEL[0] + (columns - 1) * _GAP[0] - 20
        self.height = top + _MARGIN[1] + rows * (_PANEL[1] + _GAP[1]) - 30
        self.says = says
        self.legend = list(_legend(labels)) if len(labels) > 1 else []
        self.placed = [
            _placed(
                panel,
                labels,
                _MARGIN[0] + (index % columns) * (_PANEL[0] + _GAP[0]),
                top + _MARGIN[1] + (index // columns) * (_PANEL[1] + _GAP[1]),
            )
            for index, panel in enumerate(panels)
        ]


def svg(panels: Sequence[Panel], columns: int = 2) -> str:
    """A picture file of panels side by side under one legend."""
    says = joined(", ", (panel.title for panel in panels))
    return render("pages/plot.svg", plot=Plot(panels, columns, says=says))


def path_of(places: Floats) -> str:
    """A line through (n, 2) places."""
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places.tolist())


def _legend(labels: Sequence[str]) -> Iterator[tuple[float, str, str]]:
    x = _MARGIN[0]
    for number, label in enumerate(labels):
        yield x, label, _look_of(number)
        x += 66 + _LETTER * len(str(shown(label)))


def _look_of(number: int) -> str:
    """The class of the curve of that number."""
    return f"c{number % _LOOKS}"


def _placed(panel: Panel, labels: Sequence[str], right: float, down: float) -> _Placed:
    x, y = Axis(panel.x_range, _PANEL[0]), Axis(panel.y_range, _PANEL[1], upward=True)
    curves = [
        Shape(
            _curve(x.places(panel.x), y.places(curve)),
            f"curve {_look_of(labels.index(label))}",
            label,
        )
        for label, curve in panel.curves.items()
    ]
    points = [(says, x.place(a), y.place(b)) for says, (a, b) in panel.points.items()]
    return _Placed(right, down, panel.title, Axes(x, y, panel.axes), curves, points)


def _curve(across: Floats, down: Floats) -> str:
    moves, pen_down = [], False
    for x, y in zip(across.tolist(), down.tolist(), strict=True):
        if not np.isfinite(y):
            pen_down = False
            continue
        moves.append(f"{'L' if pen_down else 'M'}{x:.1f} {y:.1f}")
        pen_down = True
    return " ".join(moves)
