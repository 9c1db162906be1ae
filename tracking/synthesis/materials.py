"""Floors and walls as colours of points on them."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.synthesis.patterns import noise
from tracking.synthesis.specs import SceneSpec

_NOISE_SIZE = 512
_LOOK_UP_COLUMNS = 1024
_JOINT_M = 0.006
_CORNER_M = 0.45  # how far a wall darkens the floor before it


class Floor:
    """The floor's colour: tiles with joints, grain, stains and uneven light."""

    def __init__(self, spec: SceneSpec, seed: int) -> None:
        """The floor of a scene; equal seeds lay equal floors."""
        rng = np.random.default_rng((seed, 11))
        self._spec, self._floor = spec, spec.floor
        self._fine = _wrapping_noise((2.0, 2.0), rng)
        self._blotches = _wrapping_noise((24.0, 24.0), rng)
        self._tile_shades = rng.normal(0.0, 1.0, (61, 67)).astype(np.float32)
        self._tint = rng.normal(0.0, 0.012, (61, 67, 3)).astype(np.float32)

    def colour(self, points: Floats) -> Float32s:
        """Linear light (rows, columns, 3), blue, green, red, of points (rows, columns, 2)."""
        floor = self._floor
        grain = _look_up(self._fine, points, 0.004) + 0.7 * _look_up(self._fine, points, 0.017)
        stains = _look_up(self._blotches, points, 0.012) + _look_up(self._blotches, points, 0.045)
        shade = 1.0 + floor.grain * (0.45 * grain + 0.30 * stains)
        tint = np.zeros(3, np.float32)
        if floor.tile_m[0] > 0:
            tile_shade, tint, joint = self._tiles(points)
            shade = (shade + tile_shade) * joint
        else:
            shade = 1.0 + floor.grain * (0.7 * grain + 0.12 * stains)
            shade = shade + 1.6 * _painted_lines(points) * (0.9 + 0.1 * stains)
        # Light never falls evenly, and walls keep some of it off.
        shade = shade * (1.0 + 0.05 * _look_up(self._blotches, points, 0.16))
        shade = shade * self._before_walls(points)
        base = np.array(floor.colour, np.float32) * (1.0 + tint)
        return np.clip(base[..., ::-1] * shade[..., None], 0.0, 1.0).astype(np.float32)

    def _tiles(self, points: Floats) -> tuple[Float32s, Float32s, Float32s]:
        """Brightness added by each tile, its tint, and the joints' darkness."""
        wide, deep = self._floor.tile_m
        row = points[..., 1] / deep
        column = points[..., 0] / wide
        if self._floor.staggered:
            column = column + 0.5 * (np.floor(row) % 2)
        i = np.floor(row).astype(int) % self._tile_shades.shape[0]
        j = np.floor(column).astype(int) % self._tile_shades.shape[1]
        edge_x = np.abs((column + 0.5) % 1.0 - 0.5) * wide
        edge_y = np.abs((row + 0.5) % 1.0 - 0.5) * deep
        gap = np.minimum(edge_x, edge_y)
        joint = 1.0 - 0.42 * np.exp(-((gap / _JOINT_M) ** 2)) - 0.05 * np.exp(-gap / 0.03)
        shade = self._floor.variation * self._tile_shades[i, j]
        return shade, self._tint[i, j], joint.astype(np.float32)

    def _before_walls(self, points: Floats) -> Float32s:
        shade = np.ones(points.shape[:-1], np.float32)
        for wall in self._spec.walls:
            axis = 0 if wall.axis == "x" else 1
            beyond = points[..., 1 - axis] - np.clip(points[..., 1 - axis], *wall.span_m)
            gap = np.hypot(points[..., axis] - wall.place_m, beyond)
            shade *= (1.0 - 0.30 * np.exp(-gap / _CORNER_M)).astype(np.float32)
        return shade


def _painted_lines(points: Floats) -> Float32s:
    """1 where the asphalt is painted: two lines along the way and bars across it."""
    x, y = points[..., 0], points[..., 1]
    lines = np.abs(np.abs(x - 0.4) - 3.6) < 0.06
    bars = (np.abs(x - 0.4) < 3.2) & (np.abs(y - 9.0) < 1.3) & (x % 1.0 < 0.45)
    return (lines | bars).astype(np.float32)


def wall_colour(kind: str, along: Floats, height: Floats, seed: int) -> Float32s:
    """Linear light (n, 3), blue, green, red, of points on a wall."""
    rng = np.random.default_rng((seed, 13))
    texture = _wrapping_noise((3.0, 3.0), rng)
    points = np.stack((along, height), axis=-1)
    rough = _look_up(texture, points, 0.01) + _look_up(texture, points, 0.11)
    paint = _brick(along, height, rng) if kind == "brick" else _plaster(along, height)
    shade = (1.0 + 0.035 * rough) * (1.0 - 0.25 * np.exp(-np.maximum(height, 0) / 0.3))
    return np.asarray(np.clip(paint[:, ::-1] * shade[:, None], 0, 1), np.float32)


def _plaster(along: Floats, height: Floats) -> Float32s:
    """A painted wall with a darker dado, a skirting board, doors and notice boards."""
    paint = np.where((height < 1.05)[:, None], (0.47, 0.46, 0.41), (0.66, 0.64, 0.58))
    _mark(paint, np.abs(height - 1.05) < 0.035, (0.30, 0.27, 0.22))
    place = (along + 1.9) % 4.6
    door = (place < 0.95) & (height < 2.05)
    _mark(paint, (place < 1.05) & (height < 2.12), (0.22, 0.19, 0.15))
    _mark(paint, door, (0.33, 0.22, 0.13))
    _mark(paint, door & (np.abs(place - 0.475) < 0.007), (0.12, 0.08, 0.05))
    _mark(paint, door & (np.abs(place - 0.80) < 0.03) & (np.abs(height - 1.03) < 0.06), (0.6,) * 3)
    board = (np.abs(place - 2.8) < 0.55) & (np.abs(height - 1.45) < 0.32)
    _mark(paint, board, (0.16, 0.24, 0.30))
    _mark(paint, (height < 0.11) & ~door, (0.10, 0.10, 0.11))
    return paint.astype(np.float32)


def _brick(along: Floats, height: Floats, rng: np.random.Generator) -> Float32s:
    """A brick front with a plinth, doors and windows."""
    row = np.floor(height / 0.075)
    column = along / 0.25 + 0.5 * (row % 2)
    shades = rng.normal(1.0, 0.12, 997)
    shade = shades[(np.floor(column) * 31 + row * 57).astype(int) % 997]
    paint = np.array((0.30, 0.155, 0.11)) * shade[:, None]
    mortar = ((column % 1.0) * 0.25 < 0.012) | ((height / 0.075 % 1.0) * 0.075 < 0.012)
    _mark(paint, mortar, (0.36, 0.33, 0.29))
    _mark(paint, height < 0.5, (0.25, 0.25, 0.24))
    place = along % 4.0
    _mark(paint, (place < 1.7) & (height > 0.85) & (height < 2.4), (0.50, 0.49, 0.46))
    _mark(
        paint, (place > 0.1) & (place < 1.6) & (height > 0.95) & (height < 2.3), (0.09, 0.12, 0.15)
    )
    _mark(paint, (np.abs(place - 3.0) < 0.55) & (height < 2.3), (0.10, 0.17, 0.13))
    return np.asarray(paint, np.float32)


def _mark(paint: Floats, where: NDArray[np.bool_], colour: tuple[float, ...]) -> None:
    paint[where] = colour


def _wrapping_noise(cell: tuple[float, float], rng: np.random.Generator) -> Float32s:
    """Noise that continues beyond all four edges."""
    more = _NOISE_SIZE // 8
    image = noise((_NOISE_SIZE + more, _NOISE_SIZE), cell, rng)
    ramp = np.linspace(0, 1, more, dtype=np.float32)[:, None]
    image[:more] = image[:more] * ramp + image[_NOISE_SIZE:] * (1 - ramp)
    return image[:_NOISE_SIZE].copy()


def _look_up(texture: Float32s, points: Floats, texel_m: float) -> Float32s:
    """Smoothly interpolated texture at points (..., 2) in metres."""
    place = ((points / texel_m) % _NOISE_SIZE).astype(np.float32).reshape(-1, 2)
    # OpenCV looks up images only so wide.
    rows = -(-len(place) // _LOOK_UP_COLUMNS)
    x, y = np.zeros((2, rows * _LOOK_UP_COLUMNS), np.float32)
    x[: len(place)], y[: len(place)] = place.T
    shape = rows, _LOOK_UP_COLUMNS
    found = cv2.remap(
        texture, x.reshape(shape), y.reshape(shape), cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP
    )
    return np.asarray(found.ravel()[: len(place)].reshape(points.shape[:-1]), np.float32)
