"""Two people seen as one for a while, and apart again."""

from __future__ import annotations

import numpy as np

from tracking.review.core.findings import FlaggedPlaces, of_pairs, ramp
from tracking.review.core.material import Material
from tracking.tracks import row_keys

_SHARED_M = 0.7
_LEAST_S, _LONG_S = 0.1, 1.0
_PAUSE_S = 0.25


def shared_regions(material: Material) -> FlaggedPlaces:
    """Where two people close to each other, one of them only predicted, are both seen again."""
    evidence, near = material.evidence, material.near
    one_hidden = evidence.predicted[near.first] != evidence.predicted[near.second]
    close = np.flatnonzero(one_hidden & (near.distance_m <= _SHARED_M))
    first, second = evidence.track[near.first[close]], evidence.track[near.second[close]]
    frame = evidence.frame[near.first[close]]
    pair = row_keys(first, second)
    pause = evidence.frames_of(_PAUSE_S)
    parts = (np.diff(pair) != 0) | (np.diff(frame) > pause)
    final = np.flatnonzero(np.append(parts, np.ones(min(len(pair), 1), bool)))
    begun = np.append(-1, final[:-1])[: len(final)] + 1
    seconds = (frame[final] - frame[begun] + 1) / evidence.fps
    strength = ramp(seconds, _LEAST_S / 2, _LONG_S)
    return of_pairs("shared", first[final], second[final], frame[final] + 1, strength, seconds)
