"""Who is followed on, of people who are not seen for a while or have not walked yet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor, in_picture
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.walkers import Walkers

_CHEST_M = 1.2


def should_keep(walkers: Walkers, settings: FlowSettings, floor: Floor) -> NDArray[np.bool_]:
    """(m,) who was seen lately enough, and has gone on from where they began, or is new."""
    limit_s = np.where(
        in_picture(walkers.place, _CHEST_M, floor),
        settings.delete_after_s,
        settings.delete_at_edge_s,
    )
    proven = walkers.walked | (walkers.age_s < settings.confirm_timeout_s)
    return np.asarray((walkers.missed_s <= limit_s) & proven)
