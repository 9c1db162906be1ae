"""How different people's colours look: least CIEDE2000 of every two, and of each to the grounds.

Usual eyes and three kinds of colour blindness [Machado2009, severity 1.0], on pictures, in the dark
look and in the light one; and the contrast to the grounds. `--search STEPS` looks for a better
palette first, see `palette_search.py`, and `--write` keeps it in `resources/themes/people.toml`.
"""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_sight import SIGHTS, differences
from app.core.colours.palette import LIGHT_COLOURS, TRACK_COLOURS
from app.core.colours.shown_colours import GROUNDS, THEMES, contrast, theme_colour
from app.core.scenes import Colour
from tests.benchmarks.command import one_core, parser_of, tell
from tests.benchmarks.palette_search import NEAR_IDS, Pairs, search

Floats = NDArray[np.float64]

PLACE = Path(str(files("resources") / "themes" / "people.toml"))
IN_USE: Pairs = (TRACK_COLOURS, tuple(LIGHT_COLOURS[one] for one in TRACK_COLOURS))
"""Of the dark look, which are those on pictures, too, and of the light one."""
_FIRST = 8


def main() -> None:
    """Print the figures of the palette in use, or search for another one first."""
    parser = parser_of("palette", __doc__)
    parser.add_argument("--search", type=int, default=0, metavar="STEPS")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", action="store_true", help="keep what was found")
    parser.add_argument("--json", action="store_true", help="one JSON document instead of a table")
    asked = parser.parse_args()
    one_core()
    colours = IN_USE
    if asked.search:
        colours = search(len(TRACK_COLOURS), asked.search, asked.seed)
        tell("\n".join(" ".join(pair) for pair in zip(*map(_codes, colours), strict=True)))
        if asked.write:
            write(colours)
    figures = measure(colours)
    print(json.dumps(figures, indent=1) if asked.json else _table(figures))


def measure(pairs: Pairs) -> dict[str, dict[str, float]]:
    """Least differences by what is looked at and whose eyes see it."""
    figures = {}
    for theme, name, colours in zip(THEMES, ("pictures and dark", "light"), pairs, strict=True):
        apart = differences(colours)
        figures[name] = _least(apart)
        figures[f"{name}, first {_FIRST}"] = _least(apart[:, :_FIRST, :_FIRST])
        for step in range(1, len(NEAR_IDS) + 1):
            places = np.arange(len(colours))
            near = apart[:, places, np.roll(places, -step)]
            figures[f"{name}, ids {step} apart"] = _rounded(near.min(axis=1))
        ground = differences(colours, [theme_colour(theme, "sunken")])
        figures[f"{name}, to the ground"] = _rounded(ground.min(axis=(1, 2)))
    return figures


def least_contrast(pairs: Pairs) -> float:
    """The least contrast of any person's colour to any ground of its look."""
    return min(
        contrast(colour, theme_colour(theme, use))
        for theme, colours in zip(THEMES, pairs, strict=True)
        for colour in colours
        for use in GROUNDS
    )


def _table(figures: dict[str, dict[str, float]]) -> str:
    lines = [f"| {'least difference':32} | {' | '.join(f'{one:>7}' for one in SIGHTS)} |"]
    lines += [f"| --- {'| --- ' * len(SIGHTS)}|"]
    for name, of in figures.items():
        lines.append(f"| {name:32} | {' | '.join(f'{one:7.1f}' for one in of.values())} |")
    return "\n".join(lines)


def write(colours: Pairs) -> None:
    """Keep a palette among the resources."""
    lines = [PLACE.read_text(encoding="utf-8").splitlines()[0]]
    for name, some in zip(("colours", "light"), colours, strict=True):
        lines += [f"{name} = [", *(f'  "{code}",' for code in _codes(some)), "]"]
    PLACE.write_text("\n".join([*lines, ""]), encoding="utf-8")


def _codes(colours: tuple[Colour, ...]) -> list[str]:
    return [f"#{red:02x}{green:02x}{blue:02x}" for red, green, blue in colours]


def _least(apart: Floats) -> dict[str, float]:
    places = np.arange(apart.shape[1])
    apart[:, places, places] = np.inf
    return _rounded(apart.min(axis=(1, 2)))


def _rounded(least: Floats) -> dict[str, float]:
    return {name: round(float(one), 2) for name, one in zip(SIGHTS, least, strict=True)}


if __name__ == "__main__":
    main()
