"""The 36 numbers that say how the parts of a person stand to each other, now and half a second ago.

One definition for labelling, training and tracking.
"""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.tracks import PART_WORDS, PARTS

FEATURE_SPAN_S = 0.5
"""How far back the differences reach: by time, whatever the frame rate."""

STATE_NAMES = ("x", "y", "width", "height", "vx", "vy")
"""Of a part: its rectangle's centre and size in px of the left image as recorded, and px/s."""

NUMBERS = len(STATE_NAMES)

FEATURE_NAMES = tuple(
    f"{part}_{name}{when}"
    for when in ("", "_change")
    for part in PART_WORDS
    for name in STATE_NAMES
)
"""In the order of the paper: the relative states of head, torso, hip-leg, then their differences
over `FEATURE_SPAN_S`."""

FEATURES = len(FEATURE_NAMES)


def part_features(now: Floats, before: Floats) -> Floats:
    """The features of people, each of three parts.

    Velocities are taken by the second here and not by the frame, so that a detector serves
    recordings of any frame rate. Nothing is normalised for size: that is the detector's.

    Args:
        now: (..., 3, 6) the parts' states, see `STATE_NAMES`; head, torso, hip-leg.
        before: (..., 3, 6) the same `FEATURE_SPAN_S` earlier.

    Returns:
        (..., 36), see `FEATURE_NAMES`; NaN wherever a state it is made of is.

    [ZhaoLee2009] eq. 3.
    """
    relative, earlier = _relative(now), _relative(before)
    features: Floats = np.concatenate((relative, relative - earlier), axis=-2)
    return features.reshape(*features.shape[:-2], FEATURES)


def _relative(states: Floats) -> Floats:
    """Each part's state less the mean of the three."""
    # A sum of three is quicker than numpy's mean, and this runs for every person in every frame.
    mean = (states[..., :1, :] + states[..., 1:2, :] + states[..., 2:, :]) / PARTS
    relative: Floats = states - mean
    return relative
