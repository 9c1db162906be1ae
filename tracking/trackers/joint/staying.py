"""Who is told of, who is only remembered, and who has gone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.population import Population
from tracking.trackers.stereo_boxes import share_in_view

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]

_PATIENCE_S = 0.15
"""How long a newcomer may go unseen before it is taken for noise."""
_SEEN_SHARE = 1.0
"""Nobody is remembered for longer than this share of the time they were seen."""
_AT_THE_EDGE = 0.75
_OUT_OF_VIEW = 0.35
"""Share of a body inside the picture below which somebody not seen has left it."""


def told(people: Population, shown: Floats, settings: JointSettings, elapsed_s: float) -> Flags:
    """(people,) who is thought to be where they are predicted.

    Somebody who should be seen and is not may be anywhere: they are remembered only.

    Args:
        shown: (people,) share of each body expected to be in sight.
    """
    hidden = shown < settings.hidden_below
    patience_s = np.where(hidden, settings.lost_hidden_s, settings.lost_after_s)
    patience_s = np.minimum(patience_s, _SEEN_SHARE * people.matches * elapsed_s)
    return np.asarray(people.confirmed & (people.missed_s <= patience_s))


def staying(people: Population, settings: JointSettings, view: View, elapsed_s: float) -> Flags:
    """(people,) who is followed or remembered on.

    Those who were last seen at the picture's edge, or walked out of it, are not: who enters there
    is somebody else.
    """
    inside = share_in_view(people, view)
    patience_s = np.where(inside < _AT_THE_EDGE, settings.lost_at_edge_s, settings.remember_s)
    patience_s = np.minimum(patience_s, _SEEN_SHARE * people.matches * elapsed_s)
    patience_s = np.where(people.confirmed, patience_s, _PATIENCE_S)
    patience_s = np.where(inside < _OUT_OF_VIEW, 0.0, patience_s)
    return np.asarray(people.missed_s <= patience_s)
