"""The frame products that trackers step on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.detections import Detections


@dataclass(frozen=True, slots=True)
class Overlays:
    """Pictures a view may lay over the left eye, in pixels of the rectified left image.

    Attributes:
        foreground: (height, width) uint8: 0 background, 127 shadow, 255 foreground.
        disparity: (height, width) float32 px, NaN where unknown; None without stereo.
    """

    foreground: NDArray[np.uint8]
    disparity: NDArray[np.float32] | None


@dataclass(frozen=True, slots=True)
class Observation:
    """The frame products a tracker steps on: everything seen, nothing remembered.

    Attributes:
        frame: frame number in the recording.
        time_s: seconds since the recording's first frame.
        people: who is seen.
        overlays: for the views.
        picture: (height, width, 3) BGR, what single-camera perception looked at: the left (or only)
            eye as recorded, in whose pixels everything else is; None where perception does not
            hand it on.
    """

    frame: int
    time_s: float
    people: Detections
    overlays: Overlays
    picture: NDArray[np.uint8] | None = None
