"""The appearance model: colours and lightness of clothes, and height.

People are compared by a log-likelihood ratio of same against different.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.trackers.stereo.population import APPEARANCE_SIZE, Population

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]

CUES = 5
"""Hue of the upper and the lower body, hue and saturation of the middle, clothes, height."""
_SAME = (0.06, 0.07, 0.06, 2.5, 0.04)
_OTHER = (0.5, 0.5, 0.5, 10.0, 0.10)
"""Mean difference between two measurements of one person, and of two people, until learnt:
`1 - rho` of histograms, CIELAB and metres."""
_WORTH = 100.0
"""Comparisons those are worth."""
_MEMORY = 4000.0
"""Comparisons that count."""
_KNOWN = 3.0
"""Matches after which appearance counts for half."""
_LEAST = 0.02
"""Share of measurements that say nothing, as of people partly covered."""


def stack_colours(people: Detections) -> Colours:
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


def measure_appearance(people: Detections) -> NDArray[np.float32]:
    """Clothes and height of each detection, as `Population.appearance`."""
    appearance = np.empty((len(people), APPEARANCE_SIZE), np.float32)
    appearance[:, :6] = people.clothes.reshape(-1, 6)
    appearance[:, 6] = np.where(people.truncated | people.merged, np.nan, people.size[:, 1])
    return appearance


def appearance_differences(
    people: Population, colours: Colours, appearance: NDArray[np.float32]
) -> Floats:
    """How much each person differs from each detection: (people, detections, `CUES`); NaN: unknown.

    Args:
        colours: as `stack_colours`. appearance: as `measure_appearance`.
    """
    found = np.empty((len(people), len(colours), CUES))
    rho = np.sqrt(people.colour).transpose(1, 0, 2) @ np.sqrt(colours).transpose(1, 2, 0)
    found[..., :3] = (1.0 - rho).transpose(1, 2, 0)
    offset = people.appearance[:, None] - appearance[None]
    found[..., 3] = np.sqrt(np.square(offset[..., :6]).mean(axis=2))
    found[..., 4] = np.abs(offset[..., 6])
    return np.maximum(found, 0.0)


def appearance_trust(people: Population) -> Floats:
    """(people,) 0 to 1, how far appearance counts: little for somebody hardly known."""
    return np.asarray(people.matches / (people.matches + _KNOWN))


@dataclass(frozen=True, slots=True)
class AppearanceModel:
    """How well each cue tells people apart in this footage, learnt while it is tracked.

    Attributes:
        same, other: (`CUES`,) sums of differences between measurements of one person, and of
            two people. same_count, other_count: (`CUES`,) of how many.
    """

    same: Floats
    other: Floats
    same_count: Floats
    other_count: Floats

    @classmethod
    def prior(cls) -> AppearanceModel:
        """What is expected before anything was seen."""
        count = np.full(CUES, _WORTH)
        return cls(np.array(_SAME) * count, np.array(_OTHER) * count, count, count)

    def update(self, same: Floats, other: Floats) -> AppearanceModel:
        """With more comparisons, (n, `CUES`) each; NaN says nothing."""
        one = _more(self.same, self.same_count, same)
        two = _more(self.other, self.other_count, other)
        return AppearanceModel(one[0], two[0], one[1], two[1])

    def log_likelihood_ratio(self, difference: Floats) -> Floats:
        """Log-likelihood ratio of one person against two, summed over the cues.

        Both differences are taken as exponentially distributed. In clothes of one colour, two
        people differ no more than measurements of one do, and colours say nothing.

        Args:
            difference: (..., `CUES`).
        """
        same = self.same / self.same_count
        other = np.maximum(self.other / self.other_count, same)
        ratio = np.log(other / same) - difference * (1.0 / same - 1.0 / other)
        told = np.log((1.0 - _LEAST) * np.exp(ratio) + _LEAST)
        return np.asarray(np.where(np.isnan(told), 0.0, told).sum(axis=-1))


def _more(total: Floats, count: Floats, values: Floats) -> tuple[Floats, Floats]:
    known = np.isfinite(values)
    total = total + np.where(known, values, 0.0).sum(axis=0)
    count = count + known.sum(axis=0)
    faded = np.minimum(1.0, _MEMORY / count)
    return total * faded, count * faded
