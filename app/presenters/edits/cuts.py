"""The frames where two people may have changed over."""

from __future__ import annotations

from app.presenters.edits.ground import Ground
from tracking.editing import SwapFrame, propose_swap_frames
from tracking.errors import EditError

_MOST = 4
_LEAST_LIKELY = 0.01


def changed_over(on: Ground, track: int, other: int, near: int) -> tuple[SwapFrame, ...]:
    """The likeliest first; nothing where the two cannot be compared: the plan says why."""
    try:
        found = propose_swap_frames(on.table, track, other, near, on.signals, _MOST)
    except EditError:
        return ()
    return tuple(one for one in found if one is found[0] or one.likelihood >= _LEAST_LIKELY)
