"""Track colours: distinct for the colour-blind, the same for an id wherever it is drawn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.presenters.scenes import Colour

# Chosen among Okabe and Ito's and Tol's sets: each next one is the farthest, in CIELAB, from those
# before it for normal, red-blind and green-blind eyes alike, and stands out on white, on footage
# and on near-black.
TRACK_COLOURS: tuple[Colour, ...] = (
    (68, 119, 170),
    (187, 204, 51),
    (17, 119, 51),
    (255, 170, 187),
    (153, 153, 51),
    (238, 102, 119),
    (51, 187, 238),
    (221, 204, 119),
    (119, 120, 220),
    (170, 51, 119),
    (204, 121, 167),
    (0, 158, 115),
)
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
