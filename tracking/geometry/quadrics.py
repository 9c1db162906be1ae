"""Ellipsoids that stand on the floor, as a pinhole camera shows them.

An ellipsoid in the world is a dual quadric `Q*`, the planes that touch it; a camera with the 3 x 4
matrix `P` shows it as the dual conic `C* = P Q* P^T`, the lines that touch its outline (Hartley and
Zisserman, result 8.9). The outline is an ellipse as long as all of the ellipsoid lies in front of
the camera; its centre, its highest and lowest line, and where each line enters and leaves it are
read off `C*` without inverting anything.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Ellipses:
    """Outlines in a flat picture: all x with (x - c)^T S^-1 (x - c) <= 1, of any batch shape.

    Attributes:
        u, v: centres, px. uu, uv, vv: S, px²; NaN all five where there is no ellipse.
    """

    u: Floats
    v: Floats
    uu: Floats
    uv: Floats
    vv: Floats

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the batch."""
        return self.u.shape

    def __getitem__(self, rows: object) -> Ellipses:
        """Some of them."""
        return Ellipses(*(getattr(self, name)[rows] for name in self.__slots__))

    def rows(self) -> tuple[Floats, Floats]:
        """The highest and the lowest line of each, px."""
        half = np.sqrt(self.vv)
        return self.v - half, self.v + half

    def columns(self) -> tuple[Floats, Floats]:
        """The leftmost and the rightmost column of each, px."""
        half = np.sqrt(self.uu)
        return self.u - half, self.u + half

    def ends(self, lines: Floats) -> tuple[Floats, Floats]:
        """Where image lines enter and leave the outlines, px; NaN where they miss.

        Args:
            lines: (..., k) v of lines, one axis more than the ellipses.
        """
        down = lines - self.v[..., None]
        inside = 1.0 - down**2 / self.vv[..., None]
        middle = self.u[..., None] + (self.uv / self.vv)[..., None] * down
        wide = np.maximum(self.uu - self.uv**2 / self.vv, 0.0)[..., None]
        half = np.sqrt(np.where(inside >= 0, inside * wide, np.nan))
        return middle - half, middle + half

    def areas(self) -> Floats:
        """Px² of each."""
        return np.asarray(np.pi * np.sqrt(np.maximum(self.uu * self.vv - self.uv**2, 0.0)))

    def polygons(self, points: int = 32) -> Floats:
        """(..., points, 2) px along each outline."""
        angle = np.arange(points) * (2 * np.pi / points)
        # S = L L^T with L lower triangular carries the unit circle onto the outline.
        along = np.sqrt(self.vv)[..., None]
        lean = self.uv[..., None] / along
        wide = np.sqrt(np.maximum(self.uu[..., None] - lean**2, 0.0))
        u = self.u[..., None] + lean * np.sin(angle) + wide * np.cos(angle)
        return np.stack((u, self.v[..., None] + along * np.sin(angle)), axis=-1)


def ellipses_of(projection: Floats, centre: Floats, axes: Floats) -> Ellipses:
    """The outlines of ellipsoids whose axes lie along the world's.

    Args:
        projection: (3, 4) px of a flat picture, homogeneous, from metres; its third row gives the
            depth.
        centre: (..., 3) m. axes: (..., 3) semi-axes along x, y, z in m, batch as the centres'.

    Returns:
        NaN for an ellipsoid that is not wholly in front of the camera: it reaches behind it, or the
        camera is inside. Its outline would be no ellipse, and nobody's body is seen so.
    """
    turned = projection[:, :3]
    squared = axes**2
    seen = centre @ turned.T + projection[:, 3]
    spread = {
        (i, k): squared @ (turned[i] * turned[k]) - seen[..., i] * seen[..., k]
        for i, k in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))
    }
    in_front = (spread[2, 2] < 0) & (seen[..., 2] > 0)
    scale = np.where(in_front, spread[2, 2], np.nan)
    u, v = spread[0, 2] / scale, spread[1, 2] / scale
    uu, uv, vv = (spread[key] / scale for key in ((0, 0), (0, 1), (1, 1)))
    return Ellipses(u, v, u * u - uu, u * v - uv, v * v - vv)


def standing_ellipses(
    projection: Floats, xy: Floats, height_m: Floats, radius_m: Floats | float, scale: float = 1.0
) -> Ellipses:
    """The outlines of spheroids that stand on the floor, their south poles at z = 0.

    [Waechter2013] 3.2.1: semi-axes 0.9, 0.25, 0.25 m with the centre at 0.9 m, a person of 1.8 m.

    Args:
        projection: of `ellipses_of`.
        xy: (..., 2) m on the floor. height_m: (...) of the bodies. radius_m: minor semi-axes.
        scale: all semi-axes times this, still on the floor: the region of evaluation.
    """
    half = np.broadcast_to(np.asarray(height_m, float) * (0.5 * scale), xy.shape[:-1])
    wide = np.broadcast_to(np.asarray(radius_m, float) * scale, xy.shape[:-1])
    centre = np.concatenate((xy, half[..., None]), axis=-1)
    return ellipses_of(projection, centre, np.stack((wide, wide, half), axis=-1))
