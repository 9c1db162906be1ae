"""The numbers that say how the parts of a person stand, and what speaks for each being there.

36 are the paper's: how the parts stand to each other, now and half a second ago. 24 are ours: the
evidence of the frame. One definition for labelling, training and tracking.
"""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.tracks import PART_EVIDENCE, PART_WORDS, PARTS

FEATURE_SPAN_S = 0.5
"""How far back the differences reach: by time, whatever the frame rate."""

STATE_NAMES = ("x", "y", "width", "height", "vx", "vy")
"""Of a part: its rectangle's centre and size in px of the left image as recorded, and px/s."""

NUMBERS = len(STATE_NAMES)

PAPER_NAMES = tuple(
    f"{part}_{name}{when}"
    for when in ("", "_change")
    for part in PART_WORDS
    for name in STATE_NAMES
)
"""In the order of the paper: the relative states of head, torso, hip-leg, then their differences
over `FEATURE_SPAN_S`."""

PAPER_FEATURES = len(PAPER_NAMES)

EVIDENCE_NAMES = tuple(f"{part}_{name}" for part in PART_WORDS for name in PART_EVIDENCE)
"""Beyond the paper, see `PART_COLUMNS`: of head, torso, hip-leg."""

FEATURE_NAMES = (*PAPER_NAMES, *EVIDENCE_NAMES)
FEATURES = len(FEATURE_NAMES)


def part_features(now: Floats, before: Floats, evidence: Floats | None = None) -> Floats:
    """The features of people, each of three parts.

    Velocities are taken by the second here and not by the frame, so that a detector serves
    recordings of any frame rate. Nothing is normalised for size: that is the detector's.

    Args:
        now: (..., 3, 6) the parts' states, see `STATE_NAMES`; head, torso, hip-leg.
        before: (..., 3, 6) the same `FEATURE_SPAN_S` earlier.
        evidence: (..., 3, 8) `PART_EVIDENCE` now; None: not known.

    Returns:
        (..., 60), see `FEATURE_NAMES`; NaN wherever what it is made of is.

    [ZhaoLee2009] eq. 3.
    """
    relative, earlier = _relative(now), _relative(before)
    features: Floats = np.concatenate((relative, relative - earlier), axis=-2)
    paper = features.reshape(*features.shape[:-2], PAPER_FEATURES)
    ours = np.full((*paper.shape[:-1], len(EVIDENCE_NAMES)), np.nan)
    if evidence is not None:
        ours[...] = evidence.reshape(ours.shape)
    return np.concatenate((paper, ours), axis=-1)


def _relative(states: Floats) -> Floats:
    """Each part's state less the mean of the three."""
    # A sum of three is quicker than numpy's mean, and this runs for every person in every frame.
    mean = (states[..., :1, :] + states[..., 1:2, :] + states[..., 2:, :]) / PARTS
    relative: Floats = states - mean
    return relative
