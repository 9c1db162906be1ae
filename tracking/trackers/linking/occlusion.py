"""Occlusion reasoning: who could not be seen because others stood in front."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.seen_rows import BODY_M, Floats, Integers
from tracking.tracks.boxes import common_px2
from tracking.tracks.columns import Columns, boxes_of

Rows = NDArray[np.intp]

_SAMPLES = 6
"""Moments of a way that are looked at."""
_BEHIND_M = 0.2
"""Who stands nearer by so much may be in front."""
_COVERED = 0.5
"""Share of a body that others cover from which on it is hardly seen."""


def hidden_shares(
    tracks: Columns,
    place: tuple[Floats, Floats],
    frame: tuple[Integers, Integers],
    track: tuple[Integers, Integers],
    view: View,
) -> Floats:
    """(k,) the share of straight ways from one place and frame to another that others hide.

    Args:
        tracks: of the run, sorted by frame. place: two times (k, 2) m. frame: two times (k,).
        track: two times (k,): those who walk there hide nobody.
    """
    share = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    on_way = place[0][:, None] + share[:, None] * (place[1] - place[0])[:, None]
    when = np.round(frame[0][:, None] + share * (frame[1] - frame[0])[:, None]).astype(np.int64)
    own = np.repeat(np.stack(track, axis=1), _SAMPLES, axis=0)
    covered = _covered(tracks, on_way.reshape(-1, 2), when.ravel(), own, view)
    return np.asarray((covered.reshape(-1, _SAMPLES) >= _COVERED).mean(axis=1))


def _covered(tracks: Columns, place: Floats, frame: Integers, own: Integers, view: View) -> Floats:
    """(m,) the share of bodies at places (m, 2) in these frames that others cover."""
    body = view.box_of_person(place, *BODY_M)
    range_m = np.hypot(*place.T)
    box = boxes_of(tracks)
    near_m = np.hypot(tracks["x"], tracks["y"])
    first = np.searchsorted(tracks["frame"], frame)
    stop = np.searchsorted(tracks["frame"], frame, side="right")
    covered = np.zeros(len(place))
    for nth in range(int((stop - first).max(initial=0))):
        left = np.flatnonzero(first + nth < stop)
        row = first[left] + nth
        in_front = near_m[row] < range_m[left] - _BEHIND_M
        in_front &= (tracks["track"][row, None] != own[left]).all(axis=1)
        left, row = left[in_front], row[in_front]
        common = common_px2(body[left], box[row])
        covered[left] += np.nan_to_num(common / np.prod(body[left, 2:], axis=1))
    return covered
