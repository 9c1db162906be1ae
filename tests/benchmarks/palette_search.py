"""A search for colours of people that differ as much as can be, in both looks, for all eyes.

Each person has two colours of one hue, one for the dark look and one for the light. They are
annealed, within what stands out from every ground of its look, until the two that look most alike
to anybody differ as much as can be; ids near each other, whose people often walk near each other,
count as more alike than others (`NEAR_IDS`), and so do the first eight.
"""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_difference import ciede2000
from app.core.colours.colour_sight import seen_colours
from app.core.colours.palette import NOBODY
from app.core.colours.shown_colours import (
    GROUNDS,
    LEAST_CONTRAST,
    THEMES,
    readable_colour,
    theme_colour,
)
from app.core.scenes import Colour
from app.core.scenes.ground_truth import ERROR_COLOURS
from tests.benchmarks.command import tell
from tracking.scoring import ErrorKind

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Pairs = tuple[tuple[Colour, ...], ...]
"""Colours of people in each of `THEMES`."""

NEAR_IDS: Final = (2.8, 2.0, 1.6, 1.4, 1.2, 1.1, 1.1)
"""So many times as much as any two are ids to differ that are one apart, two apart and so on."""
_FIRST_IDS, _OF_FIRST_IDS = 8, 1.5
"""Few recordings have more people than so many: these are to differ so many times as much."""
_HUES_OF_NEAR_IDS, _SAME_HUE = 5, 0.3
"""Ids so near are not to go by one colour's name: how much a distance in hue alone counts."""
_TRIED = 16
"""Pairs tried at once in place of one."""
_RANDOM = 400_000
_FAR = 99.0
_USUAL_SHARE = 1.3
"""Usual eyes are to see so many times the least difference of all: most people have them."""
_LEAST_CHROMA = 18.0
"""No colour is as good as grey, which is nobody's."""
_LEAST_LIGHTNESS = 32.0
"""No colour is as good as black, whatever its hue."""
_ONE_HUE_DEG, _ONE_CHROMA = 15.0, 0.55
"""A person's two colours go by one name: so far apart at most are their hues, and the greyer one
has this share of the other's chroma at least."""
_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_OPPONENTS = np.array(
    [[1.9779984951, -2.4285922050, 0.4505937099], [0.0259040371, 0.7827717662, -0.8086757660]]
)
_SWAPS = 0.3
"""Share of the steps in which two people's colours change places."""


def search(many: int, steps: int, seed: int) -> Pairs:
    """Colours of so many people in each of `THEMES`, in the order of ids; always the same."""
    rng = np.random.default_rng(seed)
    pool = _pool(rng)
    now = _Palette(pool[:many].copy())
    best, kept = now.least(), now.colours.copy()
    for left in np.linspace(1.0, 0.0, steps).tolist():
        heat = 2.0 * left**2 + 0.05
        change = _swap if rng.random() < _SWAPS else _replace
        now = change(now, pool, left, heat, rng)
        if now.least() > best:
            best, kept = now.least(), now.colours.copy()
    tell(f"least difference, that of near ids and usual eyes over their shares: {best:.2f}")
    return _plain(kept[:, 0]), _plain(kept[:, 1])


def _fixed(theme: str) -> list[Colour]:
    """What no person's colour may look like: grounds, letters, nobody, and errors' colours."""
    errors = [ERROR_COLOURS[kind] for kind in (ErrorKind.MISS, ErrorKind.FALSE_ALARM)]
    marks = [readable_colour(theme, one) for one in (NOBODY, *errors)]
    return [theme_colour(theme, "sunken"), theme_colour(theme, "text"), *marks]


class _Palette:
    """Colours (many, 2, 3) of people, and how far they are apart."""

    def __init__(self, colours: Floats) -> None:
        self.colours = colours
        self.seen = [seen_colours(colours[:, look]) for look in range(2)]
        self.apart = self.rows(self.seen, np.arange(len(colours)))

    def rows(self, looks: list[Floats], at: NDArray[np.intp]) -> Floats:
        """(n, 2, many + fixed) how far colours in these places would be from all others."""
        many = len(self.colours)
        rows = [
            _apart(look, seen, fixed)
            for look, seen, fixed in zip(looks, self.seen, _FIXED, strict=True)
        ]
        near, hue = _near(many)
        for look, seen, row in zip(looks, self.seen, rows, strict=True):
            plane = np.linalg.norm(look[0, :, None, 1:] - seen[0, None, :, 1:], axis=2)
            row[:, :many] = np.minimum(row[:, :many] / near[at], _SAME_HUE * plane * hue[at])
            row[np.arange(len(at)), at] = _FAR
        return np.stack(rows, axis=1)

    def least(self) -> float:
        """The least of all differences, those of near ids over their shares."""
        return float(self.apart.min())


_FIXED = [seen_colours(one) for one in map(_fixed, THEMES)]


@cache
def _near(many: int) -> tuple[Floats, Floats]:
    """(many, many) what differences are divided by, and what distances in hue are multiplied by."""
    steps = np.abs(np.subtract.outer(np.arange(many), np.arange(many)))
    steps = np.minimum(steps, many - steps)
    near, hue = np.ones((many, many)), np.full((many, many), _FAR)
    for step, share in enumerate(NEAR_IDS, 1):
        near[steps == step] = share
    first = near[:_FIRST_IDS, :_FIRST_IDS]
    first[:] = np.maximum(first, _OF_FIRST_IDS)
    hue[(steps > 0) & (steps <= _HUES_OF_NEAR_IDS)] = 1.0
    return near, hue


def _replace(
    now: _Palette, pool: Floats, left: float, heat: float, rng: np.random.Generator
) -> _Palette:
    """Somebody has other colours, if that is better or, while it is hot, little worse."""
    many = len(now.colours)
    at = _chosen(now.apart.min(axis=1), many, rng)
    tried = _tries(now.colours[at], pool, left, rng)
    looks = [seen_colours(tried[:, look]) for look in range(2)]
    rows = now.rows(looks, np.full(len(tried), at))
    worth = _soft_least(rows, max(heat, 0.2))
    most = int(worth.argmax())
    gain = worth[most] - _soft_least(now.apart[at][None], max(heat, 0.2))[0]
    if gain > 0 or rng.random() < np.exp(gain / (0.3 * heat)):
        now.colours[at], now.apart[at] = tried[most], rows[most]
        now.apart[:, :, at] = rows[most, :, :many].T
        now.apart[at, :, at] = _FAR
        for look in range(2):
            now.seen[look][:, at] = looks[look][:, most]
    return now


def _swap(now: _Palette, _: Floats, __: float, heat: float, rng: np.random.Generator) -> _Palette:
    """Two people change places, if that is better or, while it is hot, little worse."""
    many = len(now.colours)
    one = _chosen(now.apart.min(axis=1), many, rng)
    two = int(rng.integers(many))
    colours = now.colours.copy()
    colours[[one, two]] = colours[[two, one]]
    other, places = _Palette(colours), [one, two]
    gain = float(
        np.subtract(*(_soft_least(of.apart[places], max(heat, 0.2)).sum() for of in (other, now)))
    )
    return other if gain > 0 or rng.random() < np.exp(gain / (0.3 * heat)) else now


def _pool(rng: np.random.Generator) -> Floats:
    """(n, 2, 3) any colours of one hue that stand out, dark look and light."""
    free = rng.integers(0, 256, (_RANDOM, 2, 3)).astype(float)
    return np.asarray(free[_stand_out(free)])


def _stand_out(pairs: Floats) -> Bools:
    """Which pairs (n, 2, 3) are of one hue, and stand out from all grounds."""
    good = np.ones(len(pairs), bool)
    for look, theme in enumerate(THEMES):
        own = _luminance(pairs[:, look])
        for use in GROUNDS:
            ground = _luminance(np.array([theme_colour(theme, use)], float))[0]
            ratio = (np.maximum(own, ground) + 0.05) / (np.minimum(own, ground) + 0.05)
            good &= ratio >= LEAST_CONTRAST
    where = np.flatnonzero(good)
    good[where] = _of_one_hue(pairs[where])
    return good


def _of_one_hue(pairs: Floats) -> Bools:
    """Hues by Oklab, in which, other than in CIELAB, blue stays blue from dark to bright."""
    plane = np.stack([_oklab_plane(pairs[:, look]) for look in range(2)], axis=1)
    hue = np.degrees(np.arctan2(plane[..., 1], plane[..., 0]))
    turn = np.abs((hue[:, 0] - hue[:, 1] + 180.0) % 360.0 - 180.0)
    labs = np.stack([seen_colours(pairs[:, look])[0] for look in range(2)])
    chroma = np.hypot(labs[..., 1], labs[..., 2])
    named = np.min(chroma, axis=0) >= np.maximum(
        _LEAST_CHROMA, _ONE_CHROMA * np.max(chroma, axis=0)
    )
    return np.asarray(
        (turn <= _ONE_HUE_DEG) & named & (labs[..., 0] >= _LEAST_LIGHTNESS).all(axis=0)
    )


def _oklab_plane(colours: Floats) -> Floats:
    """(n, 2) green to red and blue to yellow [Ottosson 2020, "A perceptual color space"]."""
    cones = np.cbrt(_linear(colours) @ _CONES.T)
    return np.asarray(cones @ _OPPONENTS.T)


def _luminance(colours: Floats) -> Floats:
    return np.asarray(_linear(colours) @ np.array([0.2126, 0.7152, 0.0722]))


def _linear(colours: Floats) -> Floats:
    values = colours / 255.0
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def _apart(looks: Floats, seen: Floats, fixed: Floats) -> Floats:
    """(n, many + fixed) difference of looks to those seen and fixed, for the worst eyes."""
    others = np.concatenate((seen, fixed), axis=1)
    apart = ciede2000(looks[:, :, None], others[:, None])
    apart[0] /= _USUAL_SHARE
    rows = apart.min(axis=0)
    return np.asarray(rows)


def _chosen(apart: Floats, many: int, rng: np.random.Generator) -> int:
    """Somebody to change: often one of the two who look most alike."""
    row, column = np.unravel_index(int(apart.argmin()), apart.shape)
    if rng.random() < 0.5:
        return int(column if column < many and rng.random() < 0.5 else row)
    return int(rng.integers(many))


def _tries(pair: Floats, pool: Floats, left: float, rng: np.random.Generator) -> Floats:
    """Pairs near to one, the nearer the later, or now and then any."""
    if rng.random() < 0.2:
        return np.asarray(pool[rng.integers(0, len(pool), _TRIED)])
    step = rng.normal(0, 60 * left + 3, (2 * _TRIED, 2, 3))
    step[::3, 0] = step[1::3, 1] = 0.0  # one of the two stays
    moved = np.clip(pair + step, 0, 255).round()
    good = moved[_stand_out(moved)][:_TRIED]
    return good if len(good) else pool[:1]


def _soft_least(rows: Floats, softness: float) -> Floats:
    return np.asarray(-np.log(np.exp(-rows / softness).sum(axis=(1, 2))) * softness)


def _plain(colours: Floats) -> tuple[Colour, ...]:
    return tuple((int(red), int(green), int(blue)) for red, green, blue in colours)
