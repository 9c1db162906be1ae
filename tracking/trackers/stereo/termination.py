"""Track termination: who is missed for too long, or has left the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.stereo.boxes import expected_visibility, share_in_view
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoTrackerSettings

Floats = NDArray[np.float64]

TENTATIVE_PATIENCE_S = 0.15
"""How long a tentative track may go unseen before it is deleted as noise."""
_AT_THE_EDGE = 0.75
OUT_OF_VIEW = 0.35
"""Share of a body inside the picture below which somebody not seen has left it."""


def should_keep(
    people: Population, box: Floats, settings: StereoTrackerSettings, size: tuple[int, int]
) -> NDArray[np.bool_]:
    """Whether each track is kept or deleted: (people,).

    Args:
        box: (people, 4) px of their bodies. size: width and height of the picture.
    """
    inside = share_in_view(box, size)
    patience_s = np.where(inside < _AT_THE_EDGE, settings.delete_at_edge_s, settings.delete_after_s)
    hidden = expected_visibility(people, box, size) < settings.min_visibility * inside
    patience_s = np.where(hidden, settings.delete_occluded_s, patience_s)
    patience_s = np.where(people.confirmed, patience_s, TENTATIVE_PATIENCE_S)
    left = inside < OUT_OF_VIEW
    return np.asarray((people.missed_s == 0.0) | ((people.missed_s <= patience_s) & ~left))
