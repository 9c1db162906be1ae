"""How large a person looks at every pixel: the kernels of mean shift, tabled once."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.flow.settings import ClusterSettings

Floats = NDArray[np.float64]

_STEP_PX = 4
"""Between the pixels that are worked out; those between are interpolated."""
_DISC_POINTS = 16
_FARTHEST_M = 60.0
_CORNERS = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])


@dataclass(frozen=True, slots=True, eq=False)
class KernelTable:
    """The size in the picture of a body whose middle is at a pixel.

    Attributes:
        hx, hy: (height, width) float32, width and height px of the kernel there; NaN where no
            body's middle can be: above the horizon of that height, or too far away.
    """

    hx: NDArray[np.float32]
    hy: NDArray[np.float32]

    def at(self, points: Floats) -> Floats:
        """(..., 2) width and height of the kernels at points (..., 2) px; NaN outside."""
        points = np.asarray(points)
        rows, columns = self.hx.shape
        whole = np.rint(np.nan_to_num(points, nan=-1.0)).astype(np.intp)
        u, v = whole[..., 0], whole[..., 1]
        inside = (u >= 0) & (v >= 0) & (u < columns) & (v < rows)
        u, v = np.clip(u, 0, columns - 1), np.clip(v, 0, rows - 1)
        size = np.stack((self.hx[v, u], self.hy[v, u]), axis=-1).astype(np.float64)
        return np.where(inside[..., None], size, np.nan)

    def scaled(self, factor: float) -> KernelTable:
        """Kernels so many times as large."""
        return KernelTable(self.hx * np.float32(factor), self.hy * np.float32(factor))


def kernel_table(
    view: View, *, width_m: float = 0.40, height_m: float = 1.65, centre_m: float = 0.80
) -> KernelTable:
    """hx and hy for every pixel of the picture as recorded [Yoneji2013] section 3.2.2.

    A pixel stands for the point `centre_m` over the floor that is seen there. A card of the width
    and height of a body is put up round it, facing the camera, and projected: the box round what
    is seen of it is the kernel.

    Where we differ from the source and why:
        - the table holds pixels, not lines, so that a rolled camera and any lens are right too;
          pictures need not be undistorted for it;
        - a level disc as wide as the card counts as well, so that bodies keep their breadth where
          the camera looks straight down on them.

    Args:
        view: the camera over its floor.
        width_m, height_m: of the card. centre_m: its middle over the floor.
    """
    width, height = view.camera.size
    u = np.arange(0, width - 1 + _STEP_PX, _STEP_PX, dtype=np.float64)
    v = np.arange(0, height - 1 + _STEP_PX, _STEP_PX, dtype=np.float64)
    lines = np.stack(np.meshgrid(u, v), axis=-1)
    size = np.stack(  # line by line: the corners of all bodies at once are 1.5 GB at 1920 x 1080
        [
            kernel_sizes(view, line, width_m=width_m, height_m=height_m, centre_m=centre_m)
            for line in lines
        ]
    )
    hx, hy = (_every_pixel(size[..., side], (width, height)) for side in (0, 1))
    return KernelTable(hx, hy)


def kernel_sizes(
    view: View,
    pixels: Floats,
    *,
    width_m: float = 0.40,
    height_m: float = 1.65,
    centre_m: float = 0.80,
) -> Floats:
    """(n, 2) width and height px of the kernels at pixels (n, 2): see `kernel_table`."""
    floor = view.floor_from_pixel(pixels, centre_m)
    away = floor - view.world_from_camera[1][:2]
    distance = np.hypot(away[:, 0], away[:, 1])
    floor[~(distance < _FARTHEST_M)] = np.nan
    sight = away / np.maximum(distance, 1e-9)[:, None]
    across = np.column_stack((sight[:, 1], -sight[:, 0]))
    body = _card(floor, across, width_m, height_m, centre_m)
    body = np.concatenate((body, _disc(floor, width_m, centre_m)), axis=1)
    seen = view.pixel_from_world(body.reshape(-1, 3)).reshape(len(pixels), -1, 2)
    return np.asarray(seen.max(axis=1) - seen.min(axis=1))


def kernel_rectangles(view: View, pixels: Floats, settings: ClusterSettings) -> Floats:
    """(n, 4, 2) px: the corners of what kernels round pixels (n, 2) hold; NaN: there is none."""
    size = settings.bodies * kernel_sizes(
        view,
        pixels,
        width_m=settings.width_m,
        height_m=settings.height_m,
        centre_m=settings.centre_m,
    )
    return np.asarray(pixels[:, None] + _CORNERS * size[:, None])


def _card(
    floor: Floats, across: Floats, width_m: float, height_m: float, centre_m: float
) -> Floats:
    """(n, 4, 3) corners of upright cards over floor points, `across` being their level side."""
    sides = floor[:, None] + across[:, None] * np.array([[-0.5], [0.5]]) * width_m
    low, high = centre_m - height_m / 2, centre_m + height_m / 2
    corners = [np.concatenate((sides, np.full((len(floor), 2, 1), z)), axis=2) for z in (low, high)]
    return np.concatenate(corners, axis=1)


def _disc(floor: Floats, width_m: float, centre_m: float) -> Floats:
    """(n, k, 3) points round level discs over floor points."""
    angle = np.arange(_DISC_POINTS) * (2 * np.pi / _DISC_POINTS)
    circle = np.column_stack((np.cos(angle), np.sin(angle))) * (width_m / 2)
    ring = floor[:, None] + circle
    return np.concatenate((ring, np.full((*ring.shape[:2], 1), centre_m)), axis=2)


def _every_pixel(coarse: Floats, size: tuple[int, int]) -> NDArray[np.float32]:
    """(height, width) interpolated between every `_STEP_PX`-th pixel; NaN next to NaN."""
    u, v = np.arange(size[0], dtype=np.float32), np.arange(size[1], dtype=np.float32)
    maps = np.meshgrid(u / _STEP_PX, v / _STEP_PX)
    fine = cv2.remap(coarse.astype(np.float32), maps[0], maps[1], cv2.INTER_LINEAR)
    return np.asarray(fine, np.float32)
