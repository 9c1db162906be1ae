"""How much of a ramp picture lies in outlines: running sums along lines, two look-ups a line.

[Waechter2013] eq. 3: with a binary silhouette V the sums of eq. 2 need B only at the two ends of
each line, once B is summed along the lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]

_COUNTED = 32
"""Bits by which the number of pixels stands above the sum of their grey levels: one look-up finds
both."""
_BLOCK = 450
"""Silhouettes worked on at once: their lines' numbers then stay in the processor's cache."""


@dataclass(frozen=True, slots=True, eq=False)
class Window:
    """A part of a picture in which sums are taken.

    Attributes:
        left, top: of the part, px. sums: (lines, columns + 1) running sums along each line.
        step: rows of the picture that a line is the sum of.
    """

    left: int
    top: int
    sums: Whole
    step: int


@dataclass(frozen=True, slots=True, eq=False)
class Inside:
    """What lies in silhouettes, of any batch shape.

    Attributes:
        ramp: sum of B. area: number of pixels that count.
        low_ramp, low_area: the same below the centre alone.
    """

    ramp: Floats
    area: Floats
    low_ramp: Floats
    low_area: Floats


def window(
    ramp: NDArray[np.uint8],
    counted: NDArray[np.bool_],
    left: int,
    top: int,
    step: int = 1,
) -> Window:
    """The running sums of a part of a picture.

    Args:
        ramp: (height, width) uint8, B times 255, of the part. counted: (height, width), which
            pixels count: those masked out prove nothing, neither for nor against.
        left, top: where the part lies in the picture.
        step: rows summed to a line; what is left over at the bottom is left out.
    """
    lines = ramp.shape[0] // step
    packed = ramp[: lines * step].astype(np.int64)
    packed += 1 << _COUNTED
    packed *= counted[: lines * step]
    if step > 1:
        packed = packed.reshape(lines, step, -1).sum(axis=1)
    sums = np.zeros((lines, ramp.shape[1] + 1), np.int64)
    np.cumsum(packed, axis=1, out=sums[:, 1:])
    return Window(left, top, sums, step)


def sums_inside(windows: Sequence[Window], outlines: Ellipses) -> Inside:
    """What lies in each person's hypotheses, all people at once.

    Lines enter at their middle; a pixel belongs to a silhouette if its centre does. What lies
    outside of the person's window does not count.

    Args:
        windows: (people). outlines: (people, hypotheses).
    """
    if 0 in outlines.shape or not any(one.sums.size for one in windows):
        none = np.zeros(outlines.shape)  # nobody is in sight
        return Inside(none, none, none, none)
    flat = np.concatenate([one.sums.ravel() for one in windows])
    lines = _lines(windows, outlines)
    blocks = range(0, lines.shape[1], _BLOCK)
    totals = np.concatenate([_look_up(flat, lines[:, k : k + _BLOCK]) for k in blocks], axis=1)
    totals = totals.reshape(2, *outlines.shape)
    ramp = (totals & ((1 << _COUNTED) - 1)) / 255.0
    area = (totals >> _COUNTED).astype(np.float64)
    return Inside(ramp[0], area[0], ramp[1], area[1])


def _lines(windows: Sequence[Window], outlines: Ellipses) -> Floats:
    """(9, people * hypotheses) of each silhouette what its lines are made from.

    The first line's distance from the centre and that between two lines, in halves of the height;
    how many lines there are and whether they end at the window's edge; the centre's column in the
    window, lean and half width; where the first line's sums begin, and the window's width.
    """
    left, top, step, count, width, base = (column[:, None] for column in _measures(windows).T)
    known = np.isfinite(outlines.vv)
    u, v, uu, uv, vv = (np.where(known, getattr(outlines, n), 1.0) for n in outlines.__slots__)
    half = np.sqrt(vv)
    middle = top + (step - 1) / 2
    first = np.clip(np.ceil((v - half - middle) / step), 0, count)
    last = np.floor((v + half - middle) / step)
    cut = last >= count
    lean = uv / half
    wide = np.where(known, np.sqrt(np.maximum(uu - lean**2, 0.0)), 0.0)
    rows = np.maximum(np.minimum(last, count - 1) - first + 1, 0)
    begin, start = (middle + first * step - v) / half, base + first * (width + 1)
    columns = (begin, step / half, rows, cut, u - left, lean, wide, start, width)
    return np.stack([np.broadcast_to(one, v.shape).ravel() for one in columns])


def _measures(windows: Sequence[Window]) -> Whole:
    """(people, 6): left, top, step, lines, width and where the sums begin, joined."""
    base = 0
    rows = []
    for one in windows:
        lines, wide = one.sums.shape
        rows.append((one.left, one.top, one.step, lines, wide - 1, base))
        base += one.sums.size
    return np.array(rows, np.int64)


def _look_up(flat: Whole, lines: Floats) -> Whole:
    """(2, n) packed sums in silhouettes, and below their centres; two look-ups a line.

    Args:
        flat: all running sums. lines: (9, n) of `_lines`.
    """
    begin, rise, rows, cut, _, _, _, start, width = lines
    count = np.arange(int(max(rows.max(), 1)))
    places = start.astype(np.int64)[:, None] + count * (width.astype(np.int64)[:, None] + 1)
    low, high = _ends(lines, count)
    low += places
    high += places
    if cut.any():
        np.copyto(high, low, where=count >= rows[:, None])
    found = np.take(flat, high, mode="clip")
    found -= np.take(flat, low, mode="clip")
    whole = found.sum(axis=1)
    found[begin[:, None] + rise[:, None] * count <= 0.0] = 0
    return np.stack([whole, found.sum(axis=1)])


def _ends(lines: Floats, count: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """(n, k) the first column within and the first one beyond, from the window's left.

    Between whole numbers ceil(x) is floor(x + 1), and lines that miss get two ends alike.
    """
    begin, rise, _, _, centre, lean, wide, _, width = (column[:, None] for column in lines)
    down = rise * count
    down += begin
    reach = down * down
    np.subtract(1.0, reach, out=reach)
    np.maximum(reach, 0.0, out=reach)
    np.sqrt(reach, out=reach)
    reach *= wide
    down *= lean
    down += centre + 1.0
    low = down - reach
    down += reach
    for end in (low, down):
        np.maximum(end, 0.0, out=end)
        np.minimum(end, width, out=end)
    return low.astype(np.intp), down.astype(np.intp)
