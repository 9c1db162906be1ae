"""Where people may leave the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.stereo.boxes import Bodies, share_in_view

Floats = NDArray[np.float64]

_STEP_M = 0.75
_AWAY_M = _STEP_M * np.array([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
_BODY_M = np.array([-0.25, -0.85, 0.25, 0.85])
"""Left, top, right and bottom of a body from its middle."""


def here_and_a_step_off(position: Floats, view: View) -> tuple[Bodies, Bodies]:
    """The bodies of people (people, 2) m, and those a step off: all of one person's in a row."""
    around = (position[:, None] + _AWAY_M).reshape(-1, 2)
    everywhere = Bodies.at(np.concatenate((position, around)), view)
    count = len(position)
    return everywhere.select(slice(count)), everywhere.select(slice(count, None))


def share_a_step_off(around: Bodies, size: tuple[int, int]) -> Floats:
    """The least share, 0 to 1, of a body in the picture a step from where people are: (people,).

    Who stands at the picture's edge is a step on the floor from being out of it. That a body is
    cut off does not tell: far from a camera that looks down on them heads are cut off for metres,
    and who is there does not leave all of a sudden. A body a step off that would be behind the
    camera is nowhere in the picture, and its share is 0: whoever stands so near is at the edge.

    Args:
        around: as `here_and_a_step_off`. size: width and height of the picture.
    """
    share = share_in_view(around.boxes(_BODY_M), size)
    return np.asarray(share.reshape(-1, len(_AWAY_M)).min(axis=1))
