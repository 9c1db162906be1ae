"""The measurement noise in this footage, learnt while it is tracked.

It is estimated from the innovations of sure matches.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.stereo.cues import likelihood_sigma

Floats = NDArray[np.float64]

_WORTH = 200.0
"""Matches that the settings are worth."""
_MEMORY = 4000.0
"""Matches that count."""
_MOST = 9.0
"""Squared errors beyond this multiple of what was expected are accidents, and count as much."""
_LEAST_SHARE, _MOST_SHARE = 0.3, 4.0
"""Of the squared error that the settings say: what is learnt stays within."""


@dataclass(frozen=True, slots=True)
class MeasurementNoise:
    """The error of detections' places, as a share of what the settings say.

    Attributes:
        off: sum of squared errors. expected: sum of what the settings expect of them; both m².
        count: of how many matches.
    """

    off: float
    expected: float
    count: float

    @classmethod
    def prior(cls, settings: JointSettings) -> MeasurementNoise:
        """What the settings say."""
        expected = _WORTH * settings.measurement_noise_m**2
        return cls(expected, expected, _WORTH)

    def sigma(self, measured: Floats, settings: JointSettings) -> Floats:
        """(n,) m, the error along each axis of places (n, 2); it grows with the range."""
        share = np.clip(self.off / self.expected, _LEAST_SHARE, _MOST_SHARE)
        return np.asarray(np.sqrt(share) * likelihood_sigma(measured, settings))

    def update(
        self, offset: Floats, place: Floats, measured: Floats, settings: JointSettings
    ) -> MeasurementNoise:
        """With more matches: how far (people, 2) m from where they were expected people were seen.

        What the prediction itself may err is not the detection's error.

        Args:
            place: (people,) m², the variance of where they were expected. measured: (people, 2) m.
        """
        square = 0.5 * np.square(offset).sum(axis=1)
        usual = np.square(likelihood_sigma(measured, settings))
        now = usual * np.clip(self.off / self.expected, _LEAST_SHARE, _MOST_SHARE)
        own = np.minimum(square, _MOST * (place + now)) - place
        off, expected = self.off + float(own.sum()), self.expected + float(usual.sum())
        count = self.count + len(own)
        faded = min(1.0, _MEMORY / count)
        return MeasurementNoise(max(off, 0.0) * faded, expected * faded, count * faded)
