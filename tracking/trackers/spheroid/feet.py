"""What feet say of how far away people are: legs end there, and the floor below them is empty."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, ellipses_of
from tracking.trackers.spheroid.hypothesis_scores import JudgedFrame

Floats = NDArray[np.float64]
Whole = NDArray[np.intp]
Picture = NDArray[np.uint8]
Numbers = NDArray[np.uint16]

_RADIUS_M, _SHIN_M, _BELOW_M = 0.22, 0.15, 0.2
"""Of the shins and of what lies below them: half their width, half their heights."""
_LEGS_FULL, _BELOW_FULL = 0.5, 0.4
"""Shares of foreground there that say all: legs leave a gap."""
_ZONE_M = (0.4, 0.4, 0.3)
"""Semi-axes in m about the shins of people who walk: what lies there may be their feet."""
_CORNERS = 20
"""Of the outlines of those who hide others' feet."""
_FAR_PX = 20_000


@dataclass(frozen=True, slots=True)
class Strips:
    """Boxes in the flat picture, of any batch shape.

    Attributes:
        u, v: (...) px of their middles. wide, tall: (...) px, half of their sizes; NaN: not seen.
    """

    u: Floats
    v: Floats
    wide: Floats
    tall: Floats

    def at(self, rows: NDArray[np.intp]) -> Strips:
        """Those at these rows, as hypotheses (1, n) of one person."""
        return Strips(*(getattr(self, name)[rows][None] for name in self.__slots__))


@dataclass(frozen=True, slots=True)
class Feet:
    """Where legs of hypotheses end, and what the camera sees below them: the floor before them."""

    legs: Strips
    below: Strips


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A part of the picture in which strips are looked at.

    Attributes:
        left, top: px. ramp, area: (rows + 1, columns + 1) sums of B and of pixels that count, over
            all that is above and to the left.
    """

    left: int
    top: int
    ramp: NDArray[np.int32]
    area: NDArray[np.int32]


def feet_of(flat: FlatView, axes: Floats) -> Feet:
    """The feet of people at places (..., 2) m.

    [Waechter2013] has none: spheroids end in a point there, and legs, which leave a gap, fill so
    little of them that people seen from the side were thought to stand farther away, feet aside.
    """
    return Feet(_strips(flat, axes, _SHIN_M, _SHIN_M), _strips(flat, axes, -_BELOW_M, _BELOW_M))


def _strips(flat: FlatView, xy: Floats, z_m: float, half_m: float) -> Strips:
    """The boxes about upright bodies at places (..., 2) m, their middles so high over the floor."""
    matrix = flat.projection
    u, v, depth = (
        xy[..., 0] * row[0] + xy[..., 1] * row[1] + (z_m * row[2] + row[3]) for row in matrix
    )
    depth = np.where(depth > 1e-6, depth, np.nan)
    camera_position = np.asarray(flat.camera_position)
    away2 = (xy[..., 0] - camera_position[0]) ** 2 + (xy[..., 1] - camera_position[1]) ** 2
    down = camera_position[2] ** 2 / (away2 + camera_position[2] ** 2)
    focal_px = float(np.linalg.norm(np.cross(matrix[0, :3], matrix[2, :3])))
    px_per_m = focal_px / depth
    along = px_per_m * np.sqrt(half_m**2 * (1.0 - down) + _RADIUS_M**2 * down)
    across = px_per_m * _RADIUS_M
    u, v = u / depth, v / depth
    # Bodies are upright in the picture only if the camera is not turned and not straight above.
    up_u, up_v = matrix[0, 2] - u * matrix[2, 2], matrix[1, 2] - v * matrix[2, 2]
    lean2 = up_u**2 / np.maximum(up_u**2 + up_v**2, 1e-12)
    wide = np.sqrt(along**2 * lean2 + across**2 * (1.0 - lean2))
    return Strips(u, v, wide, np.sqrt(along**2 * (1.0 - lean2) + across**2 * lean2))


def foot_zones(flat: FlatView, xy: Floats) -> Ellipses:
    """(people) where feet of people at xy (people, 2) m may be, px of the flat picture."""
    centre = np.column_stack((xy, np.full(len(xy), _ZONE_M[2])))
    return ellipses_of(flat.projection, centre, np.broadcast_to(_ZONE_M, centre.shape))


def feet_parts(
    judged: JudgedFrame, flat: FlatView, own: Ellipses, axes: Floats, feet: Feet, rows: Whole
) -> list[Part]:
    """The parts in which feet are looked for, other people's silhouettes and feet masked out.

    Strides reach out of silhouettes, and who stands behind would be drawn to the feet before him.
    Where two share a place in the picture it is the nearer one's.

    Args:
        own: (people) everybody's silhouettes. axes: (people, 2) m where everybody is.
        feet: of the hypotheses of those at the rows.
    """
    shape = judged.ramp.shape
    whose = _whose(flat, shape, own, axes)
    parts = []
    for row, left, top, right, bottom in zip(rows, *_reach(feet, shape), strict=True):
        part = np.s_[top:bottom, left:right]
        free = judged.counted[part] & ((whose[part] == 0) | (whose[part] == row + 1))
        parts.append(part_of(judged.ramp[part], free, int(left), int(top)))
    return parts


def _whose(flat: FlatView, shape: tuple[int, ...], own: Ellipses, axes: Floats) -> Numbers:
    """(height, width) 0 for nobody, else 1 + the row of who is nearest of those seen there."""
    whose = np.zeros(shape[:2], np.uint16)
    outlines = np.stack((own.polygons(_CORNERS), foot_zones(flat, axes).polygons(_CORNERS)), axis=1)
    corners = np.rint(np.clip(np.nan_to_num(outlines), -_FAR_PX, _FAR_PX)).astype(np.int32)
    far_first = np.argsort(
        -np.hypot(*(axes - np.asarray(flat.camera_position)[:2]).T), kind="stable"
    )
    for row in far_first.tolist():
        for corner, outline in zip(corners[row], outlines[row], strict=True):
            if np.isfinite(outline).all():
                cv2.fillConvexPoly(whose, corner, row + 1)
    return whose


def part_of(ramp: Picture, free: NDArray[np.bool_], left: int = 0, top: int = 0) -> Part:
    """A part of the picture.

    Args:
        ramp: (rows, columns) B times 255 there. free: (rows, columns) pixels that count.
        left, top: where it lies in the picture, px.
    """
    counted = free.astype(np.uint8)
    sums = (np.asarray(cv2.integral(one), np.int32) for one in (ramp * counted, counted))
    return Part(left, top, *sums)


def feet_scores(parts: list[Part], feet: Feet) -> Floats:
    """(people, n) -1 to 1: how much more legs are seen where they should end than below.

    What is hidden by others or out of the picture says nothing.
    """
    sums = tuple(
        np.concatenate([getattr(p, name).ravel() for p in parts]) for name in ("ramp", "area")
    )
    legs = _fill_shares(parts, sums, feet.legs, _LEGS_FULL)
    return legs - _fill_shares(parts, sums, feet.below, _BELOW_FULL)


def _fill_shares(
    parts: list[Part], sums: tuple[NDArray[np.int32], ...], strips: Strips, full: float
) -> Floats:
    """(people, n) 0 to 1, how full of foreground strips are, as far as they are in sight."""
    size = np.array([p.area.shape for p in parts])
    base = np.cumsum(size.prod(axis=1)) - size.prod(axis=1)
    left, top = (np.array([getattr(p, name) for p in parts])[:, None] for name in ("left", "top"))
    wide, base = size[:, 1:], base[:, None]
    known = np.isfinite(strips.u) & np.isfinite(strips.v)
    u, v, across, down = (np.where(known, getattr(strips, n), -1e6) for n in strips.__slots__)
    begin, end = (_ends(u + side * across - left, wide) for side in (-1, 1))
    upper, lower = (base + wide * _ends(v + side * down - top, size[:, :1]) for side in (-1, 1))
    corners = (lower + end, upper + end, lower + begin, upper + begin)
    ramp, area = (
        one[corners[0]] - one[corners[1]] - one[corners[2]] + one[corners[3]] for one in sums
    )
    in_sight = np.minimum(area / np.maximum(4.0 * np.abs(across * down), 1.0), 1.0)
    return np.asarray(in_sight * np.minimum(ramp / np.maximum(255.0 * full * area, 1.0), 1.0))


def _ends(place: Floats, size: Whole) -> Whole:
    """Columns or rows before which pixels lie whose middles are before these places."""
    return np.clip(np.ceil(place), 0, size - 1).astype(np.intp)


def _reach(feet: Feet, shape: tuple[int, ...]) -> tuple[Whole, Whole, Whole, Whole]:
    """(people,) left, top, right, bottom px of what holds all feet of each, half-open."""
    both = (feet.legs, feet.below)
    left, right = _ends_of([s.u for s in both], [s.wide for s in both], shape[1])
    top, bottom = _ends_of([s.v for s in both], [s.tall for s in both], shape[0])
    return left, top, right, bottom


def _ends_of(middles: list[Floats], halves: list[Floats], length: int) -> tuple[Whole, Whole]:
    """(people,) the first pixel along one side of the picture, and the one behind the last."""
    middle, half = np.concatenate(middles, axis=1), np.concatenate(halves, axis=1)
    low, high = np.fmin.reduce(middle - half, axis=1), np.fmax.reduce(middle + half, axis=1)
    begin = np.clip(np.nan_to_num(low), 0, length).astype(np.intp)
    end = np.ceil(np.clip(np.nan_to_num(high) + 1, 0, length)).astype(np.intp)
    return begin, np.maximum(end, begin)
