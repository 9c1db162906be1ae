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
    """

    ramp: Floats
    area: Floats


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
    if 0 in outlines.shape:
        return Inside(np.zeros(outlines.shape), np.zeros(outlines.shape))
    flat = np.concatenate([one.sums.ravel() for one in windows])
    low, high = _looked_up(windows, outlines)
    found = np.take(flat, high, mode="clip")
    found -= np.take(flat, low, mode="clip")
    total = found.sum(axis=-1)
    grey = total & ((1 << _COUNTED) - 1)
    return Inside(grey / 255.0, (total >> _COUNTED).astype(np.float64))


def _looked_up(
    windows: Sequence[Window], outlines: Ellipses
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """(people, hypotheses, lines) the places of both look-ups in all sums joined."""
    left, top, step, lines, width, base = (column[:, None] for column in _measures(windows).T)
    known = np.isfinite(outlines.vv)
    u, v, uu, uv, vv = (np.where(known, getattr(outlines, n), 1.0) for n in outlines.__slots__)
    half = np.sqrt(vv)
    middle = top + (step - 1) / 2
    first = np.clip(np.ceil((v - half - middle) / step), 0, lines)
    last = np.floor((v + half - middle) / step)
    cut = last >= lines
    last = np.minimum(last, lines - 1)
    count = int(max((last - first).max() + 1, 1))
    begin, rise = (middle + first * step - v) / half, step / half
    lean = uv / half
    wide = np.where(known, np.sqrt(np.maximum(uu - lean**2, 0.0)), 0.0)
    start = (base + first * (width + 1)).astype(np.int64)
    rows = start[..., None] + np.arange(count) * (width[..., None] + 1)
    low, high = _ends((begin, rise, count), (u - left, lean, wide), rows, width)
    if cut.any():
        beyond = np.arange(count) > (last - first)[..., None]
        np.copyto(high, low, where=beyond)
    return low, high


def _measures(windows: Sequence[Window]) -> Whole:
    """(people, 6): left, top, step, lines, width and where the sums begin, joined."""
    base = 0
    rows = []
    for one in windows:
        lines, wide = one.sums.shape
        rows.append((one.left, one.top, one.step, lines, wide - 1, base))
        base += one.sums.size
    return np.array(rows, np.int64)


def _ends(
    lines: tuple[Floats, Floats, int],
    shape: tuple[Floats, Floats, Floats],
    rows: Whole,
    width: Whole,
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The first place within and the first one beyond of each line.

    Between whole numbers ceil(x) is floor(x + 1), and lines that miss get two ends alike.

    Args:
        lines: the first and the distance between two, in halves from the centre, and how many.
        shape: centre from the window's left, lean and half width, px.
        rows: where each line's sums begin. width: of the windows.
    """
    begin, rise, count = lines
    centre, lean, wide = shape
    down = rise[..., None] * np.arange(count)
    down += begin[..., None]
    reach = down * down
    np.subtract(1.0, reach, out=reach)
    np.maximum(reach, 0.0, out=reach)
    np.sqrt(reach, out=reach)
    reach *= wide[..., None]
    down *= lean[..., None]
    down += centre[..., None] + 1.0
    low = down - reach
    down += reach
    limit = width[..., None].astype(np.float64)
    places = []
    for end in (low, down):
        np.maximum(end, 0.0, out=end)
        np.minimum(end, limit, out=end)
        place = end.astype(np.intp)
        place += rows
        places.append(place)
    return places[0], places[1]
