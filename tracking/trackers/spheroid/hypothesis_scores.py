"""How well hypotheses explain what is seen: the scores of everybody's spheroids."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses
from tracking.trackers.spheroid.sums import Inside, Window, sums_inside, window

Floats = NDArray[np.float64]
Picture = NDArray[np.uint8]

LINES = 20
"""At most so many lines of a person are looked at; in large ones several rows are summed to one."""
_CORNERS = 40
_FINE = 3
"""Bits of a pixel in which silhouettes are drawn."""


@dataclass(frozen=True, slots=True, eq=False)
class JudgedFrame:
    """A frame as hypotheses are judged by it.

    Attributes:
        ramp: (height, width) uint8, B times 255 in flat pixels.
        counted: (height, width) bool, pixels that were recorded and are behind nothing drawn.
        cover: (height, width) uint8, how many people's silhouettes lie there, at most 255.
    """

    ramp: Picture
    counted: NDArray[np.bool_]
    cover: Picture


@dataclass(frozen=True, slots=True, eq=False)
class Judgement:
    """What was found of hypotheses (people, n).

    Attributes:
        inside: sums in their silhouettes, other people's pixels left out.
        region: sum of B in the region of evaluation, (people, 1) or (people, n).
    """

    inside: Inside
    region: Floats

    def scores(self) -> Floats:
        """C = sum(B V) / sum(max(B, V)), 0 where nothing counts ([Waechter2013] eq. 2)."""
        seen, area = self.inside.ramp, self.inside.area
        whole = area + np.maximum(self.region - seen, 0.0)
        return np.asarray(seen / np.maximum(whole, 1e-9))


def silhouette(shape: tuple[int, ...], outline: Floats, left: int, top: int) -> Picture:
    """(height, width) uint8, 1 inside of an outline (corners, 2) px, of a part of the picture."""
    drawn = np.zeros(shape[:2], np.uint8)
    if drawn.size and np.isfinite(outline).all():
        corners = np.rint((outline - (left, top)) * (1 << _FINE)).astype(np.int32)
        cv2.fillConvexPoly(drawn, corners, 1, cv2.LINE_8, _FINE)
    return drawn


def enlarge(outlines: Ellipses, scale: float) -> Ellipses:
    """Ellipses about the same centres, so many times as large."""
    wide = (getattr(outlines, name) * scale**2 for name in ("uu", "uv", "vv"))
    return Ellipses(outlines.u, outlines.v, *wide)


def count_covering(shape: tuple[int, ...], people: Ellipses) -> Picture:
    """(height, width) uint8, in how many of the silhouettes (people) each flat pixel lies."""
    cover = np.zeros(shape[:2], np.uint8)
    corners = people.polygons(_CORNERS)
    for left, top, right, bottom, outline in zip(*bounds(people, shape), corners, strict=True):
        part = cover[top:bottom, left:right]
        part += silhouette(part.shape, outline, left, top)
    return cover


def bounds(
    outlines: Ellipses, shape: tuple[int, ...]
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """Left, top, right, bottom of outlines within a picture, half-open; empty where there is none.

    Args:
        outlines: (people) or (people, n): then of all of each person's.
    """
    ends = (*outlines.columns(), *outlines.rows())
    flat = (len(ends[0]), ends[0].size // max(len(ends[0]), 1))
    left, right, top, bottom = (end.reshape(flat) for end in ends)
    sides = []
    for side, extreme, length in (
        (left, np.fmin, shape[1]),
        (top, np.fmin, shape[0]),
        (right, np.fmax, shape[1]),
        (bottom, np.fmax, shape[0]),
    ):
        end = extreme.reduce(side, axis=1, initial=np.nan)
        end[np.isnan(end)] = 0.0
        outward = np.floor(end) if extreme is np.fmin else np.ceil(end) + 1
        sides.append(np.clip(outward, 0, length).astype(np.intp))
    return sides[0], sides[1], np.maximum(sides[2], sides[0]), np.maximum(sides[3], sides[1])


def windows_of(judged: JudgedFrame, reach: Ellipses, own: Ellipses, lines: int) -> list[Window]:
    """A window for each person, with the other people's silhouettes masked out.

    Args:
        reach: (people, n) what the window must hold. own: (people) each one's own silhouette,
            which is part of the cover. lines: most in a silhouette, 0: as many as it has.
    """
    shape = judged.ramp.shape
    corners, boxes = own.polygons(_CORNERS), np.column_stack(bounds(own, shape))
    top, bottom = own.rows()
    tall = np.nan_to_num(bottom - top, nan=0.0)
    windows = []
    for k, (left, up, right, down) in enumerate(zip(*bounds(reach, shape), strict=True)):
        part = np.s_[up:down, left:right]
        others = others_cover(judged.cover, (left, up, right, down), corners[k], boxes[k])
        counted = judged.counted[part] & (others == 0)
        step = max(1, int(np.ceil(tall[k] / lines))) if lines else 1
        step = min(step, max(int(down - up), 1))
        windows.append(window(judged.ramp[part], counted, int(left), int(up), step))
    return windows


def others_cover(
    cover: Picture, part: tuple[int, int, int, int], outline: Floats, box: NDArray[np.intp]
) -> Picture:
    """(height, width) uint8, how many other people's silhouettes lie in a part of the picture.

    The own one is drawn in the box in which `count_covering` drew it: elsewhere its edge, where it
    leaves the picture, may be a pixel off.

    Args:
        cover: everybody's. part: left, top, right, bottom. outline: (corners, 2) px of the own
            silhouette. box: (4,) its `bounds`.
    """
    left, top, right, bottom = (int(side) for side in box)
    own = silhouette((bottom - top, right - left), outline, left, top)
    others = cover[part[1] : part[3], part[0] : part[2]].copy()
    low_u, low_v = max(left, part[0]), max(top, part[1])
    high_u, high_v = max(min(right, part[2]), low_u), max(min(bottom, part[3]), low_v)
    shared = own[low_v - top : high_v - top, low_u - left : high_u - left]
    others[low_v - part[1] : high_v - part[1], low_u - part[0] : high_u - part[0]] -= shared
    return others


def judge(windows: list[Window], hypotheses: Ellipses, regions: Ellipses) -> Judgement:
    """What lies in the hypotheses (people, n) and in regions of evaluation (people, 1 or n)."""
    return Judgement(sums_inside(windows, hypotheses), sums_inside(windows, regions).ramp)
