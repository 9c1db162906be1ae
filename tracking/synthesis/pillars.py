"""Round pillars that hide people and throw shadows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.synthesis.painter import FINE, sample_corners
from tracking.synthesis.patterns import noise
from tracking.synthesis.raster import DepthBuffer, Samples, fill, planes
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenery import Backdrop
from tracking.synthesis.specs import LampSpec, SceneSpec
from tracking.synthesis.tubes import Rings, TubeShape, surface

_HEIGHT_M = 3.6
_BASE_M = 0.35
_SHAPE = TubeShape("pillar", 12, 40, 2.0, "", (0,) * 11)
_PAINT = (0.60, 0.57, 0.51)
_BASE = (0.28, 0.27, 0.26)
_TEXTURE = (128, 256)


@dataclass(frozen=True, slots=True, eq=False)
class Pillars:
    """All pillars of a scene as surfaces.

    Attributes:
        vertices, normals: (n, v, 3) world metres and outward unit vectors.
        triangles: (t, 3) of one pillar's vertices.
    """

    vertices: Floats
    normals: Floats
    triangles: NDArray[np.int32]

    @classmethod
    def of_scene(cls, spec: SceneSpec) -> Pillars:
        """The pillars of a scene; none is fine."""
        places = np.array(spec.pillars_m).reshape(-1, 3)
        heights = np.concatenate(([_HEIGHT_M], np.linspace(_HEIGHT_M, 0.0, _SHAPE.rings - 1)))
        centre = np.zeros((len(places), _SHAPE.rings, 3))
        centre[..., :2] = places[:, None, :2]
        centre[..., 2] = heights
        radius = np.repeat(places[:, 2:], _SHAPE.rings, axis=1)
        radius[:, 0] = 1e-3
        axis = np.broadcast_to([0.0, 0.0, -1.0], centre.shape)
        side = np.broadcast_to([-1.0, 0.0, 0.0], centre.shape)
        vertices, normals = surface(_SHAPE, Rings(centre, axis, side, radius, radius))
        return cls(vertices, normals, _SHAPE.triangles())

    def __len__(self) -> int:
        """How many there are."""
        return len(self.vertices)

    def corners(self) -> Floats:
        """Corners (t, 3, 3) of all triangles in world metres."""
        return self.vertices[:, self.triangles].reshape(-1, 3, 3)

    def draw(
        self, rig: Rig, camera: int, lamp: LampSpec, light: Float32s, behind: Backdrop
    ) -> Float32s:
        """Draw the pillars over a backdrop, in place.

        Args:
            rig: the cameras.
            camera: which of them.
            lamp: the light's colours.
            light: (n, v, 2) direct and ambient light on the vertices.
            behind: the camera's backdrop.

        Returns:
            Their inverse depth at each sample (rows, columns); 0 elsewhere.
        """
        width, height = rig.size
        buffer = DepthBuffer(width * FINE, height * FINE)
        pixels = rig.project(rig.left_camera_points(self.vertices), camera)
        corners, chosen = sample_corners(pixels, self.triangles)
        samples = fill(corners, (0, 0, buffer.width, buffer.height))
        seen = samples.where(buffer.nearest(samples))
        values = np.concatenate((light, self._texture_places()), axis=-1)
        values = values[:, self.triangles].reshape(-1, 3, 4)[chosen]
        _lay_over(behind, seen, _colours(planes(corners, values), seen, lamp))
        return buffer.depth()

    def _texture_places(self) -> Float32s:
        """Column and height in metres (n, v, 2) of the vertices."""
        around = np.tile(np.linspace(0, _TEXTURE[1] - 1, _SHAPE.segments + 1), _SHAPE.rings)
        columns = np.broadcast_to(around, self.vertices.shape[:2])
        return np.stack((columns, self.vertices[..., 2]), axis=-1).astype(np.float32)


def _colours(plane: Float32s, seen: Samples, lamp: LampSpec) -> Float32s:
    """Linear colours (s, 3), blue, green, red, of samples."""
    plane = plane[seen.triangle]
    value = plane[:, 0] * seen.x[:, None] + plane[:, 1] * seen.y[:, None] + plane[:, 2]
    rough = noise(_TEXTURE, (2.0, 2.0), np.random.default_rng(17))
    row = np.clip(value[:, 3] / _HEIGHT_M * (_TEXTURE[0] - 1), 0, _TEXTURE[0] - 1).astype(int)
    column = np.clip(value[:, 2], 0, _TEXTURE[1] - 1).astype(int)
    paint = np.where(value[:, 3:] < _BASE_M, _BASE[::-1], _PAINT[::-1])
    paint = paint * (1.0 + 0.04 * rough[row, column])[:, None]
    bright = value[:, :1] * np.array(lamp.direct[::-1]) + value[:, 1:2] * np.array(
        lamp.ambient[::-1]
    )
    return np.asarray(paint * bright, np.float32)


def _lay_over(behind: Backdrop, seen: Samples, colour: Float32s) -> None:
    """Blend samples into a backdrop; what they cover is no floor any more."""
    height, width = behind.light.shape[:2]
    place = (seen.y // FINE) * width + seen.x // FINE
    share = np.bincount(place, minlength=height * width) / FINE**2
    left = (1.0 - share).reshape(height, width, 1)
    behind.light[...] *= left
    behind.floor[...] *= left
    for channel in range(3):
        total = np.bincount(place, colour[:, channel], minlength=height * width) / FINE**2
        behind.light[..., channel] += total.reshape(height, width)
