"""Draws people into the picture of one camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.synthesis.body import topology
from tracking.synthesis.cast import LEVELS, level_layout, texture_coordinates
from tracking.synthesis.raster import DepthBuffer, Samples, fill, planes
from tracking.synthesis.rig import Rig
from tracking.synthesis.specs import LampSpec

FINE = 2
"""Samples per pixel along each side."""

_TEXELS_PER_M = 210.0


@dataclass(frozen=True, slots=True, eq=False)
class PeopleSamples:
    """People as samples of one camera's picture.

    Attributes:
        person, part: (t,) row of the person and body part of each triangle drawn.
        covered: what each person covers in the window asked for, hidden or not.
        seen: the samples inside the picture that nothing hides.
        light: (s, 3) linear colour of the seen samples, blue, green, red.
    """

    person: NDArray[np.int32]
    part: NDArray[np.int8]
    covered: Samples
    seen: Samples
    light: Float32s


class Painter:
    """Draws people for one camera, in front of and behind the things that stand still."""

    def __init__(self, rig: Rig, side: int, lamp: LampSpec, still: Float32s | None) -> None:
        """A painter for a camera (0 left, 1 right).

        Args:
            rig: the cameras.
            side: which of them.
            lamp: the light's colours.
            still: inverse depth (rows, columns) of pillars at the samples, 0 elsewhere; or None.
        """
        self._rig, self._side = rig, side
        width, height = rig.size
        self._size = width * FINE, height * FINE
        self._buffer = DepthBuffer(*self._size, still)
        self._triangles, self._parts = topology()
        self._texture_place = texture_coordinates()
        self._direct = np.array(lamp.direct[::-1], np.float32)
        self._ambient = np.array(lamp.ambient[::-1], np.float32)

    def draw(
        self,
        camera_points: Floats,
        light: Float32s,
        texels: Float32s,
        people: NDArray[np.intp],
        margin: float = 0.0,
    ) -> PeopleSamples:
        """Draw bodies.

        Args:
            camera_points: (n, v, 3) vertices in left camera axes.
            light: (n, v, 2) direct and ambient light on them.
            texels: textures of the whole cast.
            people: (n,) index of each body in the cast.
            margin: how far beyond the picture `covered` goes, in picture widths.
        """
        pixels = self._rig.project(camera_points, self._side)
        corners, chosen = sample_corners(pixels, self._triangles)
        person = (chosen // len(self._triangles)).astype(np.int32)
        covered = fill(corners, self._window(margin))
        inside = self._inside(covered) if margin else covered
        seen = inside.where(self._buffer.nearest(inside))
        values = self._values(pixels, light)[chosen]
        colour = self._shade(corners, values, seen, person, pixels, people, texels)
        return PeopleSamples(
            person, self._parts[chosen % len(self._triangles)], covered, seen, colour
        )

    def _window(self, margin: float) -> tuple[int, int, int, int]:
        width, height = self._size
        x, y = int(margin * width), int(margin * height)
        return -x, -y, width + x, height + y

    def _inside(self, samples: Samples) -> Samples:
        width, height = self._size
        x, y = samples.x, samples.y
        return samples.where((x >= 0) & (x < width) & (y >= 0) & (y < height))

    def _values(self, pixels: Floats, light: Float32s) -> Float32s:
        """Texture column and row, direct and ambient light at the corners (n t, 3, 4)."""
        place = np.broadcast_to(self._texture_place, (*pixels.shape[:2], 2))
        values = np.concatenate((place, light), axis=-1)
        return np.asarray(values[:, self._triangles].reshape(-1, 3, 4), np.float32)

    def _shade(
        self,
        corners: Float32s,
        values: Float32s,
        seen: Samples,
        person: NDArray[np.int32],
        pixels: Floats,
        people: NDArray[np.intp],
        texels: Float32s,
    ) -> Float32s:
        plane = planes(corners, values)[seen.triangle]
        x, y = seen.x.astype(np.float32), seen.y.astype(np.float32)
        value = plane[:, 0] * x[:, None] + plane[:, 1] * y[:, None] + plane[:, 2]
        first, stride, level = self._levels(pixels, people)
        row = person[seen.triangle]
        place = np.maximum(value[:, :2], 0.0).astype(np.int32) >> level[row][:, None]
        colour = texels[first[row] + place[:, 1] * stride[row] + place[:, 0]]
        bright = value[:, 2:3] * self._direct + value[:, 3:4] * self._ambient
        return np.asarray(colour * bright, np.float32)

    def _levels(
        self, pixels: Floats, people: NDArray[np.intp]
    ) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.int32]]:
        """First texel, row length and size of the texture to use for each person."""
        starts, strides, texels = level_layout()
        samples_per_m = np.nanmax(pixels[..., 2], axis=1, initial=1e-3) * self._rig.focal_px * FINE
        level = np.floor(np.log2(_TEXELS_PER_M / np.maximum(samples_per_m, 1.0)) + 0.5)
        level = np.clip(level, 0, LEVELS - 1).astype(np.int32)
        return (people * texels + starts[level]).astype(np.int32), strides[level], level


def sample_corners(
    pixels: Floats, triangles: NDArray[np.int32]
) -> tuple[Float32s, NDArray[np.intp]]:
    """Corners (t, 3, 3) in samples of the triangles seen from their front, and which they are.

    Args:
        pixels: (n, v, 3) u, v, inverse depth of the vertices of n equal bodies.
        triangles: (k, 3) of one body's vertices; the result counts n times k of them.
    """
    fine = pixels.astype(np.float32)
    # Samples lie at whole numbers: pixel 0 has samples 0 and 1 at -1/4 and +1/4.
    fine[..., :2] = fine[..., :2] * FINE + (FINE - 1) / 2
    corners = fine[:, triangles].reshape(-1, 3, 3)
    e1, e2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    # Not a number, behind the camera: compares as false.
    chosen = np.flatnonzero(e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0] < 0)
    return corners[chosen], chosen


def composite(light: Float32s, drawn: PeopleSamples) -> None:
    """Lay the drawn samples over a background (height, width, 3), in place."""
    height, width = light.shape[:2]
    place = (drawn.seen.y // FINE) * width + drawn.seen.x // FINE
    share = np.float32(1.0 / FINE**2)
    flat = light.reshape(-1, 3)
    count = np.bincount(place, minlength=height * width)
    touched = np.flatnonzero(count)
    flat[touched] *= 1.0 - count[touched, None].astype(np.float32) * share
    for channel in range(3):
        total = np.bincount(place, drawn.light[:, channel], minlength=height * width)
        flat[touched, channel] += total[touched].astype(np.float32) * share
