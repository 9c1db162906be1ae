"""The floor on the left image: the metre grid, the horizon, and somebody of 1.7 m."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.features.setup.scene import SetupPicture, SetupScene
from tracking.arrays import Floats
from tracking.geometry import View

FIGURE_M, _FIGURE_WIDTH_M = 1.7, 0.5
_GRID_M, _FAR_M, _ASIDE_M = 1.0, 15.0, 6.0
"""Of the grid that is drawn on the floor: its step, and how far it reaches."""
_PIECE_M = 0.25
"""Lines are drawn in pieces, which may be cut at the edge of what the lens shows."""
_FARTHEST_PX = 4
"""Of the image's larger side: pieces farther off are left out."""


def view_of(scene: SetupScene) -> View | None:
    """The left camera over its floor; None where calibration or floor are not known."""
    plan, calibration = scene.state.plan, scene.checked.calibration
    if plan is None or plan.ground is None or calibration is None or scene.images is None:
        return None
    height, width = scene.images.left.shape[:2]
    if calibration.left.size != (width, height):
        return None
    return View(calibration.left, plan.ground)


def with_floor(
    picture: SetupPicture, scene: SetupScene, pointer: tuple[float, float] | None
) -> SetupPicture:
    """A picture that begins with the left image as recorded, with its floor where that is known.

    Args:
        pointer: the pixel at which the figure stands; None, or beside the image: in front.
    """
    view = view_of(scene)
    if view is None or scene.images is None:
        return picture
    height, width = scene.images.left.shape[:2]
    inside = pointer is not None and 0 <= pointer[0] < width and 0 <= pointer[1] < height
    where = pointer if pointer is not None and inside else (width * 0.5, height * 0.75)
    return replace(
        picture,
        grid=tuple(_drawable(view.pixel_from_world(line), (width, height)) for line in _lines()),
        horizon=_horizon(view, (width, height)),
        figure=_figure(view, where),
        floor_size=(float(width), float(height)),
    )


def _drawable(pixels: Floats, size: tuple[int, int]) -> Floats:
    """The pixels with NaN where they are far off the image: there lines are not drawn."""
    far = _FARTHEST_PX * max(size)
    near = np.asarray((np.abs(np.nan_to_num(pixels, nan=np.inf)) < far).all(axis=1))
    return np.where(near[:, None], pixels, np.nan)


def _lines() -> list[Floats]:
    """(n, 3) m: lines along and across the floor before the camera, and around below it."""
    along = np.arange(-_ASIDE_M, _FAR_M + _PIECE_M, _PIECE_M)
    across = np.arange(-_ASIDE_M, _ASIDE_M + _PIECE_M, _PIECE_M)
    lines = [
        np.column_stack((np.full(len(along), x), along, np.zeros(len(along))))
        for x in np.arange(-_ASIDE_M, _ASIDE_M + _GRID_M, _GRID_M)
    ]
    return lines + [
        np.column_stack((across, np.full(len(across), y), np.zeros(len(across))))
        for y in np.arange(-_ASIDE_M, _FAR_M + _GRID_M, _GRID_M)
    ]


def _horizon(view: View, size: tuple[int, int]) -> Floats:
    angle = np.deg2rad(np.arange(-80.0, 81.0, 2.0))
    far = 1e5 * np.column_stack((np.sin(angle), np.cos(angle), np.zeros(len(angle))))
    return _drawable(view.pixel_from_world(far), size)


def _figure(view: View, where: tuple[float, float]) -> tuple[float, float, float, float] | None:
    """Somebody of usual height who stands where a pixel shows the floor; None: above it."""
    place = view.floor_from_pixel(np.array([where]))
    if not np.isfinite(place).all():
        return None
    box = view.box_of_person(place, FIGURE_M, _FIGURE_WIDTH_M)[0]
    if not np.isfinite(box).all() or np.abs(box).max() > 1e5:
        return None
    left, top, width, height = box.tolist()
    return left, top, width, height
