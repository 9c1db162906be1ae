"""How figures are told: with their units, and beside their goals."""

from __future__ import annotations

from collections.abc import Mapping

_UNITS = {
    "vs": "times theirs",
    "speed_up": "times one process",
    "off_the_line": "share",
    "share": "share",
    "us_per_person": "\u00b5s a person",
    "us_per_particle": "\u00b5s a particle",
    "fps": "frames/s",
    "mb": "MB",
    "ms": "ms",
}
"""By whole words of the name; the first of them counts."""
_COUNTS = ("people", "particles", "frames", "rows")
"""Last words of names of figures that count something."""


def met(ours: float, goal: float, *, at_most: bool = False, digits: int = 1) -> str:
    """Whether a goal is met, or by how much it is missed."""
    lack = ours - goal if at_most else goal - ours
    if lack <= 0:
        return "met"
    if lack != lack:
        return "not measured"
    least = 10.0**-digits
    return f"missed by {lack:.{digits}f}" if lack >= least / 2 else f"missed by less than {least:g}"


def unit_of(name: str) -> str:
    """The unit a figure is in, by its name.

    Names carry their units, so that JSON needs none beside them.

    Raises:
        ValueError: the name tells none.
    """
    for words, unit in _UNITS.items():
        if f"_{words}_" in f"_{name}_":
            return unit
    counted = name.split("_")[-1]
    if counted not in _COUNTS:
        raise ValueError(f"{name}: this name tells no unit; have it tell one of {__name__}")
    return counted


def table(group: str, about: str, figures: Mapping[str, float | None]) -> str:
    """A group's figures for people: what they are about, then a line each with its unit."""
    width = max(map(len, figures), default=0)
    lines = [
        f"  {name:<{width}} "
        + ("not measured" if value is None else f"{value:12.2f} {unit_of(name)}")
        for name, value in figures.items()
    ]
    words = [f"  {line.strip()}" for line in about.strip().splitlines() if line.strip()]
    return "\n".join(line.rstrip() for line in (group, *words, "", *lines, ""))
