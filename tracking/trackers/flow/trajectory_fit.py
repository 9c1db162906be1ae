"""Smooth trajectories fitted to bundles of tracklets."""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from tracking.trackers.flow.bundles import Bundle, Trajectory
from tracking.trackers.flow.chains import Rows, TrackletChains
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.foot_fit import estimate_scale, ratios

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Counts = NDArray[np.int64]

_PUSH_M2_S3 = 0.06
"""How unsteadily people walk, once it is known where they came from and went to."""
_ALONG_M, _BOB_M, _ACROSS_M = 0.05, 0.03, 0.08
"""How much a point of a body errs: along the sight, up and down, across the sight."""
_MOST_A_FRAME = 6
"""More tracklets in a frame say no more."""
_PACE_M_S, _PACE_ERROR = 1.2, 0.35
_HELD_ERROR, _HELD_SPREADS, _HELD_FRAMES = 0.05, 3.0, 30
_TOP_M, _TOP_ERROR_M, _TOP_ERROR, _TOP_ROWS = 1.62, 0.3, 0.1, 100
"""Hints at how far away a bundle is, and their errors, as shares of the distance: the usual pace;
where those stood who held the tracklets; heads, as the topmost that is followed. The fourth, and
surest, are feet."""
_FARTHEST_STEP = 0.25
_STRIDE_S = 0.8
_SLOWEST_M_S, _FASTEST_M_S, _OVER_S = 0.35, 2.2, 0.5
_NEAREST_M, _MARGIN_PX = 1.0, 20.0
_SHOWN_M = (1.2, 1.6)
_STRADDLING, _STRADDLED_S = 3, 0.3
"""So many tracklets lead from so long before a moment to as long after it, or it is a gap."""


def refit(
    bundle: Bundle, chains: TrackletChains, floor: Floor, fps: float
) -> tuple[Trajectory, Counts]:
    """The trajectory of a bundle, and how many of its tracklets there are in each frame of it.

    Frames over which too few tracklets lead count as without any. Each tracklet says where the
    body's axis is, by its place in the body; how far away all that is, tracklets hardly say.
    """
    first = int(chains.frame[bundle.rows].min())
    frame = chains.frame[bundle.rows] - first
    count = np.bincount(frame)
    nearer = _scale(bundle, chains, floor, fps)
    drop = (floor.camera_m - bundle.z_m)[bundle.number] * nearer
    aside = bundle.aside_m[bundle.number, None] * bundle.across
    axis = chains.slope[bundle.rows] * drop[:, None] - aside
    steep = np.hypot(*chains.slope[bundle.rows].T)
    error = np.column_stack((_ALONG_M + _BOB_M * (1 + steep), np.full(len(steep), _ACROSS_M)))
    much = np.minimum(count, _MOST_A_FRAME) / np.maximum(count, 1)
    trajectory = Trajectory(first, _smooth(frame, axis, much[frame, None] / error**2, fps))
    return trajectory, np.where(
        _extend_over(chains.chain[bundle.rows], frame, len(count), fps), count, 0
    )


def is_supported(trajectory: Trajectory, count: Counts, floor: Floor, fps: float) -> Flags:
    """(t,) where a trajectory has tracklets, is in the picture, and goes as fast as people walk."""
    place, step = trajectory.place, round(_OVER_S * fps)
    row = np.arange(len(place))
    low, high = np.maximum(row - step, 0), np.minimum(row + step, len(place) - 1)
    speed = np.hypot(*(place[high] - place[low]).T) / np.maximum(high - low, 1) * fps
    shown = np.zeros(len(place), bool)
    size = np.array(floor.view.camera.size)
    for height_m in _SHOWN_M:
        pixel = floor.pixels(place, np.array(height_m))
        shown |= ((pixel > -_MARGIN_PX) & (pixel < size + _MARGIN_PX)).all(axis=1)
    walks = (speed > _SLOWEST_M_S) & (speed < _FASTEST_M_S)
    return np.asarray(walks & shown & (count > 0) & (np.hypot(*place.T) > _NEAREST_M))


def _scale(bundle: Bundle, chains: TrackletChains, floor: Floor, fps: float) -> float:
    """By how much farther away all should be than the bundle's trajectory."""
    hints = (
        *_pace_says(bundle, chains, fps),
        *_holders_say(bundle, chains),
        *_top_says(bundle, floor),
        *estimate_scale(ratios(chains.feet_m[bundle.rows], np.hypot(*bundle.place.T))),
    )
    weight = sum(weight for _, weight in hints)
    estimate = sum(log * weight for log, weight in hints) / weight if weight else 0.0
    scale = float(np.exp(np.clip(estimate, -_FARTHEST_STEP, _FARTHEST_STEP)))
    lowest = np.percentile(bundle.z_m[bundle.number], 3)
    limit = max(1.0, 1.03 * floor.camera_m / max(floor.camera_m - lowest, 0.05))
    return min(scale, limit)  # nothing lies below the floor


def _pace_says(bundle: Bundle, chains: TrackletChains, fps: float) -> list[tuple[float, float]]:
    """Logarithm of the scale and its weight; nothing where it cannot be estimated."""
    frame, first = np.unique(chains.frame[bundle.rows], return_index=True)
    ahead = np.minimum(np.searchsorted(frame, frame + _STRIDE_S * fps), len(frame) - 1)
    time_s = (frame[ahead] - frame) / fps
    long = time_s > 0.4 * _STRIDE_S
    if not long.any():
        return []
    place = bundle.place[first]
    trajectory = np.hypot(*(place[ahead] - place)[long].T)
    pace = max(float(np.median(trajectory / time_s[long])), 0.1)
    return [(float(np.log(_PACE_M_S / pace)), 1 / _PACE_ERROR**2)]


def _holders_say(bundle: Bundle, chains: TrackletChains) -> list[tuple[float, float]]:
    held = chains.held_at[bundle.rows]
    known = np.isfinite(held[:, 0])
    if known.sum() <= _MOST_A_FRAME:
        return []
    own = np.maximum(np.hypot(*bundle.place[known].T), 0.1)
    farther = np.log(np.maximum(np.hypot(*held[known].T), 0.1) / own)
    estimate = float(np.median(farther))
    spread = float(np.median(np.abs(farther - estimate)))
    much = min(known.sum() / _HELD_FRAMES, 1.0)
    return [(estimate, much / (_HELD_ERROR**2 + (_HELD_SPREADS * spread) ** 2))]


def _top_says(bundle: Bundle, floor: Floor) -> list[tuple[float, float]]:
    if floor.camera_m <= _TOP_M:
        return []
    top = np.percentile(bundle.z_m[bundle.number], 96)
    error = _TOP_ERROR_M / (floor.camera_m - _TOP_M) + _TOP_ERROR
    estimate = np.log((floor.camera_m - _TOP_M) / max(floor.camera_m - top, 0.05))
    return [(float(estimate), min(len(bundle.rows) / _TOP_ROWS, 1.0) / error**2)]


def _smooth(frame: Rows, axis: Floats, weight: Floats, fps: float) -> Floats:
    """(t, 2) the smoothest path near the places (k, 2), weighed along and across the sight."""
    frames = int(frame.max()) + 1
    axes = sight_axes(axis)
    each = np.swapaxes(axes, 1, 2) @ (weight[..., None] * axes)
    precision, toward = np.zeros((frames, 2, 2)), np.zeros((frames, 2))
    np.add.at(precision, frame, each)
    np.add.at(toward, frame, (each @ axis[..., None])[..., 0])
    bands = np.zeros((5, 2 * frames))
    bands[0, 0::2], bands[0, 1::2] = precision[:, 0, 0], precision[:, 1, 1]
    bands[1, 0::2] = precision[:, 0, 1]
    bands[0] += 1e-9
    bend = (1.0, -2.0, 1.0)
    for (one, a), (other, b), axis_ in product(enumerate(bend), enumerate(bend), (0, 1)):
        if other <= one and frames > 2:
            at = 2 * (np.arange(frames - 2) + other) + axis_
            bands[2 * (one - other), at] += fps**3 / _PUSH_M2_S3 * a * b
    return np.asarray(solveh_banded(bands, toward.ravel(), lower=True).reshape(frames, 2))


def _extend_over(chain: Rows, frame: Rows, frames: int, fps: float) -> Flags:
    """(t,) whether enough tracklets lead over each frame, or it is near to one that has them."""
    number = np.unique(chain, return_inverse=True)[1]
    half = max(1, round(_STRADDLED_S * fps))
    begin, end = np.full(number.max() + 1, frames), np.zeros(number.max() + 1, np.int64)
    np.minimum.at(begin, number, frame)
    np.maximum.at(end, number, frame)
    begin, end = begin + half, end - half + 1
    long = end > begin
    leading = np.bincount(begin[long], minlength=frames + 1)
    leading -= np.bincount(end[long], minlength=frames + 1)
    enough = np.cumsum(leading)[:frames] >= _STRADDLING
    near = np.convolve(enough, np.ones(2 * half + 1), "same")[:frames] > 0
    edge = np.flatnonzero(np.diff(np.concatenate(([0], enough.astype(int), [0]))))
    near[(edge[1:-1:2] + edge[2::2]) // 2] = False  # a gap between two stretches stays one
    return np.asarray(near)
