"""Axes of a drawing: where values stand, round numbers beside them, a frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.pages.elements import Element, element

Floats = NDArray[np.float64]


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
        low, high = self.span
        share = (min(max(value, low), high) - low) / (high - low)
        return self.length * (1.0 - share if self.upward else share)

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

    def drawn(self, *, grid: bool = True, about: tuple[int, int] = (5, 5)) -> Iterator[Element]:
        """Ticks with numbers, lines across, the frame and the titles."""
        width, height = self.x.length, self.y.length
        for value in self.y.ticks(about[1]):
            y = self.y.place(value)
            yield _line((0, y), (width, y), "grid") if grid else _line((-5, y), (0, y), "tick")
            yield element("text", _number(value), x=-8, y=y + 4, text_anchor="end", class_="small")
        for value in self.x.ticks(about[0]):
            x = self.x.place(value)
            yield _line((x, height), (x, height + 5), "tick")
            yield element(
                "text", _number(value), x=x, y=height + 19, text_anchor="middle", class_="small"
            )
        yield element("rect", width=width, height=height, class_="frame")
        yield element("text", self.titles[0], x=width / 2, y=height + 37, text_anchor="middle")
        turned = f"translate(-46 {height / 2:g}) rotate(-90)"
        yield element("text", self.titles[1], transform=turned, text_anchor="middle")


def group(left: float, top: float, *content: Element) -> Element:
    """Elements moved to a place."""
    return element("g", content, transform=f"translate({left:g} {top:g})")


def drawing(width: float, height: float, *content: Element, says: str) -> Element:
    """A picture of a page; it shrinks with the page.

    Args:
        says: what it shows, for those who hear the page.
    """
    return element(
        "svg",
        content,
        viewBox=f"0 0 {width:g} {height:g}",
        style=f"max-width:{width:g}px",
        role="img",
        aria_label=says,
    )


def _line(start: tuple[float, float], end: tuple[float, float], look: str) -> Element:
    return element("line", x1=start[0], y1=start[1], x2=end[0], y2=end[1], class_=look)


def _number(value: float) -> str:
    return f"{value:,.10g}".replace("-", "−")
