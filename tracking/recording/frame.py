"""One instant of a recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]
"""(height, width, 3) in BGR order, as OpenCV has it; grey footage has three equal channels."""


@dataclass(frozen=True, slots=True)
class StereoFrame:
    """Both cameras at one instant, the left one's, as recorded (not rectified).

    Attributes:
        number: frame number in the recording, from 0.
        time_s: seconds since the recording's first frame.
        left: the left (or only) camera's picture.
        right: the right camera's picture; None in a monocular recording.
        right_lag: by so many frames the right picture was recorded later than the left one, so
            that both show one instant; 0 where no camera is late. None: the right camera recorded
            nothing of this instant, and `right` shows another.
        depth: (height, width) m along the left camera's optical axis, 0 where it is unknown; None
            in a recording without depth.
    """

    number: int
    time_s: float
    left: Image
    right: Image | None
    right_lag: int | None = 0
    depth: NDArray[np.float32] | None = None
