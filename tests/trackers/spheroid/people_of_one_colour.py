"""Pictures of people who are spheroids of one colour each, on a floor of many."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from tracking.geometry import Camera, FlatView, Ground, View, standing_ellipses
from tracking.recording.frame import StereoFrame
from tracking.trackers import StepResult
from tracking.trackers.spheroid import SpheroidPerception, SpheroidSettings
from tracking.trackers.spheroid.tracker import SpheroidTracker

FPS = 15.0
SIZE = (320, 240)
RED, BLUE, GREEN = (40, 40, 200), (200, 60, 40), (40, 170, 40)
LEAN_S = 0.05
"""Bodies of those who walk are ahead of their feet by so many seconds of walking."""


def view(
    height_m: float = 3.6,
    tilt: float = 90.0,
    distortion: Sequence[float] = (),
    focal: float = 200.0,
) -> View:
    matrix = np.array([[focal, 0.0, 159.5], [0.0, focal, 119.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.array(distortion, float), *SIZE), Ground(height_m, tilt))


def floor_picture(seed: int = 3) -> np.ndarray:
    """(240, 320, 3) tiles of slightly different greys."""
    random = np.random.default_rng(seed)
    small = random.integers(110, 170, (12, 16, 1)).repeat(3, axis=2).astype(np.uint8)
    return np.asarray(cv2.resize(small, SIZE, interpolation=cv2.INTER_NEAREST))


@dataclass(frozen=True)
class Body:
    """Somebody: path (frames, 2) m, NaN where not there; how high and in what colour."""

    path: np.ndarray
    colour: tuple[int, int, int] = RED
    height_m: float = 1.72

    def axis(self, number: int) -> np.ndarray:
        """(2,) m where the body is that stands on the path."""
        step = np.nan_to_num(self.path[number] - self.path[max(number - 1, 0)])
        return np.asarray(self.path[number] + LEAN_S * FPS * step)


def straight(start: Sequence[float], velocity: Sequence[float], frames: int) -> np.ndarray:
    return np.asarray(start) + np.arange(frames)[:, None] / FPS * np.asarray(velocity)


def standing(place: Sequence[float], frames: int) -> np.ndarray:
    return straight(place, (0.0, 0.0), frames)


def frames_of(
    seen_by: View,
    bodies: Sequence[Body],
    floor: np.ndarray | None = None,
    shifts: Sequence[tuple[float, float]] | None = None,
) -> list[StereoFrame]:
    """The footage; who stands nearer hides who stands behind.

    Args:
        shifts: px by which each whole picture is moved, as by a camera that turns.
    """
    flat = FlatView(seen_by)
    floor = floor_picture() if floor is None else floor
    random = np.random.default_rng(11)
    frames = []
    for number in range(len(bodies[0].path)):
        picture = floor.copy()
        there = [body for body in bodies if np.isfinite(body.path[number]).all()]
        for body in sorted(there, key=lambda b: -float(np.hypot(*b.path[number]))):
            xy = body.axis(number)[None]
            outline = standing_ellipses(flat.projection, xy, np.array([body.height_m]), 0.25)
            pixels = flat.recorded_from_flat(outline.polygons(60)[0])
            if np.isfinite(pixels).all():
                cv2.fillPoly(picture, [np.rint(pixels).astype(np.int32)], body.colour)
        if shifts is not None:
            moved = np.array([[1, 0, shifts[number][0]], [0, 1, shifts[number][1]]], float)
            picture = cv2.warpAffine(picture, moved, SIZE, borderMode=cv2.BORDER_REFLECT)
        noise = random.integers(-2, 3, picture.shape)
        seen = np.clip(picture.astype(int) + noise, 0, 255).astype(np.uint8)
        frames.append(StereoFrame(number, number / FPS, seen, None))
    return frames


def built(
    seen_by: View, seed: int = 0, learn: Iterable[StereoFrame] | None = None, **settings
) -> tuple[SpheroidPerception, SpheroidTracker]:
    chosen = SpheroidSettings(**settings)
    perception = SpheroidPerception(FPS, seen_by, chosen.foreground, chosen.ramp)
    empty = [StereoFrame(0, 0.0, floor_picture(), None)]
    perception.learn(empty if learn is None else learn)
    return perception, SpheroidTracker(perception, chosen, perception.flat.covered, seed)


def followed(
    seen_by: View, frames: Sequence[StereoFrame], seed: int = 0, learn=None, **settings
) -> list[StepResult]:
    perception, tracker = built(seen_by, seed, learn, **settings)
    return [tracker.step(perception.observe(frame)) for frame in frames]


def places(result: StepResult) -> np.ndarray:
    """(tracks, 2) m."""
    return np.column_stack((result.tracks["x"], result.tracks["y"]))
