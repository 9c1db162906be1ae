"""The left camera without its lens: a picture in which straight lines are straight."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.geometry.view import View

_WIDEST = 1.35
"""Largest flat picture, in sizes of the recorded one: corners of wide lenses reach far out."""
_BORDER_POINTS = 48
_COVERED = 128


@dataclass(frozen=True, slots=True, eq=False)
class _Map:
    """Where each flat pixel comes from, in OpenCV's fast fixed-point form."""

    whole: NDArray[np.int16]
    fraction: NDArray[np.uint16]

    def apply(self, picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        seen = cv2.remap(picture, self.whole, self.fraction, cv2.INTER_LINEAR)
        return np.asarray(seen, np.uint8)


class FlatView:
    """An ideal pinhole camera at the place of a view's camera, with its focal lengths.

    Conics of ellipsoids hold in flat pictures only, so pictures are undistorted once and everything
    is measured there. A flat picture may be shrunk by a whole number and is a little larger than
    the recorded one where the lens draws its corners in.

    Args:
        view: the camera over its floor.
        shrink: recorded pixels a flat pixel is wide.

    Attributes:
        view, shrink: as given.
        size: width and height of flat pictures in px.
        projection: (3, 4) flat pixels, homogeneous, from world points in metres.
    """

    def __init__(self, view: View, shrink: int = 1) -> None:
        self.view = view
        self.shrink = shrink
        camera = view.camera
        self._recorded = camera.width // shrink, camera.height // shrink
        matrix = _shrunk(camera.matrix, shrink)
        self._plain = camera.lens.is_ideal
        low, self.size = np.zeros(2), self._recorded
        if not self._plain:
            low, self.size = self._reach(matrix)
        self._matrix = matrix.copy()
        self._matrix[:2, 2] -= low
        rotation, camera_position = view.world_from_camera
        self.projection: Floats = self._matrix @ np.column_stack(
            (rotation.T, -rotation.T @ camera_position)
        )
        self._map: _Map | None = None
        self._back: _Map | None = None
        self._index: NDArray[np.intp] | None = None

    @property
    def camera_position(self) -> Floats:
        """(3,) m, the camera's centre in the world."""
        return self.view.world_from_camera[1]

    @property
    def covered(self) -> NDArray[np.bool_]:
        """(height, width) which flat pixels were recorded."""
        full = np.full(self._recorded[::-1], 255, np.uint8)
        return np.asarray(self.flatten(full) >= _COVERED)

    def flatten(self, picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """A shrunk recorded picture as the flat camera has it; black where nothing was recorded.

        Args:
            picture: (height, width) or (height, width, channels), recorded pixels shrunk already.
        """
        if self._plain:
            return picture
        if self._map is None:
            self._map = self._made_map()
        return self._map.apply(picture)

    def unflatten(self, mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """A flat mask (height, width) as the recorded picture has it, shrunk; 0 outside."""
        if self._plain:
            return mask
        if self._back is None:
            u, v = np.meshgrid(*(np.arange(0.0, length) for length in self._recorded))
            recorded = (np.column_stack((u.ravel(), v.ravel())) + 0.5) * self.shrink - 0.5
            self._back = _map_to(self.flat_from_recorded(recorded), self._recorded)
        return self._back.apply(mask)

    def recorded_from_flat(self, points: Floats) -> Floats:
        """Pixels (n, 2) as recorded, at their full size, of flat pixels (n, 2)."""
        points = np.asarray(points, float).reshape(-1, 2)
        if self._plain:
            return (points + 0.5) * self.shrink - 0.5
        rays = (points - self._matrix[:2, 2]) / np.diag(self._matrix)[:2]
        rays[:, 0] -= self._matrix[0, 1] / self._matrix[0, 0] * rays[:, 1]
        camera = self.view.camera
        return camera.lens.distort(rays) @ camera.matrix[:2, :2].T + camera.matrix[:2, 2]

    def recorded_index(
        self, u: Floats, v: Floats, size: tuple[int, int]
    ) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """Numbers of the recorded pixels, row by row, nearest to flat ones, and which there are.

        Args:
            u, v: flat pixels of any shape; NaN is nowhere.
            size: width and height of the recorded picture, shrunk.
        """
        low = (u >= 0) & (v >= 0)
        known = np.asarray(low & (u <= self.size[0] - 1) & (v <= self.size[1] - 1))
        column, row = (np.rint(np.where(known, x, 0.0)).astype(np.intp) for x in (u, v))
        if self._plain:
            return row * size[0] + column, known
        if self._index is None:
            self._index = self._made_index()
        place = self._index[row, column]
        known &= place >= 0
        return np.where(known, place, 0), known

    def flat_from_recorded(self, points: Floats) -> Floats:
        """Flat pixels (n, 2) of pixels (n, 2) as recorded; NaN where the lens shows none."""
        points = np.asarray(points, float).reshape(-1, 2)
        if self._plain:
            return (points + 0.5) / self.shrink - 0.5
        rays = self.view.camera.undistort(points)
        return rays @ self._matrix[:2, :2].T + self._matrix[:2, 2]

    def flat_from_world(self, points: Floats) -> Floats:
        """Flat pixels (n, 2) of world points (n, 3) in metres; NaN at or behind the camera."""
        seen = np.asarray(points, float).reshape(-1, 3) @ self.projection[:, :3].T
        seen += self.projection[:, 3]
        depth = np.where(seen[:, 2:] > 1e-9, seen[:, 2:], np.nan)
        return np.asarray(seen[:, :2] / depth)

    def _reach(self, matrix: Floats) -> tuple[Floats, tuple[int, int]]:
        """The first flat pixel and the size of a picture that holds what was recorded."""
        width, height = self._recorded
        along = np.linspace(-0.5, 0.5, _BORDER_POINTS)
        across = np.full_like(along, 0.5)
        sides = [(along, across), (along, -across), (across, along), (-across, along)]
        border = np.concatenate([np.column_stack(side) for side in sides]) + 0.5
        pixels = border * (width, height) * self.shrink - 0.5
        flat = self.view.camera.undistort(pixels) @ matrix[:2, :2].T + matrix[:2, 2]
        size = np.array((width, height), float)
        spare = (_WIDEST - 1.0) / 2 * size
        low = np.clip(np.nanmin(flat, axis=0), -spare, 0.0)
        high = np.clip(np.nanmax(flat, axis=0), size - 1, size + spare)
        low, high = np.floor(low), np.ceil(high)
        return low, (int(high[0] - low[0]) + 1, int(high[1] - low[1]) + 1)

    def _made_map(self) -> _Map:
        return _map_to(self._sources(), self.size)

    def _made_index(self) -> NDArray[np.intp]:
        """(height, width) the number of the recorded pixel shown there, -1 where none is."""
        width, height = self._recorded
        column, row = np.rint(np.nan_to_num(self._sources(), nan=-1.0)).astype(np.intp).T
        known = (column >= 0) & (row >= 0) & (column < width) & (row < height)
        return np.where(known, row * width + column, -1).reshape(self.size[::-1])

    def _sources(self) -> Floats:
        """(n, 2) recorded pixels, shrunk, that flat ones show, row by row."""
        u, v = np.meshgrid(*(np.arange(0.0, length) for length in self.size))
        recorded = self.recorded_from_flat(np.column_stack((u.ravel(), v.ravel())))
        return (recorded + 0.5) / self.shrink - 0.5


def _map_to(pixels: Floats, size: tuple[int, int]) -> _Map:
    """The map that takes the picture's pixels, row by row, from these places (n, 2)."""
    known = np.nan_to_num(pixels, nan=-1e4).clip(-1e4, 3e4).astype(np.float32)
    known = known.reshape(size[1], size[0], 2)
    whole, fraction = cv2.convertMaps(known, np.empty(0, np.float32), cv2.CV_16SC2)
    return _Map(np.asarray(whole, np.int16), np.asarray(fraction, np.uint16))


def _shrunk(matrix: Floats, shrink: int) -> Floats:
    """The camera matrix of a picture whose pixels are `shrink` recorded ones wide."""
    small = matrix.copy()
    small[:2] /= shrink
    small[:2, 2] += 0.5 / shrink - 0.5
    return small
