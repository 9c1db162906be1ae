"""How much rectangles of the picture look like the parts they are thought to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Clouds
from tracking.people.parts import (
    bhattacharyya,
    equalisation,
    equalised,
    level_histograms,
    similarities,
)
from tracking.trackers.three_part.people import Flags, Floats

Levels = NDArray[np.float32]


def log_likelihoods(
    picture: NDArray[np.uint8], clouds: Clouds, model: Levels, filtered: Flags, sigma: float
) -> NDArray[np.float32]:
    """(particles, rectangles) log of the likelihood of each rectangle; 0 where nothing is seen.

    The weighing of the colour-based particle filter that [ZhaoLee2009] section 3 builds on: a
    Gaussian of the Bhattacharyya distance `sqrt(1 - rho)`, here between equalised histograms.

    Args:
        picture: (height, width, 3) of `ycbcr`.
        model: (people, parts, 3, 256). filtered: (people, parts), False: occluded, left at 0.
        sigma: of the distance.
    """
    rectangles = clouds.state[..., :4]
    beside = rectangles.shape[1]
    row = clouds.owner[:, None] * beside + np.arange(beside)
    wanted = filtered.ravel()[row]
    log = np.zeros(row.shape, np.float32)
    alike = similarities(picture, rectangles[wanted], row[wanted], model.reshape(-1, 3, 256))
    log[wanted] = (alike - 1.0) / np.float32(2.0 * sigma**2)
    return log


def measure_levels(picture: NDArray[np.uint8], rectangles: Floats) -> Levels:
    """(people, parts, 3, 256) histograms Q of rectangles (people, parts, 4)."""
    people, parts = rectangles.shape[:2]
    found = level_histograms(picture, rectangles.reshape(-1, 4))
    return found.reshape(people, parts, 3, 256)


def resemblance(seen: Levels, model: Levels) -> Floats:
    """(...) rho of the equalised histograms seen (..., 3, 256) and of their models."""
    flat_seen, flat_model = seen.reshape(-1, 3, 256), model.reshape(-1, 3, 256)
    mapping = equalisation(flat_model)
    rho = bhattacharyya(equalised(flat_seen, mapping), equalised(flat_model, mapping))
    return rho.reshape(seen.shape[:-2]).astype(np.float64)
