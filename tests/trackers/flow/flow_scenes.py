"""Textured people drawn on a textured floor, for the flow tracker: exact places, quick to make."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, View
from tracking.recording import StereoFrame
from tracking.trackers import StepResult
from tracking.trackers.flow import FlowSettings
from tracking.trackers.flow.perception import FlowPerception
from tracking.trackers.flow.tracker import FlowTracker

FPS = 10.0
SIZE = (640, 480)
_HEIGHT_M, _HALF_WIDTH_M = 1.7, 0.2

Picture = NDArray[np.uint8]


def view_of(height_m: float = 3.0, tilt_deg: float = 35.0, distortion: float = 0.0) -> View:
    """A VGA camera over its floor; `distortion` is its lens's k1."""
    matrix = np.array([[500.0, 0.0, 319.5], [0.0, 500.0, 239.5], [0.0, 0.0, 1.0]])
    lens = np.array([distortion, 0.0, 0.0, 0.0])
    return View(Camera(matrix, lens, *SIZE), Ground(height_m, tilt_deg))


def floor_picture(seed: int = 1) -> Picture:
    """A floor with some texture, (480, 640, 3)."""
    random = np.random.default_rng(seed)
    grey = cv2.GaussianBlur(random.normal(140.0, 120.0, SIZE[::-1]), (0, 0), 3.0)
    return np.repeat(grey.clip(0, 255).astype(np.uint8)[..., None], 3, axis=2)


def clothes(seed: int) -> Picture:
    """A board with what somebody wears, (170, 40, 3): spots that differ from the floor's."""
    random = np.random.default_rng(seed)
    spots = random.integers(0, 2, (34, 8, 1)) * 190 + random.integers(0, 40, (34, 8, 3))
    board = cv2.resize(spots.astype(np.uint8), (40, 170), interpolation=cv2.INTER_NEAREST)
    return np.asarray(board, np.uint8)


def drawn(floor: Picture, view: View, people: Sequence[tuple[float, float, int]]) -> Picture:
    """The floor with upright boards of clothes; x, y in m and seed of the clothes of each."""
    picture = floor.copy()
    for x, y, seed in sorted(people, key=lambda one: -one[1]):
        board = clothes(seed)
        low, high = board.shape[0] - 1, 0
        right = board.shape[1] - 1
        corners = np.array([[0, high], [right, high], [right, low], [0, low]], np.float32)
        left, beside = x - _HALF_WIDTH_M, x + _HALF_WIDTH_M
        world = [[left, y, _HEIGHT_M], [beside, y, _HEIGHT_M], [beside, y, 0.0], [left, y, 0.0]]
        pixels = view.pixel_from_world(np.array(world)).astype(np.float32)
        to_picture = cv2.getPerspectiveTransform(corners, pixels)
        shown = cv2.warpPerspective(board, to_picture, SIZE)
        inside = cv2.warpPerspective(np.full(board.shape[:2], 255, np.uint8), to_picture, SIZE)
        picture[inside > 127] = shown[inside > 127]
    return picture


def straight(
    start: tuple[float, float], pace: tuple[float, float], frames: int
) -> NDArray[np.float64]:
    """(frames, 2) m along a straight line at a constant pace in m/s."""
    way = np.arange(frames)[:, None] / FPS * np.asarray(pace, np.float64)
    return np.asarray(np.asarray(start) + way, np.float64)


def flow_pair(
    view: View, settings: FlowSettings | None = None
) -> tuple[FlowPerception, FlowTracker]:
    """Perception and tracker that belong together."""
    perception = FlowPerception(FPS)
    return perception, FlowTracker(perception, view, FPS, settings or FlowSettings())


def tracked(
    view: View,
    pictures: Sequence[Picture],
    settings: FlowSettings | None = None,
    background: Picture | None = None,
) -> tuple[list[StepResult], FlowTracker]:
    """The steps over pictures, after the background was learnt from the empty floor."""
    perception, tracker = flow_pair(view, settings)
    empty = floor_picture() if background is None else background
    perception.learn([frame_of(0, empty)] * 2)
    steps = [
        tracker.step(perception.observe(frame_of(number, picture)))
        for number, picture in enumerate(pictures)
    ]
    return steps, tracker


def frame_of(number: int, picture: Picture) -> StereoFrame:
    """A frame of one camera."""
    return StereoFrame(number, number / FPS, picture, None)
