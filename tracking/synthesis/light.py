"""Lamp light: shadows on the floor and on people, and the brightness of surfaces."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.arrays import Float32s, Floats
from tracking.synthesis.raster import DepthBuffer, fill
from tracking.synthesis.rig import Rig
from tracking.synthesis.specs import LampSpec

_FARTHEST_M = 19.0
_CELL_SHARE = 1 / 700  # size of a shadow cell as a share of the floor in view
_FINEST_M = 0.012
_BIAS_M = 0.06  # a surface does not shade itself
_PENUMBRA_M = 0.09
_CONTACT_M = 0.13
_CONTACT = 0.5  # share of the ambient light taken between shoe and floor
_WRAP = 0.2  # light scattered round edges
_BOUNCE = 0.16  # share of the light that comes back from the floor


@dataclass(frozen=True, slots=True, eq=False)
class FloorShade:
    """What reaches the floor, over the cells of `FloorShadows`.

    Attributes:
        factor: (rows, columns, 3) light left on the floor, 0..1, blue, green, red.
        height_m: (rows, columns) the highest thing on the lamp's ray to a cell; 0: none.
    """

    factor: Float32s
    height_m: Float32s


class FloorShadows:
    """Casts shadows along the lamp's rays onto a grid on the floor."""

    def __init__(self, rig: Rig, lamp: LampSpec) -> None:
        """A grid over what the rig sees of the floor."""
        seen = rig.view.field_of_view(_FARTHEST_M)
        low, high = seen.min(axis=0) - 0.6, seen.max(axis=0) + 0.6
        self._cell_m = max(float((high - low).max()) * _CELL_SHARE, _FINEST_M)
        self._low = low
        columns, rows = np.ceil((high - low) / self._cell_m).astype(int)
        self._size = int(columns), int(rows)
        self._buffer = DepthBuffer(*self._size)
        towards = np.array(lamp.towards) / np.linalg.norm(lamp.towards)
        self._slant = -towards[:2] / towards[2]
        self._to_lamp = -towards
        self._lamp = lamp
        self._pixels = [rig.floor_to_pixel(camera) @ self._floor_from_cell() for camera in (0, 1)]
        self._image_size = rig.size

    def cast(self, corners: Floats, feet: Floats) -> FloorShade:
        """The shade of triangles.

        Args:
            corners: (t, 3, 3) world corners of outward, counter-clockwise triangles.
            feet: (k, 2) world x, y of feet, which darken the floor under them.
        """
        cells = np.concatenate(
            (self._cells(corners), np.maximum(corners[..., 2:], 0.0) + 0.01), axis=-1
        ).astype(np.float32)
        e1, e2 = cells[:, 1] - cells[:, 0], cells[:, 2] - cells[:, 0]
        lit = e1[:, 0] * e2[:, 1] > e1[:, 1] * e2[:, 0]
        self._buffer.nearest(fill(cells[lit], (0, 0, *self._size)))
        height = self._buffer.depth()
        return FloorShade(self._factor(height, feet), height)

    def seen_by(self, shade: FloorShade, camera: int) -> Float32s:
        """The light left on the floor as a camera sees it, (height, width, 3)."""
        return np.asarray(
            cv2.warpPerspective(
                shade.factor,
                self._pixels[camera],
                self._image_size,
                flags=cv2.INTER_LINEAR,
                borderMode=cv2.BORDER_CONSTANT,
                borderValue=(1.0, 1.0, 1.0),
            ),
            np.float32,
        )

    def light_on(self, points: Floats, normals: Floats, shade: FloorShade) -> Float32s:
        """Direct and ambient light (..., 2) on surface points (..., 3) with unit normals."""
        cells = np.rint(self._cells(points)).astype(int)
        columns, rows = self._size
        x, y = np.clip(cells[..., 0], 0, columns - 1), np.clip(cells[..., 1], 0, rows - 1)
        inside = (x == cells[..., 0]) & (y == cells[..., 1])
        above = np.where(inside, shade.height_m[y, x], 0.0) - points[..., 2]
        lit = np.clip(1.0 - (above - _BIAS_M) / _PENUMBRA_M, 0.0, 1.0)
        facing = (normals @ self._to_lamp + _WRAP) / (1.0 + _WRAP)
        direct = np.clip(facing, 0.0, None) * lit * 1.15
        up = normals[..., 2]
        ambient = 0.74 + 0.26 * up + _BOUNCE * (1.0 - up) / 2
        # Less of the sky is seen low between other people and on the legs.
        ambient = ambient * (0.80 + 0.20 * np.clip(points[..., 2] / 1.0, 0.0, 1.0))
        return np.stack((direct, ambient), axis=-1).astype(np.float32)

    def _cells(self, points: Floats) -> Floats:
        """Grid coordinates (..., 2) of where the lamp's rays through points meet the floor."""
        floor = points[..., :2] + points[..., 2:] * self._slant
        return np.asarray((floor - self._low) / self._cell_m)

    def _floor_from_cell(self) -> Floats:
        return np.array(
            [[self._cell_m, 0.0, self._low[0]], [0.0, self._cell_m, self._low[1]], [0.0, 0.0, 1.0]]
        )

    def _factor(self, height: Float32s, feet: Floats) -> Float32s:
        """Light left in each cell (rows, columns, 3); high things cast softer shadows."""
        mask = (height > 0).astype(np.float32)
        wide = self._lamp.softness_m / self._cell_m
        near = cv2.GaussianBlur(mask, (0, 0), max(0.25 * wide, 0.6))
        far = _soft(mask, wide)
        tall = _soft(height, wide) / np.maximum(far, 1e-3)
        share = np.clip(tall / 1.5, 0.0, 1.0)
        shadow = near + (far - near) * share
        contact = self._contact(feet)
        colours = zip(self._lamp.direct[::-1], self._lamp.ambient[::-1], strict=True)
        channels = [
            cv2.addWeighted(shadow, -direct / (direct + ambient), contact, -_CONTACT * ambient, 1.0)
            for direct, ambient in colours
        ]
        return np.asarray(cv2.merge(channels), np.float32)

    def _contact(self, feet: Floats) -> Float32s:
        """Darkness 0..1 of the floor close to feet."""
        columns, rows = self._size
        contact = np.zeros((rows, columns), np.float32)
        reach = max(round(3 * _CONTACT_M / self._cell_m), 1)
        for column, row in (feet - self._low) / self._cell_m:
            x0, x1 = max(int(column) - reach, 0), min(int(column) + reach + 1, columns)
            y0, y1 = max(int(row) - reach, 0), min(int(row) + reach + 1, rows)
            if x0 >= x1 or y0 >= y1:
                continue
            x, y = np.arange(x0, x1) - column, np.arange(y0, y1)[:, None] - row
            blob = np.exp(-(x**2 + y**2) * (self._cell_m / _CONTACT_M) ** 2)
            area = contact[y0:y1, x0:x1]
            np.maximum(area, blob, out=area)
        return contact


def _soft(image: Float32s, sigma: float) -> Float32s:
    """Nearly a Gaussian blur, by two fast box blurs."""
    side = max(2 * round(sigma * 1.2) + 1, 3)
    once = cv2.blur(image, (side, side))
    return np.asarray(cv2.blur(once, (side, side)), np.float32)
