"""Surfaces of bodies: tubes of elliptic rings, the same number of rings for everybody."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Rings:
    """The rings of one tube, of n people: ring k of r goes round an axis.

    Attributes:
        centre: (n, r, 3) world metres.
        axis: (n, r, 3) unit vectors from the first ring to the last.
        side: (n, r or 1, 3) direction of the width, made square to the axis here.
        width, depth: (n, r) half axes in metres.
    """

    centre: Floats
    axis: Floats
    side: Floats
    width: Floats
    depth: Floats


@dataclass(frozen=True, slots=True, eq=False)
class TubeShape:
    """What is the same for everybody's tube.

    Attributes:
        name: of the body part.
        rings, segments: how finely it is cut.
        squareness: exponent of the rings' outline; 2 is an ellipse, more is boxier.
        patch: name of the area of the clothing texture laid on it.
        parts: (rings - 1,) 0 head, 1 torso, 2 hip-leg, of each band between rings.
    """

    name: str
    rings: int
    segments: int
    squareness: float
    patch: str
    parts: tuple[int, ...]

    @property
    def vertices(self) -> int:
        """Number of vertices; the seam's are there twice, for the texture."""
        return self.rings * (self.segments + 1)

    def triangles(self) -> NDArray[np.int32]:
        """(t, 3) vertices, outward sides counter-clockwise as seen from outside."""
        columns = self.segments + 1
        ring, column = np.mgrid[: self.rings - 1, : self.segments]
        corner = (ring * columns + column).ravel()
        upper = np.column_stack((corner, corner + 1, corner + columns))
        lower = np.column_stack((corner + 1, corner + columns + 1, corner + columns))
        return np.stack((upper, lower), axis=1).reshape(-1, 3).astype(np.int32)

    def triangle_parts(self) -> NDArray[np.int8]:
        """(t,) body part of each triangle."""
        return np.repeat(np.array(self.parts, np.int8), 2 * self.segments)

    def outline(self) -> tuple[Floats, Floats]:
        """Shares of width and depth round a ring (segments + 1,), from behind over the left."""
        angle = -np.pi / 2 + np.linspace(0.0, 2 * np.pi, self.segments + 1)
        power = 2.0 / self.squareness
        cos, sin = np.cos(angle), np.sin(angle)
        return np.sign(cos) * np.abs(cos) ** power, np.sign(sin) * np.abs(sin) ** power


def surface(shape: TubeShape, rings: Rings) -> tuple[Floats, Floats]:
    """Vertices and outward unit normals (n, v, 3) of a tube."""
    side = rings.side - (rings.side * rings.axis).sum(-1, keepdims=True) * rings.axis
    side = side / np.maximum(np.linalg.norm(side, axis=-1, keepdims=True), 1e-9)
    front = np.cross(rings.axis, side)
    across, ahead = shape.outline()
    offset = (
        across[:, None] * (side * rings.width[..., None])[:, :, None]
        + ahead[:, None] * (front * rings.depth[..., None])[:, :, None]
    )
    grid = rings.centre[:, :, None] + offset
    normals = _normals(grid)
    flat = len(grid), shape.vertices, 3
    return grid.reshape(flat), normals.reshape(flat)


def _normals(grid: Floats) -> Floats:
    """Outward unit normals of a grid of vertices (n, rings, columns, 3), closed round."""
    before = np.concatenate((grid[:, :, -2:-1], grid[:, :, :-1]), axis=2)
    after = np.concatenate((grid[:, :, 1:], grid[:, :, 1:2]), axis=2)
    along = np.gradient(grid, axis=1)
    normal = np.cross(after - before, along)
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12))


def directions(centre: Floats) -> Floats:
    """Unit vectors (n, r, 3) along a line of centres (n, r, 3)."""
    along = np.gradient(centre, axis=1)
    return np.asarray(along / np.maximum(np.linalg.norm(along, axis=-1, keepdims=True), 1e-9))
