"""Track colours: distinct for the colour-blind, the same for an id wherever it is drawn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.presenters.scenes import Colour

# Chosen among Okabe and Ito's and Tol's sets and a few more, so that the nearest two lie as far
# apart as can be, in CIELAB, for normal, red-blind and green-blind eyes alike; then ordered so that
# ids close to each other, who often walk close to each other, differ most.
_FIRST: tuple[Colour, ...] = (
    (255, 170, 187),
    (110, 70, 180),
    (187, 204, 51),
    (238, 136, 102),
    (153, 221, 255),
    (238, 51, 119),
    (200, 140, 255),
    (213, 94, 0),
    (0, 153, 136),
    (238, 221, 136),
    (68, 119, 170),
    (17, 119, 51),
)
_LIGHT = 150.0
"""Mean of red, green and blue from which on a colour counts as a light one."""


def _varied(colour: Colour) -> Colour:
    """The same hue for the second time around: light colours darker, dark ones lighter."""
    if sum(colour) / 3 > _LIGHT:
        red, green, blue = (round(0.62 * part) for part in colour)
    else:
        red, green, blue = (round(0.5 * (part + 255)) for part in colour)
    return red, green, blue


TRACK_COLOURS: tuple[Colour, ...] = (*_FIRST, *(_varied(colour) for colour in _FIRST))
NOBODY: Colour = (150, 150, 150)

_TABLE = np.array(TRACK_COLOURS, np.uint8)


def colour_of_track(track: int) -> Colour:
    """The colour of a track id; grey for 0, which is nobody."""
    if track <= 0:
        return NOBODY
    return TRACK_COLOURS[(track - 1) % len(TRACK_COLOURS)]


def colours_of_tracks(tracks: NDArray[np.int32]) -> NDArray[np.uint8]:
    """The colours of (n,) ids as (n, 3) red, green, blue."""
    colours = _TABLE[(tracks - 1) % len(TRACK_COLOURS)]
    colours[tracks <= 0] = NOBODY
    return colours
