"""Mean shift of tracklets in space and time with a rectangular kernel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.kernels import KernelTable

Vectors = NDArray[np.float64]
"""(n, t, 2) px: tracklets, or modes, over their last t positions, newest first."""
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

MOST_STEPS = 60
_SETTLED_PX = 0.05
_LOWER = 0.08, 0.25
"""Where the lower part of a body is below its middle, in heights of the kernel, which reaches a
body's height up and down. What has no tracklets there is hidden."""
_UPPER = 0.65
"""How much of a body is left then."""


@dataclass(frozen=True, slots=True, eq=False)
class Clusters:
    """Tracklets gathered.

    Attributes:
        mode: (m, t, 2) px, the middles of the clusters.
        size: (m, 2) width and height px of their kernels in the newest frame.
        label: (n,) the cluster of each tracklet; -1: none.
    """

    mode: Vectors
    size: Vectors
    label: Indices

    def __len__(self) -> int:
        """How many clusters there are."""
        return len(self.mode)


def is_inside(modes: Vectors, size: Vectors, tracklets: Vectors) -> Flags:
    """(m, n) whether a tracklet lies in a mode's kernel at every instant [Yoneji2013] eq. 7.

    A kernel is a rectangle round the mode. In the source it reaches a body's width and height from
    there to each side (eq. 4), so that it holds a whole body from any point of it.

    Args:
        modes: (m, t, 2). size: (m, t, 2), NaN: nothing is inside. tracklets: (n, t, 2).
    """
    within = np.ones((len(modes), len(tracklets)), bool)
    for instant in range(modes.shape[1]):
        for axis in range(2):
            away = tracklets[:, instant, axis] - modes[:, instant, axis, None]
            within &= 2 * np.abs(away) <= size[:, instant, axis, None]
    return within


def shift_modes(modes: Vectors, within: Flags, tracklets: Vectors) -> Vectors:
    """(m, t, 2) the mean of what is in each kernel [Yoneji2013] eq. 2; empty ones stay.

    With the tracklets of the frame before in the kernels and this frame's to take the mean of, it
    is the paper's eq. 8, by which modes are carried on.
    """
    count = within.sum(axis=1)
    flat = tracklets.reshape(len(tracklets), 2 * tracklets.shape[1])
    total = within.astype(np.float64) @ flat
    mean = total.reshape(len(modes), *tracklets.shape[1:]) / np.maximum(count, 1)[:, None, None]
    return np.where((count > 0)[:, None, None], mean, modes)


def settle_modes(modes: Vectors, tracklets: Vectors, table: KernelTable) -> Vectors:
    """Modes (m, t, 2) shifted until none moves any more."""
    modes, moving = modes.copy(), np.arange(len(modes))
    for _ in range(MOST_STEPS):
        if not len(moving):
            break
        before = modes[moving]
        after = shift_modes(before, is_inside(before, table.at(before), tracklets), tracklets)
        modes[moving] = after
        moving = moving[np.abs(after - before).max(axis=(1, 2)) > _SETTLED_PX]
    return modes


def join_modes(modes: Vectors, size: Vectors, weight: NDArray[np.int64], bound: float) -> Indices:
    """(m,) for each mode the one it joins, which may be itself: the heaviest near enough.

    Args:
        size: (m, t, 2) of the kernels. weight: (m,) tracklets in them.
        bound: how near, in halves of the kernel's sides of the heavier one.
    """
    order = np.lexsort((np.arange(len(modes)), -weight))
    target = np.full(len(modes), -1)
    for row in order:
        if target[row] >= 0:
            continue
        near = is_inside(modes[row : row + 1], bound * size[row : row + 1], modes)[0]
        near[row] = True
        target[near & (target < 0)] = row
    return target


def gather_clusters(
    modes: Vectors, tracklets: Vectors, size: Vectors, fewest: int, bound: float
) -> Clusters:
    """Modes joined and emptied ones dropped, each tracklet given to the nearest that holds it.

    Args:
        size: (m, t, 2) of the modes' kernels.
        fewest: tracklets of a cluster. bound: of `join_modes`.
    """
    held = is_inside(modes, size, tracklets)
    kept = np.unique(join_modes(modes, size, held.sum(axis=1), bound))
    modes, size, held = modes[kept], size[kept], held[kept]
    label = _nearest(modes, size, held, tracklets)
    count = np.bincount(label[label >= 0], minlength=len(modes))
    large = count >= fewest
    number = np.where(large, np.cumsum(large) - 1, -1)
    label = np.where(label >= 0, np.append(number, -1)[label], -1)
    return Clusters(modes[large], size[large, 0], label)


def cluster_cold(
    tracklets: Vectors, table: KernelTable, fewest: int, bound: float, *, occlusion: bool = False
) -> Clusters:
    """Every tracklet shifted until it settles: without anything known of the frame before."""
    modes = settle_modes(tracklets, tracklets, table)
    return finish_clusters(modes, tracklets, table, fewest, bound, occlusion=occlusion)


def cluster_warm(
    before: Vectors,
    tracklets: Vectors,
    table: KernelTable,
    fewest: int,
    bound: float,
    *,
    occlusion: bool = False,
) -> Clusters:
    """The modes of the frame before moved by their members and shifted one step.

    Tracklets that are in no kernel begin modes of their own, which settle within the next frames.
    [Yoneji2013] section 4.

    Args:
        before: (m, t, 2) modes of the frame before.
        tracklets: (n, t, 2); their second position is where they were then.
    """
    modes = _carry_modes(before, tracklets, table)
    modes = shift_modes(modes, is_inside(modes, table.at(modes), tracklets), tracklets)
    free = ~is_inside(modes, table.at(modes), tracklets).any(axis=0)
    new = tracklets[free]
    new = shift_modes(new, is_inside(new, table.at(new), tracklets[free]), tracklets[free])
    modes = np.concatenate((modes, new))
    return finish_clusters(modes, tracklets, table, fewest, bound, occlusion=occlusion)


def finish_clusters(
    modes: Vectors,
    tracklets: Vectors,
    table: KernelTable,
    fewest: int,
    bound: float,
    *,
    occlusion: bool,
) -> Clusters:
    """Clusters of modes that were shifted, with kernels shrunk where bodies are hidden."""
    size = table.at(modes)
    if occlusion:
        size = shrink_kernels(modes, size, tracklets)
    return gather_clusters(modes, tracklets, size, fewest, bound)


def shrink_kernels(modes: Vectors, size: Vectors, tracklets: Vectors) -> Vectors:
    """The kernels (m, t, 2) less the lower part where that has no tracklets: it is hidden.

    [Yoneji2013] section 3.2.3.
    """
    away = tracklets[:, 0] - modes[:, 0][:, None]
    width, height = size[:, 0, 0, None], size[:, 0, 1, None]
    beside = 2 * np.abs(away[..., 0]) <= width
    below = (away[..., 1] >= _LOWER[0] * height) & (away[..., 1] <= _LOWER[1] * height)
    hidden = ~(beside & below).any(axis=1)
    less = size.copy()
    less[hidden, :, 1] *= _UPPER
    return less


def _carry_modes(before: Vectors, tracklets: Vectors, table: KernelTable) -> Vectors:
    """The modes before, (m, t, 2), with the mean of their members' new positions put first."""
    then = np.concatenate((tracklets[:, 1:], tracklets[:, -1:]), axis=1)[:, : before.shape[1] - 1]
    known = before[:, : then.shape[1]]
    held = is_inside(known, table.at(known), then)
    pace = before[:, :1] + (before[:, :1] - before[:, 1:2])
    newest = shift_modes(pace, held, tracklets[:, :1])
    return np.concatenate((newest, before[:, :-1]), axis=1)


def _nearest(modes: Vectors, size: Vectors, held: Flags, tracklets: Vectors) -> Indices:
    """(n,) of the modes that hold a tracklet the nearest, in sizes of its kernel; -1: none."""
    if not len(modes) or not len(tracklets):
        return np.full(len(tracklets), -1)
    away = (tracklets[:, 0] - modes[:, 0][:, None]) / size[:, 0][:, None]
    cost = np.where(held, (away**2).sum(axis=2), np.inf)
    best = cost.argmin(axis=0)
    return np.where(np.isfinite(cost[best, np.arange(len(tracklets))]), best, -1)
