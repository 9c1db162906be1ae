"""Whether clothes and heights go over from one track to another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import CLOTHES, Columns

Floats = NDArray[np.float64]

_WINDOW = 40
"""Frames on either side of a cut; longer, and the next change over is among them."""
_NOISE = {**dict.fromkeys(CLOTHES, 7.0), "height_m": 0.07}
"""How much each errs from one look at a person to the next, light and pose included."""
_TOGETHER = 8.0
"""So many frames on end tell as much as one look: light and pose change slowly."""
_LARGEST = 14.0


def looks_changed(signals: Columns | None, a: int, b: int, cuts: NDArray[np.int32]) -> Floats:
    """(n,) how much more likely looks change over at a cut than stay: log-likelihoods' difference.

    What differs between the two is averaged before and after: the same person looks the same, so
    with names changed over the two differ the other way round.
    """
    score = np.zeros(len(cuts))
    if signals is None or not len(signals.get("frame", ())):
        return score
    first, stop = int(cuts[0]) - _WINDOW, int(cuts[-1]) + _WINDOW
    for name, noise in _NOISE.items():
        differ = _by_frame(signals, a, name, first, stop) - _by_frame(signals, b, name, first, stop)
        known = np.isfinite(differ)
        counts = np.concatenate([[0], np.cumsum(known)])
        sums = np.concatenate([[0.0], np.cumsum(np.where(known, differ, 0.0))])
        at = cuts - first
        before, after = (at - _WINDOW, at), (at, np.minimum(at + _WINDOW, stop - first))
        n, m = (counts[end] - counts[start] for start, end in (before, after))
        total = [sums[end] - sums[start] for start, end in (before, after)]
        means = [part / np.maximum(number, 1) for part, number in zip(total, (n, m), strict=True)]
        looks = n * m / np.maximum(n + m, 1) / _TOGETHER
        score -= looks * means[0] * means[1] / noise**2
    return _LARGEST * np.tanh(score / _LARGEST)


def _by_frame(signals: Columns, track: int, name: str, first: int, stop: int) -> Floats:
    """(stop - first,) a track's signal in each frame; NaN where it has none."""
    values = np.full(stop - first, np.nan)
    own = signals["track"] == track
    frames = signals["frame"][own]
    inside = (frames >= first) & (frames < stop)
    values[frames[inside] - first] = signals[name][own][inside]
    return values
