"""Curves over an axis, in panels under one legend."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from tracking.pages.axes import Axes, Axis, Floats, drawing, group
from tracking.pages.elements import Element, element, svg_text
from tracking.pages.look import ALONE

_PANEL = (400.0, 230.0)
_MARGIN = (62.0, 40.0)  # left of and above a panel
_GAP = (86.0, 84.0)
_LEGEND = 44.0
_LOOKS = 5
_LETTER = 7.2


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


def svg(panels: Sequence[Panel], columns: int = 2) -> str:
    """A picture file of panels side by side under one legend."""
    root = drawn(panels, columns, says=", ".join(panel.title for panel in panels))
    _, _, width, height = root.get("viewBox", "").split()
    root.attrib.pop("style")
    root.set("width", width)
    root.set("height", height)
    root.insert(0, element("style", ALONE))
    root.insert(1, element("rect", width=width, height=height, style="fill:var(--paper)"))
    return svg_text(root)


def drawn(panels: Sequence[Panel], columns: int = 2, *, says: str) -> Element:
    """The same for a page; a label keeps its look in all panels.

    Args:
        says: what they show, for those who hear the page.
    """
    labels = list(dict.fromkeys(label for panel in panels for label in panel.curves))
    top = _LEGEND if len(labels) > 1 else 0.0
    rows = -(-len(panels) // columns)
    width = 2 * _MARGIN[0] + columns * _PANEL[0] + (columns - 1) * _GAP[0] - 20
    height = top + _MARGIN[1] + rows * (_PANEL[1] + _GAP[1]) - 30
    body = list(_legend(labels)) if len(labels) > 1 else []
    for index, panel in enumerate(panels):
        right = _MARGIN[0] + (index % columns) * (_PANEL[0] + _GAP[0])
        down = top + _MARGIN[1] + (index // columns) * (_PANEL[1] + _GAP[1])
        body.append(group(right, down, *_panel(panel, labels)))
    return drawing(width, height, *body, says=says)


def look_of(number: int) -> str:
    """The class of the curve of that number, and of what belongs to it elsewhere."""
    return f"c{number % _LOOKS}"


def _legend(labels: Sequence[str]) -> Iterator[Element]:
    x = _MARGIN[0]
    for number, label in enumerate(labels):
        yield element("line", x1=x, y1=30, x2=x + 34, y2=30, class_=f"curve {look_of(number)}")
        yield element("text", label, x=x + 42, y=35)
        x += 66 + _LETTER * len(label)


def _panel(panel: Panel, labels: Sequence[str]) -> Iterator[Element]:
    x, y = Axis(panel.x_range, _PANEL[0]), Axis(panel.y_range, _PANEL[1], upward=True)
    yield element("text", panel.title, x=0, y=-12, class_="title")
    yield from Axes(x, y, panel.axes).drawn()
    for label, curve in panel.curves.items():
        path = _path(x.places(panel.x), y.places(curve))
        line = element("path", d=path, class_=f"curve {look_of(labels.index(label))}")
        line.append(element("title", label))
        yield line
    for said, (at_x, at_y) in panel.points.items():
        dot = element("circle", cx=x.place(at_x), cy=y.place(at_y), r=4.5, class_="point")
        dot.append(element("title", said))
        yield dot


def _path(across: Floats, down: Floats) -> str:
    moves, pen_down = [], False
    for x, y in zip(across.tolist(), down.tolist(), strict=True):
        if not np.isfinite(y):
            pen_down = False
            continue
        moves.append(f"{'L' if pen_down else 'M'}{x:.1f} {y:.1f}")
        pen_down = True
    return " ".join(moves)
