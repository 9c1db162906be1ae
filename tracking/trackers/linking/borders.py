"""The birth intensity of tracks, and the probability that they end.

Both are high at the picture's edges, low within it, less so behind others.
"""

from __future__ import annotations

import numpy as np

from tracking.geometry import View
from tracking.trackers.linking.occlusion import hidden_shares
from tracking.trackers.linking.seen_rows import BODY_M, Flags, Floats, SeenRows
from tracking.trackers.linking.tracklets import State, Tracklets
from tracking.tracks import boxes
from tracking.tracks.columns import Columns

_AHEAD_S = 0.5
"""Who walks out of the picture within this time may have left."""
_INSIDE, _OUTSIDE = 0.95, 0.6
"""Share of a body in the picture: from the one on nobody, from the other on everybody may leave."""
_WHOLE = 0.97
"""Of whom more should be seen, only the head may be cut off."""
_INWARDS = 0.05
"""Who will be seen by so much more soon walks into the picture, not out of it."""
_HARDLY = 0.4
"""Who shows less of themselves than this, or a little less, is not seen."""
_WAYS_OUT_M = (3.0, 2.5, 2.0, 1.5, 1.25, 1.0, 0.75, 0.5, 0.25)
"""How far people are thought to walk to be out of the picture, the farthest first."""
_DIRECTIONS = np.stack([turn(np.arange(8) * np.pi / 4) for turn in (np.cos, np.sin)], axis=1)
"""Where to."""
_SEEN_OUT_M, _UNSEEN_M = 0.5, 0.7
"""Who leaves is seen until so near to where they are out; e times fewer for each so much more."""
_BIRTHS_EDGE, _BIRTHS_HIDDEN, _BIRTHS_WITHIN = 0.05, 0.005, 0.0005
"""People who come, a square metre and second: at the edge; more within behind others; within."""
_DEATHS_EDGE, _DEATHS_HIDDEN, _DEATHS_WITHIN = 0.5, 0.05, 0.005
"""Share of the tracklets that end there and are not found again."""
_HIDDEN_S, _FASTEST_M_S = 1.0, 1.5
"""So long somebody walks on, along each axis no faster, to see whether others hide them."""


def birth_costs(
    seen: SeenRows, pieces: Tracklets, tracks: Columns, view: View, fps: float, start: int
) -> Floats:
    """(t,) minus the log-density, in 1/(m² s), of people who come where tracklets begin.

    Args:
        tracks: of the run.
        start: first frame of the run; who is there then costs as little as who enters.
    """
    edge = _leaving(pieces.first, seen.at_edge[pieces.start], -_AHEAD_S, view)
    edge[pieces.first.frame <= start + fps / 2] = 1.0
    within = _BIRTHS_WITHIN + _BIRTHS_HIDDEN * _hidden(pieces, tracks, view, fps, before=True)
    return -_between(edge, within, _BIRTHS_EDGE)


def death_costs(
    seen: SeenRows, pieces: Tracklets, tracks: Columns, view: View, fps: float, stop: int
) -> Floats:
    """(t,) minus the log of how likely people go where tracklets end.

    Args:
        tracks: of the run. stop: the frame after its last one, until which people stay.
    """
    edge = _leaving(pieces.last, seen.at_edge[pieces.stop - 1], _AHEAD_S, view)
    edge[pieces.last.frame >= stop - 1 - fps / 2] = 1.0
    within = _DEATHS_WITHIN + _DEATHS_HIDDEN * _hidden(pieces, tracks, view, fps, before=False)
    return -_between(edge, within, _DEATHS_EDGE)


def share_inside(place: Floats, view: View) -> Floats:
    """(n,) how much of a usual body at places (n, 2) the picture shows."""
    box = view.box_of_person(place, *BODY_M)
    return np.asarray(np.nan_to_num(boxes.share_inside(box, view.camera.size)))


def _leaving(state: State, at_edge: Flags, ahead_s: float, view: View) -> Floats:
    """(t,) 0 to 1, how far people are out of the picture, now or soon."""
    now = share_inside(state.place, view)
    soon = share_inside(state.place + ahead_s * state.velocity, view)
    edge = np.clip((_INSIDE - np.minimum(now, soon)) / (_INSIDE - _OUTSIDE), 0.0, 1.0)
    edge = np.where(at_edge & (soon < now + _INWARDS) & (now < _WHOLE), 1.0, edge)
    unseen_m = np.maximum(_way_out(state.place, view) - _SEEN_OUT_M, 0.0)
    return np.asarray(edge * np.exp(-unseen_m / _UNSEEN_M))


def _way_out(place: Floats, view: View) -> Floats:
    """(n,) m from places (n, 2) to where nobody is seen; at most the farthest of `_WAYS_OUT_M`.

    That a body is cut off does not tell: far from a camera that looks down on them heads are cut
    off for metres, and who is there does not leave all of a sudden.
    """
    way = np.full(len(place), _WAYS_OUT_M[0])
    for reach in _WAYS_OUT_M:
        there = (place[:, None] + reach * _DIRECTIONS).reshape(-1, 2)
        out = share_inside(there, view).reshape(-1, len(_DIRECTIONS)) < _HARDLY
        way[out.any(axis=1)] = reach
    way[share_inside(place, view) < _HARDLY] = 0.0
    return way


def _hidden(pieces: Tracklets, tracks: Columns, view: View, fps: float, *, before: bool) -> Floats:
    """(t,) share of the time before tracklets begin, or after they end, that others may hide."""
    state, way = (pieces.first, -1) if before else (pieces.last, 1)
    pace = np.clip(state.velocity, -_FASTEST_M_S, _FASTEST_M_S)
    place = (state.place, state.place + way * _HIDDEN_S * pace)
    frame = (state.frame, state.frame + way * round(_HIDDEN_S * fps))
    return hidden_shares(tracks, place, frame, (pieces.track, pieces.track), view)


def _between(edge: Floats, within: Floats, outside: float) -> Floats:
    return np.asarray((1.0 - edge) * np.log(within) + edge * np.log(outside))
