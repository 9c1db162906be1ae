"""The colours people are known by: looked up at a few places of the body, for every hypothesis."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import FlatView
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople

Picture = NDArray[np.uint8]
Colours = NDArray[np.float32]

_UP = (0.92, 0.8, 0.7, 0.6, 0.48, 0.36, 0.24, 0.12)
"""Places on a body's axis, from head to foot, in body heights."""
_FULL = 70.0
"""Grey levels from which colours are as different as can be."""
_MEMORY = 60.0
"""Looks that a colour is the mean of; later ones count for more."""
_FEWEST = 3.0
"""Looks from which on a colour tells something."""
_BRIGHTNESS = 0.5
"""Weight of brightness against colour: light changes from place to place."""


class ColourLook:
    """A frame's colours, looked up in flat pixels without undistorting the picture.

    Args:
        flat: the camera. picture: (height, width, 3) BGR, shrunk but not undistorted.
    """

    def __init__(self, flat: FlatView, picture: Picture) -> None:
        self._flat = flat
        self._pixels = picture.reshape(-1, 3)
        self._shape = picture.shape

    def at(self, xy: Floats, height_m: Floats) -> tuple[Colours, NDArray[np.bool_]]:
        """Colours (..., cells, 3) on bodies of any batch shape, and which are in the picture.

        Colours are opponent ones: brightness, blue less yellow, red less green.

        Args:
            xy: (..., 2) m on the floor. height_m: (...) of the bodies.
        """
        u, v = self._places(xy, height_m)
        place, known = self._flat.recorded_index(u, v, self._shape[1::-1])
        colour = self._pixels[place].astype(np.float32)
        blue, green, red = colour[..., 0], colour[..., 1], colour[..., 2]
        light = (blue + green + red) / 3
        opponent = (light * _BRIGHTNESS, blue - (red + green) / 2, red - green)
        return np.stack(opponent, axis=-1), known

    def _places(self, xy: Floats, height_m: Floats) -> tuple[Floats, Floats]:
        """Flat pixels (..., cells) on the axes of bodies, from head to foot."""
        z = height_m[..., None] * np.array(_UP)
        matrix = self._flat.projection
        seen = [
            (xy[..., 0] * row[0] + xy[..., 1] * row[1] + row[3])[..., None] + z * row[2]
            for row in matrix
        ]
        depth = np.where(seen[2] > 1e-6, seen[2], np.nan)
        return seen[0] / depth, seen[1] / depth


def bgr_of(opponent: Colours) -> Colours:
    """(..., 3) blue, green, red, 0 to 255, of opponent colours."""
    light = opponent[..., 0] / _BRIGHTNESS
    blue = light + opponent[..., 1] * 2 / 3
    both = 3 * light - blue
    return np.stack((blue, (both - opponent[..., 2]) / 2, (both + opponent[..., 2]) / 2), axis=-1)


def appearance_log_weights(
    people: SpheroidPeople, colours: Colours, known: NDArray[np.bool_], weight: float
) -> Floats:
    """(people, N) logarithms of weights by colour, of hypotheses.

    Args:
        colours: (people, N, cells, 3) seen there. known: (people, N, cells) in the picture.
        weight: of colours.
    """
    apart = np.abs(colours - people.appearance[:, None]).sum(axis=-1)
    apart = np.minimum(apart / np.float32(_FULL), 1.0)
    comparable = (people.counts > _FEWEST)[:, None] & known
    apart *= comparable
    cells = np.maximum(comparable.sum(axis=-1), 1)
    return np.asarray(-weight * apart.sum(axis=-1) / cells, np.float64)


def learn_colours(
    people: SpheroidPeople, colours: Colours, known: NDArray[np.bool_], alone: NDArray[np.bool_]
) -> SpheroidPeople:
    """The people with the colours of those who are seen alone.

    Args:
        colours, known: at the estimates, (people, cells, 3) and (people, cells).
        alone: (people,) who is seen whole with nobody near.
    """
    learn = (known & alone[:, None]).astype(np.float32)
    share = learn / np.minimum(people.counts + 1.0, _MEMORY)
    appearance = people.appearance + share[..., None] * (colours - people.appearance)
    return people.replace(appearance=appearance, counts=people.counts + learn)


def difference(
    appearance: Colours, counts: Colours, other: Colours, other_counts: Colours
) -> NDArray[np.float32]:
    """(...) 0 to 1, how far the colours of people are apart; 0.5 where nothing is known.

    Args:
        appearance, other: (..., cells, 3). counts, other_counts: (..., cells).
    """
    apart = np.minimum(np.abs(appearance - other).sum(axis=-1) / np.float32(_FULL), 1.0)
    comparable = (counts > 0) & (other_counts > 0)
    cells = comparable.sum(axis=-1)
    mean = (apart * comparable).sum(axis=-1) / np.maximum(cells, 1)
    return np.asarray(np.where(cells > 0, mean, 0.5), np.float32)
