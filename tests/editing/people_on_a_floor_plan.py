"""A camera over its floor, and people walking there, to edit."""

from __future__ import annotations

import numpy as np

from tracking.editing.boxes.floor_boxes import body_boxes
from tracking.geometry import Camera, Ground, Rectification, StereoCalibration, View
from tracking.synthesis import SCENES
from tracking.synthesis.rig import Rig
from tracking.tracks import CORRECTED_COLUMNS, TrackTable

FPS = 20.0
VIEW = Rig.of_scene(SCENES["lobby"], (640, 480)).view


def turned_rig() -> Rectification:
    """A pair with lenses that distort and cameras that do not look the same way."""
    matrix = np.array([[560.0, 0, 322], [0, 561, 243], [0, 0, 1]])
    left = Camera(matrix, np.array([-0.21, 0.06, 0.001, -0.0005, 0.0]), 640, 480)
    other = np.array([[564.0, 0, 317], [0, 564, 245], [0, 0, 1]])
    right = Camera(other, np.array([-0.19, 0.05, 0, 0]), 640, 480)
    angles = np.deg2rad((0.8, -1.5, 0.6))
    turn = np.eye(3)
    for axis, angle in enumerate(angles):
        a, b = [i for i in range(3) if i != axis]
        step = np.eye(3)
        step[a, a] = step[b, b] = np.cos(angle)
        step[a, b], step[b, a] = -np.sin(angle), np.sin(angle)
        turn = turn @ step
    calibration = StereoCalibration(left, right, turn, np.array([-0.2, 0.004, 0.006]))
    return Rectification(calibration, Ground(2.6, 27.0, 3.0))


def walking(
    view: View = VIEW,
    frames: int = 40,
    height_m: float = 1.68,
    start: tuple[float, float] = (-1.0, 4.0),
    speed: tuple[float, float] = (1.0, 0.5),
) -> TrackTable:
    """Track 1 walks straight on from frame 0; its boxes are a body's, a bit to one side."""
    time = np.arange(frames) / FPS
    places = np.array(start) + time[:, None] * speed
    boxes = body_boxes(view, places, np.full(frames, height_m))
    boxes += boxes[:, [2, 3, 2, 3]] * (0.04, -0.02, 0.1, 0.03)
    rows = {name: np.zeros(frames, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"] = np.arange(frames), np.ones(frames, np.int32)
    rows["left"], rows["top"], rows["width"], rows["height"] = boxes.T
    rows["x"], rows["y"] = places.T
    rows["vx"][:], rows["vy"][:] = speed
    rows["confidence"][:], rows["visibility"][:] = 0.9, 0.8
    return TrackTable(rows)
