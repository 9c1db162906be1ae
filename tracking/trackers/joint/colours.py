"""The colours of both papers together."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections

Colours = NDArray[np.float32]


def colours_of(people: Detections) -> Colours:
    """Hue of the upper and the lower body, and hue with saturation of the middle.

    [Kawashita2012] looks at the first two, [Kawashita2014] at the third.

    Returns:
        (detections, 3, bins), each histogram summing to 1; the shorter ones end in zeros.
    """
    own = (people.upper, people.lower, people.middle)
    bins = max(histogram.shape[1] for histogram in own)
    together = np.zeros((len(people), len(own), bins), np.float32)
    for cue, histogram in enumerate(own):
        together[:, cue, : histogram.shape[1]] = histogram
    return together
