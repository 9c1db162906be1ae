"""Hints to perception of where people are: where to leave the background, where shadows fall."""

from __future__ import annotations

import numpy as np

from tracking.foreground import BodyMasks
from tracking.geometry import FlatView, ellipses_of
from tracking.trackers.spheroid.hypotheses import SpheroidPeople
from tracking.trackers.spheroid.hypothesis_scores import count_covering
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.weights import axes_of, silhouettes

_SURE_S = 0.7
_SURE = 0.5
"""Age, and shares in sight and of foreground, from which on somebody is known for certain."""
_UPPER = (0.64, 0.36)
"""Middle and half height of the body above the shins, in body heights: shadows lie below."""
_SLIM = 0.8
_SHADE = (1.0, 1.0, 0.02)
"""Semi-axes in m of the floor about somebody's feet: seen from above, a body lies before its own
shadow there, and what is which cannot be told."""
_KEPT, _BESIDE = 1.2, 2.2
"""Sizes of silhouettes that hold people generously, and that hold their shadows, too."""


def body_masks(people: SpheroidPeople, flat: FlatView, settings: SpheroidSettings) -> BodyMasks:
    """The masks of the frame's people."""
    shape = flat.size[::-1]
    sure = people.select(
        (people.age_s > _SURE_S) & (people.coverage > _SURE) & (people.shown > _SURE)
    )
    kept = count_covering(shape, silhouettes(people, flat, settings, _KEPT))
    beside = count_covering(shape, silhouettes(sure, flat, settings, _BESIDE))
    beside[kept > 0] = 0
    middle, half = (share * sure.height for share in _UPPER)
    wide = np.full(len(sure), _SLIM * settings.radius_m)
    centre = np.column_stack((axes_of(sure, settings), middle))
    upper = ellipses_of(flat.projection, centre, np.column_stack((wide, wide, half)))
    on = count_covering(shape, upper)
    feet = np.column_stack((sure.xy, np.zeros(len(sure))))
    shade = ellipses_of(flat.projection, feet, np.broadcast_to(_SHADE, feet.shape))
    on[count_covering(shape, shade) > 0] = 0
    return BodyMasks(on, beside, kept)
