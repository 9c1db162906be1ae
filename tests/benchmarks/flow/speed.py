"""How fast the flow tracker is on one core, and what warm starts of its clustering save."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager
from unittest.mock import patch

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.timing import Stopwatch
from tracking.geometry import Camera, Ground, View
from tracking.recording import StereoFrame
from tracking.trackers.flow import FlowSettings, kernel_table
from tracking.trackers.flow.mean_shift import cluster_cold, cluster_warm
from tracking.trackers.flow.people import HeldPeople
from tracking.trackers.flow.perception import FlowPerception
from tracking.trackers.flow.point_tracker import PointFollower
from tracking.trackers.flow.tracker import FlowTracker

SIZE, FPS = (640, 480), 10.0
TRACKLETS, PEOPLE, FRAMES, WARM_UP = 300, 20, 40, 6
_PACE_M_S = 1.2
_FEWEST, _JOIN = 4, 0.5

Vectors = NDArray[np.float64]


def measure() -> dict[str, float | None]:
    """Milliseconds of processor time a frame at 640x480 with 300 tracklets, in all and by stage.

    `perception_ms` is the foreground, `points_ms` following and finding points, `people_ms` who
    they are and where. `clustering_warm_ms`, `clustering_cold_ms` and `warm_vs_cold`, the second
    over the first, are of the paper's mean shift of 300 tracklets of 20 people.
    """
    cv2.setNumThreads(1)
    warm_ms, cold_ms = _clustering_ms()
    return {
        **_frame_ms(),
        "clustering_warm_ms": warm_ms,
        "clustering_cold_ms": cold_ms,
        "warm_vs_cold": cold_ms / warm_ms,
    }


def _view() -> View:
    matrix = np.array([[560.0, 0.0, 319.5], [0.0, 560.0, 239.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.zeros(4), *SIZE), Ground(2.2, 20.0))


def _frame_ms() -> dict[str, float | None]:
    view, settings = _view(), FlowSettings()
    frames = _footage(view)
    perception, tracker = FlowPerception(FPS), FlowTracker(view, FPS, settings)
    perception.learn([frames[0]] * 2)
    watches = {name: Stopwatch() for name in ("perception", "points", "people", "")}
    tracklets: list[int] = []
    with (
        _timed(PointFollower, watches["points"]),
        _timed(HeldPeople, watches["people"]),
    ):
        for number, frame in enumerate(frames[1:]):
            if number == WARM_UP:
                for watch in watches.values():
                    watch.total_s = 0.0
            with watches[""]:
                with watches["perception"]:
                    observation = perception.observe(frame)
                result = tracker.step(observation)
            tracklets.append(len(result.tracklets["track"]))
    count = len(frames) - 1 - WARM_UP
    each = {f"{name}_ms".lstrip("_"): 1000 * one.total_s / count for name, one in watches.items()}
    return {"ms": each.pop("ms"), "tracklets": float(np.mean(tracklets[WARM_UP:])), **each}


def _timed(kind: type, watch: Stopwatch) -> AbstractContextManager[object]:
    """Adds up the processor time of a class's steps."""
    step = kind.step

    def timed(self: object, *args: object) -> object:
        with watch:
            return step(self, *args)

    return patch.object(kind, "step", timed)


def _footage(view: View) -> list[StereoFrame]:
    """An empty floor, then boards with spotted clothes walking on it."""
    random = np.random.default_rng(5101)
    floor = cv2.GaussianBlur(random.normal(140, 90, SIZE[::-1]), (0, 0), 3.0)
    floor = np.repeat(floor.clip(0, 255).astype(np.uint8)[..., None], 3, axis=2)
    boards = [
        cv2.resize(
            random.integers(0, 230, (26, 7, 3)).astype(np.uint8),
            (42, 170),
            interpolation=cv2.INTER_NEAREST,
        )
        for _ in range(PEOPLE)
    ]
    x, y = random.uniform(-1.8, 1.8, PEOPLE), np.linspace(8.5, 3.2, PEOPLE)
    side = np.where(random.random(PEOPLE) < 0.5, -1, 1)
    frames = [StereoFrame(0, 0.0, floor, None)]
    for number in range(1, FRAMES + WARM_UP):
        picture = floor.copy()
        away = 0.25 * np.sin(number / FPS * _PACE_M_S / 0.25 + x)
        for who in range(PEOPLE):
            _put_up(picture, view, boards[who], (x[who] + side[who] * away[who], y[who]))
        frames.append(StereoFrame(number, number / FPS, picture, None))
    return frames


def _put_up(
    picture: NDArray[np.uint8], view: View, board: NDArray[np.uint8], place: tuple[float, float]
) -> None:
    height, width = board.shape[:2]
    corners = np.array([[0, 0], [width - 1, 0], [width - 1, height - 1], [0, height - 1]])
    left, right = place[0] - 0.21, place[0] + 0.21
    world = [(left, 1.7), (right, 1.7), (right, 0.0), (left, 0.0)]
    pixels = view.pixel_from_world(np.array([[u, place[1], z] for u, z in world]))
    onto = cv2.getPerspectiveTransform(corners.astype(np.float32), pixels.astype(np.float32))
    shown = cv2.warpPerspective(board, onto, SIZE)
    inside = cv2.warpPerspective(np.full((height, width), 255, np.uint8), onto, SIZE) > 127
    picture[inside] = shown[inside]


def _clustering_ms() -> tuple[float, float]:
    """With and without the modes of the frame before, over the same tracklets."""
    table = kernel_table(_view()).scaled(2.0)
    bundles = list(_bundles())
    before = cluster_cold(bundles[0], table, _FEWEST, _JOIN).mode
    warm, cold = Stopwatch(), Stopwatch()
    for tracklets in bundles[1:]:
        with warm:
            before = cluster_warm(before, tracklets, table, _FEWEST, _JOIN, occlusion=True).mode
        with cold:
            cluster_cold(tracklets, table, _FEWEST, _JOIN, occlusion=True)
    warm_ms, cold_ms = (1000 * watch.total_s / (len(bundles) - 1) for watch in (warm, cold))
    return warm_ms, cold_ms


def _bundles() -> Iterator[Vectors]:
    """300 tracklets of 20 people who walk across the picture, a frame after the other."""
    random = np.random.default_rng(5102)
    owner = np.repeat(np.arange(PEOPLE), TRACKLETS // PEOPLE)
    middle = np.column_stack((random.uniform(60, 580, PEOPLE), random.uniform(200, 420, PEOPLE)))
    pace = np.column_stack((random.uniform(-8, 8, PEOPLE), random.uniform(-1, 1, PEOPLE)))
    spread = random.uniform(-1, 1, (TRACKLETS, 2)) * (10, 40)
    for frame in range(12):
        path = [
            (middle + (frame - back) * pace)[owner] + spread + random.normal(0, 0.3, (TRACKLETS, 2))
            for back in range(3)
        ]
        yield np.stack(path, axis=1)
