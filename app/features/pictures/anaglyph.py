"""Both cameras in one picture, for red and cyan glasses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from app.core.scenes import PersonMark, PictureScene, Side
from tracking.errors import CalibrationError
from tracking.geometry import Rectification
from tracking.recording import Image, Recording, StereoFrame

Floats = NDArray[np.float64]
Move = Callable[[Floats], Floats]


class Anaglyph:
    """Lays the rectified right camera over the rectified left one, and moves the people along.

    The right picture is shifted so that the floor in the middle of the picture lies in the plane
    of the screen: people stand out of it, and nobody has to squint. Without a calibration
    the pictures are taken as recorded; they only look right where the cameras were well aligned.
    """

    def __init__(self, recording: Recording) -> None:
        self._rectification = recording.rectification
        self._shift_px = 0
        if self._rectification is not None:
            self._shift_px = _shift_px(recording, self._rectification)
        self._last: tuple[StereoFrame, Image] | None = None

    def scene(self, frame: StereoFrame, scene: PictureScene) -> PictureScene:
        """The left image's scene on an image of both; unchanged where there is one camera."""
        if frame.right is None or frame.right.shape != frame.left.shape:
            return scene
        picture = self._picture(frame, frame.right)
        rectification = self._rectification
        if rectification is None or rectification.identity:
            return replace(scene, side=Side.BOTH, image=picture)
        move = rectification.rectified_from_recorded
        overlay = scene.overlay
        return replace(
            scene,
            side=Side.BOTH,
            image=picture,
            people=tuple(_moved(person, move) for person in scene.people),
            overlay=None if overlay is None else rectification.rectify(overlay, overlay)[0],
            grid=_moved_points(scene.grid, move),
            preview=tuple(replace(t, points=_moved_points(t.points, move)) for t in scene.preview),
        )

    def _picture(self, frame: StereoFrame, right: Image) -> Image:
        """The picture of a frame; the same array while the frame stays the same."""
        if self._last is None or self._last[0] is not frame:
            left = frame.left
            if self._rectification is not None:
                left, right = self._rectification.rectify(left, right)
            self._last = (frame, anaglyph_image(left, right, self._shift_px))
        return self._last[1]


def anaglyph_image(left: Image, right: Image, shift_px: int = 0) -> Image:
    """Red from the left camera's brightness, green and blue from the right camera's.

    Args:
        left, right: (height, width, 3) uint8 BGR, rectified.
        shift_px: how far the right camera is moved to the right; what only one camera has is black.
    """
    width = right.shape[1]
    shift = max(-width, min(width, shift_px))
    both = np.zeros_like(left)
    shared = slice(max(shift, 0), width + min(shift, 0))
    moved = slice(max(-shift, 0), width - max(shift, 0))
    both[:, shared, 2] = cv2.cvtColor(left, cv2.COLOR_BGR2GRAY)[:, shared]
    both[:, shared, :2] = cv2.cvtColor(right, cv2.COLOR_BGR2GRAY)[:, moved, None]
    return both


def _shift_px(recording: Recording, rectification: Rectification) -> int:
    """Disparity of the floor in the middle of the picture; that of infinity where none is."""
    offset = rectification.disparity_offset_px
    if recording.view is None:
        return round(offset)
    width, height = recording.size
    middle = recording.view.floor_from_pixel(np.array([[width / 2, height / 2]]))
    try:
        standing = np.column_stack((middle, np.zeros(1)))
        disparity = float(rectification.disparity_from_world(standing)[0])
    except CalibrationError:
        return round(offset)
    return round(disparity if np.isfinite(disparity) else offset)


def _moved(person: PersonMark, move: Move) -> PersonMark:
    """A person whose box and trail are given in other pixels."""
    left, top, width, height = person.box
    across, down = np.array((0, 1, 1, 0)) * width + left, np.array((0, 0, 1, 1)) * height + top
    corners = move(np.column_stack((across, down)))
    low, high = corners.min(axis=0), corners.max(axis=0)
    x, y, w, h = (float(part) for part in (*low, *(high - low)))
    return replace(person, box=(x, y, w, h), trail=_moved_points(person.trail, move))


def _moved_points(points: Floats, move: Move) -> Floats:
    """Points of any shape (..., 2) in other pixels; NaN stays NaN."""
    return move(points.reshape(-1, 2)).reshape(points.shape) if points.size else points
