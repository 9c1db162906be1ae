"""Where two tracks most likely changed over."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.errors import EditError
from tracking.tracks import Columns, TrackTable, check_known

Floats = NDArray[np.float64]

_WINDOW = 6
"""Rows on either side of a cut from which a walk is told."""
_NEARNESS = 0.25
"""How much a metre (or a mean distance apart) counts against a cut, beside a metre of jump."""
_HERE = 0.1
"""How much of the cost's whole span being as far as can be from the user's frame counts."""


def propose_swap_frame(table: TrackTable, a: int, b: int, near: int | None = None) -> int:
    """The first frame in which a and b should change names.

    Every frame in which both stand is judged as a cut: how far each person would jump from where
    their walk was leading, less how far they would jump with the names changed over, less how far
    apart they are (people change over where they meet). Measured on the floor, or between the
    boxes' centres where there are no metres. near: the frame the user looks at; of two cuts about
    as good the nearer one wins.

    Raises EditError for unknown or equal tracks, and where they never stand in one frame.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError(f"track {a} cannot change over with itself; choose two different tracks")
    rows_a, rows_b = table.of_track(a), table.of_track(b)
    frames, at_a, at_b = np.intersect1d(
        rows_a["frame"], rows_b["frame"], assume_unique=True, return_indices=True
    )
    if not len(frames):
        return _handover(table, a, b)
    places_a, places_b = _places(rows_a, rows_b)
    known = np.isfinite(places_a[at_a]).all(axis=1) & np.isfinite(places_b[at_b]).all(axis=1)
    if not known.any():
        return int(frames[0])
    frames, at_a, at_b = frames[known], at_a[known], at_b[known]
    cost = _cost(frames, places_a[at_a], places_b[at_b])
    if near is not None:
        away = np.abs(frames - near) / max(int(np.ptp(frames)), 1)
        cost = cost + _HERE * np.ptp(cost) * away
    return int(frames[int(np.argmin(cost))])


def _handover(table: TrackTable, a: int, b: int) -> int:
    """Tracks that never stand in one frame change over where the later one begins."""
    return max(table.frame_range(a)[0], table.frame_range(b)[0])


def _places(rows_a: Columns, rows_b: Columns) -> tuple[Floats, Floats]:
    """(n, 2) where the people are: metres on the floor, else centres of boxes in pixels."""
    on_floor = [np.column_stack([rows["x"], rows["y"]]) for rows in (rows_a, rows_b)]
    if all(np.isfinite(places).all(axis=1).mean() > 0.5 for places in on_floor):
        return on_floor[0], on_floor[1]
    left, right = (
        np.column_stack([rows["left"] + rows["width"] / 2, rows["top"] + rows["height"] / 2])
        for rows in (rows_a, rows_b)
    )
    return left, right


def _cost(frames: NDArray[np.int32], a: Floats, b: Floats) -> Floats:
    """(n,) the lower, the likelier the two changed over between the frame before and this one."""
    apart = _length(a - b)
    meeting: Floats = np.minimum(apart, np.concatenate([apart[:1], apart[:-1]]))
    if len(frames) < 3:
        return meeting
    led_a, came_a = _walks(frames, a)
    led_b, came_b = _walks(frames, b)
    kept = _jump(led_a, came_a) + _jump(led_b, came_b)
    changed = _jump(led_a, came_b) + _jump(led_b, came_a)
    cost: Floats = changed - kept + _NEARNESS * meeting
    return cost


def _walks(frames: NDArray[np.int32], places: Floats) -> tuple[Floats, Floats]:
    """Where the rows before each cut lead to, and where those after it come from.

    Both (n, 4): place at the cut and the way walked in half a window, by a line fitted to a window
    of rows. Cut i lies between rows i - 1 and i; beyond its ends the walk goes on as it was.
    """
    width = min(_WINDOW, len(frames) - 1)
    times = np.pad(frames.astype(float), width, "reflect", reflect_type="odd")
    padded = np.pad(places, ((width, width), (0, 0)), "reflect", reflect_type="odd")
    t = np.lib.stride_tricks.sliding_window_view(times, width)
    p = np.lib.stride_tricks.sliding_window_view(padded, width, axis=0)
    middle = t.mean(axis=1)
    off = t - middle[:, None]
    slope = np.einsum("nw,ncw->nc", off, p) / np.square(off).sum(axis=1)[:, None]
    cuts = (times[width - 1 : -width - 1] + times[width:-width]) / 2

    def at_cut(side: slice) -> Floats:
        place = p.mean(axis=2)[side] + slope[side] * (cuts - middle[side])[:, None]
        return np.hstack([place, slope[side] * width / 2])

    return at_cut(slice(0, len(frames))), at_cut(slice(width, len(frames) + width))


def _jump(led: Floats, came: Floats) -> Floats:
    """(n,) how far place and walk on both sides of a cut are from each other."""
    apart = led - came
    return _length(apart[:, :2]) + _length(apart[:, 2:])


def _length(vectors: Floats) -> Floats:
    lengths: Floats = np.linalg.norm(vectors, axis=1)
    return lengths
