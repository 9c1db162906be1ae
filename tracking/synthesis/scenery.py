"""What stands still: floor, walls and pillars, drawn once for each camera."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.arrays import Float32s, Floats
from tracking.synthesis.materials import Floor, wall_colour
from tracking.synthesis.rig import NEAREST_M, Rig
from tracking.synthesis.specs import SceneSpec, WallSpec

_OVERSAMPLING = 3
_FARTHEST_M = 60.0


@dataclass(frozen=True, slots=True, eq=False)
class Backdrop:
    """The unlit-by-people background of one camera.

    Attributes:
        light: (height, width, 3) linear, blue, green, red.
        floor: (height, width, 1) share of the pixel that is floor.
    """

    light: Float32s
    floor: Float32s

    def split(self) -> tuple[Float32s, Float32s]:
        """The light from the floor, which shadows fall on, and from all else."""
        floor = self.light * self.floor
        return floor, self.light - floor


def backdrop(spec: SceneSpec, rig: Rig, side: int, seed: int) -> Backdrop:
    """The floor and walls as a camera sees them, smoothed over the pixel."""
    width, height = rig.size
    floor = Floor(spec, seed)
    light = np.empty((height, width, 3), np.float32)
    share = np.empty((height, width, 1), np.float32)
    rows_at_once = max(1, 65536 // width)
    for top in range(0, height, rows_at_once):
        rows = min(rows_at_once, height - top)
        fine_light, fine_floor = _band(spec, rig, side, floor, (top, rows), seed)
        light[top : top + rows] = cv2.resize(
            fine_light, (width, rows), interpolation=cv2.INTER_AREA
        )
        share[top : top + rows, :, 0] = cv2.resize(
            fine_floor, (width, rows), interpolation=cv2.INTER_AREA
        )
    return Backdrop(light, share)


def _band(
    spec: SceneSpec, rig: Rig, side: int, floor: Floor, band: tuple[int, int], seed: int
) -> tuple[Float32s, Float32s]:
    """Colour and floor mask of some rows, at several samples a pixel."""
    width, _ = rig.size
    top, rows = band
    step = 1.0 / _OVERSAMPLING
    u = (np.arange(width * _OVERSAMPLING) + 0.5) * step - 0.5
    v = (np.arange(rows * _OVERSAMPLING) + 0.5) * step - 0.5 + top
    rays = rig.rays(np.stack(np.meshgrid(u, v), axis=-1))
    centre = rig.camera_centre(side)
    with np.errstate(divide="ignore"):
        nearest = np.where(rays[..., 2] < 0, -centre[2] / rays[..., 2], np.inf)
    nearest = np.minimum(nearest, _FARTHEST_M / np.maximum(rays[..., 1], 0.1))
    colour = floor.colour((centre + rays * nearest[..., None])[..., :2])
    is_floor = np.ones(nearest.shape, np.float32)
    for index, wall in enumerate(spec.walls):
        away = _distance(wall, centre, rays)
        hit = away < nearest
        if hit.any():
            points = centre + rays[hit] * away[hit][:, None]
            along = points[:, 0 if wall.axis == "y" else 1]
            colour[hit] = wall_colour(wall.kind, along, points[:, 2], seed + index)
            is_floor[hit] = 0.0
            nearest = np.where(hit, away, nearest)
    return colour, is_floor


def inverse_depth(spec: SceneSpec, rig: Rig, side: int, samples: int) -> Float32s | None:
    """Inverse depth of walls that people can be behind; None without such walls.

    Args:
        spec, rig, side: whose walls, and who looks.
        samples: per pixel along each side.

    Returns:
        (height samples, width samples); 0 where no such wall is.
    """
    walls = [wall for wall in spec.walls if wall.ends]
    if not walls:
        return None
    width, height = rig.size
    u = (np.arange(width * samples) - (samples - 1) / 2) / samples
    v = (np.arange(height * samples) - (samples - 1) / 2) / samples
    rays = rig.rays(np.stack(np.meshgrid(u, v), axis=-1))
    away = [_distance(wall, rig.camera_centre(side), rays) for wall in walls]
    # Rays are one long along the optical axis: what they are multiplied by is depth.
    return np.asarray(1.0 / np.minimum.reduce(away), np.float32)


def depth_of_scenery(spec: SceneSpec, rig: Rig) -> Float32s:
    """(height, width) m along the left camera's optical axis of floor and walls."""
    width, height = rig.size
    rays = rig.rays(np.stack(np.meshgrid(np.arange(width), np.arange(height)), axis=-1))
    centre = rig.camera_centre(0)
    with np.errstate(divide="ignore"):
        nearest = np.where(rays[..., 2] < 0, -centre[2] / rays[..., 2], np.inf)
    nearest = np.minimum(nearest, _FARTHEST_M / np.maximum(rays[..., 1], 0.1))
    away = [_distance(wall, centre, rays) for wall in spec.walls]
    return np.asarray(np.minimum.reduce([nearest, *away]), np.float32)


def _distance(wall: WallSpec, centre: Floats, rays: Floats) -> Floats:
    """How many ray lengths away a wall is; infinite where it is not met."""
    axis = 0 if wall.axis == "x" else 1
    ray = rays[..., axis]
    along = np.where(np.abs(ray) > 1e-9, ray, 1e-9)
    away = np.asarray((wall.place_m - centre[axis]) / along)
    met = away > NEAREST_M
    if wall.ends:
        place = centre[1 - axis] + away * rays[..., 1 - axis]
        met &= (place > wall.span_m[0]) & (place < wall.span_m[1])
    return np.where(met, away, np.inf)
