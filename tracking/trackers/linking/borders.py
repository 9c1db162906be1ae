"""Where people come from and go to: cheap at the picture's edges, dear within."""

from __future__ import annotations

import numpy as np

from tracking.geometry import View
from tracking.trackers.linking.seen import BODY_M, Flags, Floats, Seen
from tracking.trackers.linking.tracklets import State, Tracklets

_AHEAD_S = 0.5
"""Who walks out of the picture within this time may have left."""
_INSIDE, _OUTSIDE = 0.95, 0.6
"""Share of a body in the picture: from the one on nobody, from the other on everybody may leave."""
_WHOLE = 0.97
"""Of whom more should be seen, only the head may be cut off."""
_INWARDS = 0.05
"""Who will be seen by so much more soon walks into the picture, not out of it."""
_BIRTHS_EDGE, _BIRTHS_WITHIN = 0.05, 0.0005
"""People who come, a square metre and second, at the edge and within."""
_RETURNS = 0.02
"""Share of those who walked out of the picture that turn outside and come back soon."""
_DEATHS_EDGE, _DEATHS_WITHIN = 0.5, 0.005
"""Share of the tracklets that end there and are not found again."""


def birth_costs(seen: Seen, pieces: Tracklets, view: View, fps: float, start: int) -> Floats:
    """(t,) minus the log-density, in 1/(m² s), of people who come where tracklets begin.

    Args:
        start: first frame of the run; who is there then costs as little as who enters.
    """
    edge = _leaving(pieces.first, seen.at_edge[pieces.start], -_AHEAD_S, view)
    edge[pieces.first.frame <= start + fps / 2] = 1.0
    return -_between(edge, _BIRTHS_WITHIN, _BIRTHS_EDGE)


def death_costs(seen: Seen, pieces: Tracklets, view: View, fps: float, stop: int) -> Floats:
    """(t,) minus the log of how likely people go where tracklets end."""
    edge = _leaving(pieces.last, seen.at_edge[pieces.stop - 1], _AHEAD_S, view)
    edge[pieces.last.frame >= stop - 1 - fps / 2] = 1.0
    return -_between(edge, _DEATHS_WITHIN, _DEATHS_EDGE)


def return_costs(pieces: Tracklets, view: View) -> Floats:
    """(t,) minus the log of how likely people come back who were on their way out at the end."""
    soon = share_inside(pieces.last.place + _AHEAD_S * pieces.last.velocity, view)
    out = np.clip((_OUTSIDE - soon) / _OUTSIDE, 0.0, 1.0)
    return np.asarray(-out * np.log(_RETURNS))


def share_inside(place: Floats, view: View) -> Floats:
    """(n,) how much of a usual body at places (n, 2) the picture shows."""
    box = view.box_of_person(place, *BODY_M)
    low = np.clip(box[:, :2], 0.0, view.camera.size)
    high = np.clip(box[:, :2] + box[:, 2:], 0.0, view.camera.size)
    share = np.prod(high - low, axis=1) / np.prod(box[:, 2:], axis=1)
    return np.asarray(np.nan_to_num(share))


def _leaving(state: State, at_edge: Flags, ahead_s: float, view: View) -> Floats:
    """(t,) 0 to 1, how far people are out of the picture, now or soon."""
    now = share_inside(state.place, view)
    soon = share_inside(state.place + ahead_s * state.velocity, view)
    edge = np.clip((_INSIDE - np.minimum(now, soon)) / (_INSIDE - _OUTSIDE), 0.0, 1.0)
    return np.asarray(np.where(at_edge & (soon < now + _INWARDS) & (now < _WHOLE), 1.0, edge))


def _between(edge: Floats, within: float, outside: float) -> Floats:
    return np.asarray((1.0 - edge) * np.log(within) + edge * np.log(outside))
