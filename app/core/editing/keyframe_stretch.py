"""The stretch between two keyframes."""

from __future__ import annotations

import numpy as np

from app.core.i18n import tr
from tracking.editing import keyframes_of
from tracking.errors import EditError
from tracking.tracks import TrackTable


def stretch_between_keyframes(table: TrackTable, track: int, frame: int) -> tuple[int, int]:
    """The half-open stretch from the keyframe at or before a frame to the next one.

    Raises:
        EditError: there is no keyframe on one of the sides.
    """
    keys = keyframes_of(table, track)
    after = int(np.searchsorted(keys, frame, side="right"))
    if after == len(keys) and after >= 2 and int(keys[-1]) == frame:
        after -= 1  # at the last keyframe: the stretch that ends there
    if not 0 < after < len(keys):
        missing = tr("before") if after == 0 else tr("after")
        raise EditError(
            "Track {track} has no keyframe {missing} frame {frame}: draw or move a box there, "
            "or choose a range",
            track=track,
            missing=missing,
            frame=frame,
        )
    return int(keys[after - 1]), int(keys[after]) + 1
