"""How different people's colours look: least CIEDE2000 of every two, and of each to the grounds.

Usual eyes and three kinds of colour blindness [Machado2009, severity 1.0], on pictures and in both
looks. `--search SECONDS` looks for a better palette first and `--write` keeps it in
`resources/themes/people.toml`: the 24 colours are annealed until the two that look most alike to
anybody differ as much as can be, within what stands out from the ground of either look; then they
are ordered so that ids close to each other differ most, and that each place has a colour like the
one it had before, which sessions refer to.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from importlib.resources import files
from itertools import count
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_difference import ciede2000
from app.core.colours.colour_sight import SIGHTS, differences, of_one_hue, seen_colours
from app.core.colours.palette import NOBODY, TRACK_COLOURS
from app.core.colours.shown_colours import LEAST_CONTRAST, THEMES, readable_colour, theme_colour
from app.core.scenes import Colour
from app.core.scenes.ground_truth import ERROR_COLOURS
from tests.benchmarks.command import one_core, parser_of, tell
from tracking.scoring import ErrorKind

Floats = NDArray[np.float64]

PLACE = Path(str(files("resources") / "themes" / "people.toml"))
_FIRST = 8
_TRIED = 24
"""Colours tried at once in place of one."""
_RANDOM = 200_000
_FAR = 99.0
_USUAL_SHARE = 1.3
"""Usual eyes are to see so many times the least difference of all: most people have them."""
_LEAST_CHROMA = 16.0
"""No colour is as good as grey, which is nobody's."""
_NEAR_IDS = 6
_ORDER_STEPS = 60_000


def main() -> None:
    """Print the figures of the palette in use, or search for another one first."""
    parser = parser_of("palette", __doc__)
    parser.add_argument("--search", type=float, default=0.0, metavar="SECONDS")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", action="store_true", help="keep what was found")
    parser.add_argument("--json", action="store_true", help="one JSON document instead of a table")
    asked = parser.parse_args()
    one_core()
    colours: tuple[Colour, ...] = TRACK_COLOURS
    if asked.search:
        rng = np.random.default_rng(asked.seed)
        colours = _ordered(_searched(len(colours), asked.search, rng), rng)
        tell("\n".join(_codes(colours)))
        if asked.write:
            write(colours)
    figures = measure(colours)
    print(json.dumps(figures, indent=1) if asked.json else _table(figures))


def measure(colours: tuple[Colour, ...]) -> dict[str, dict[str, float]]:
    """Least differences by what is looked at and whose eyes see it."""
    figures = {}
    shown = {"on pictures": colours}
    shown |= {one: tuple(readable_colour(one, colour) for colour in colours) for one in THEMES}
    for name, some in shown.items():
        figures[name] = _least(differences(some))
        figures[f"{name}, first {_FIRST}"] = _least(differences(some[:_FIRST]))
        if name in THEMES:
            ground = differences(some, [theme_colour(name, "sunken")])
            figures[f"{name}, to the ground"] = _rounded(ground.min(axis=(1, 2)))
    return figures


def _table(figures: dict[str, dict[str, float]]) -> str:
    lines = [f"| {'least difference':26} | {' | '.join(f'{one:>7}' for one in SIGHTS)} |"]
    lines += [f"| --- {'| --- ' * len(SIGHTS)}|"]
    for name, of in figures.items():
        lines.append(f"| {name:26} | {' | '.join(f'{one:7.1f}' for one in of.values())} |")
    return "\n".join(lines)


def write(colours: tuple[Colour, ...]) -> None:
    """Keep a palette among the resources."""
    lines = [f'  "{code}",' for code in _codes(colours)]
    head = "# Colours of people in the order of ids; a session keeps their places."
    PLACE.write_text("\n".join([head, "colours = [", *lines, "]", ""]), encoding="utf-8")


def _codes(colours: tuple[Colour, ...]) -> list[str]:
    return [f"#{red:02x}{green:02x}{blue:02x}" for red, green, blue in colours]


def _least(apart: Floats) -> dict[str, float]:
    places = np.arange(apart.shape[1])
    apart[:, places, places] = np.inf
    return _rounded(apart.min(axis=(1, 2)))


def _rounded(least: Floats) -> dict[str, float]:
    return {name: round(float(one), 2) for name, one in zip(SIGHTS, least, strict=True)}


def _searched(many: int, seconds: float, rng: np.random.Generator) -> Floats:
    """(many, 3) colours whose least difference to each other and to what is fixed is large."""
    free = rng.integers(0, 256, (_RANDOM, 3)).astype(float)
    free = free[_stands_out(free)]
    colours = free[:many].copy()
    seen, fixed = seen_colours(colours), seen_colours(_fixed())
    apart = _apart(seen, seen, fixed)
    best, kept = 0.0, colours.copy()
    for left in _cooling(seconds):
        at = _chosen(apart, many, rng)
        tried = _tries(colours[at], free, left, rng)
        looks = seen_colours(tried)
        rows = _apart(looks, seen, fixed)
        rows[:, at] = _FAR
        heat = 2.0 * left**2 + 0.05
        worth = _soft_least(rows, max(heat, 0.2))
        most = int(worth.argmax())
        gain = worth[most] - _soft_least(apart[at][None], max(heat, 0.2))[0]
        if gain > 0 or rng.random() < np.exp(gain / (0.3 * heat)):
            colours[at], seen[:, at] = tried[most], looks[:, most]
            apart[at] = rows[most]
            apart[:, at] = rows[most, :many]
            if apart.min() > best:
                best, kept = float(apart.min()), colours.copy()
    tell(f"least difference, that of usual eyes over {_USUAL_SHARE:g}: {best:.2f}")
    return kept


def _cooling(seconds: float) -> Iterator[float]:
    """The share of the time that is left, as often as there is time."""
    begun = time.monotonic()
    for _ in count():
        left = 1.0 - (time.monotonic() - begun) / seconds
        if left <= 0:
            return
        yield left


def _fixed() -> list[Colour]:
    """What no person's colour may look like: grounds, nobody, and errors' colours."""
    errors = [ERROR_COLOURS[kind] for kind in (ErrorKind.MISS, ErrorKind.FALSE_ALARM)]
    return [*(theme_colour(one, "sunken") for one in THEMES), NOBODY, *errors]


def _stands_out(colours: Floats) -> NDArray[np.bool_]:
    """Which colours have a hue, and need no other shade in either look."""
    light = [_luminance(np.array([theme_colour(one, "sunken")], float))[0] for one in THEMES]
    own = _luminance(colours)
    good = np.hypot(*seen_colours(colours)[0, :, 1:].T) >= _LEAST_CHROMA
    for name, ground in zip(THEMES, light, strict=True):
        ratio = (np.maximum(own, ground) + 0.05) / (np.minimum(own, ground) + 0.05)
        good &= ratio >= LEAST_CONTRAST[name]
    return good


def _luminance(colours: Floats) -> Floats:
    values = colours / 255.0
    linear = np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    return np.asarray(linear @ np.array([0.2126, 0.7152, 0.0722]))


def _apart(looks: Floats, seen: Floats, fixed: Floats) -> Floats:
    """(n, many + fixed) difference of looks to those seen and fixed, for the worst eyes."""
    others = np.concatenate((seen, fixed), axis=1)
    apart = ciede2000(looks[:, :, None], others[:, None])
    apart[0] /= _USUAL_SHARE
    rows = apart.min(axis=0)
    if looks is seen:
        np.fill_diagonal(rows, _FAR)
    return np.asarray(rows)


def _chosen(apart: Floats, many: int, rng: np.random.Generator) -> int:
    """A colour to change: often one of the two that look most alike."""
    row, column = np.unravel_index(int(apart.argmin()), apart.shape)
    if rng.random() < 0.5:
        return int(column if column < many and rng.random() < 0.5 else row)
    return int(rng.integers(many))


def _tries(colour: Floats, free: Floats, left: float, rng: np.random.Generator) -> Floats:
    """Colours near to one, the nearer the later, or now and then any."""
    if rng.random() < 0.2:
        return free[rng.integers(0, len(free), _TRIED)]
    moved = np.clip(colour + rng.normal(0, 60 * left + 3, (_TRIED, 3)), 0, 255).round()
    good = moved[_stands_out(moved)]
    return good if len(good) else free[:1]


def _soft_least(rows: Floats, softness: float) -> Floats:
    return np.asarray(-np.log(np.exp(-rows / softness).sum(axis=1)) * softness)


def _ordered(colours: Floats, rng: np.random.Generator) -> tuple[Colour, ...]:
    """The colours in an order in which those close to each other differ most."""
    plain = [(int(red), int(green), int(blue)) for red, green, blue in colours]
    apart = differences(plain).min(axis=0)
    hue = of_one_hue(plain)
    moved = differences(plain, TRACK_COLOURS)[0]
    order = np.arange(len(plain))
    cost = best = _disorder(order, apart, hue, moved)
    kept = order.copy()
    for step in range(_ORDER_STEPS):
        other = order.copy()
        one, two = rng.integers(0, len(order), 2)
        other[[one, two]] = other[[two, one]]
        changed = _disorder(other, apart, hue, moved)
        heat = 0.5 * (1 - step / _ORDER_STEPS) ** 2 + 1e-3
        if changed < cost or rng.random() < np.exp((cost - changed) / heat):
            order, cost = other, changed
            if cost < best:
                best, kept = cost, order.copy()
    return tuple(plain[one] for one in kept.tolist())


def _disorder(order: NDArray[np.intp], apart: Floats, hue: Floats, moved: Floats) -> float:
    """How much ids close to each other look alike, and how far places are from what they were."""
    close = 0.0
    for further in range(1, _NEAR_IDS + 1):
        next_ones = np.roll(order, -further)
        alike = np.exp(-np.square(apart[order, next_ones] / 12.0)) + hue[order, next_ones] ** 2
        close += float(alike.sum()) / further**0.5
    return 4.0 * close + float(moved[order, np.arange(len(order))].mean()) / 10.0


if __name__ == "__main__":
    main()
