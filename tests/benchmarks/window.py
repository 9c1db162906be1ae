"""The whole real window while it plays what is cached: both cameras, floor and timeline."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtWidgets import QWidget

from app.features.pictures.overhead_view import OverheadView
from app.features.pictures.picture_view import PictureView
from app.features.timeline.overview import OverviewStrip
from app.features.timeline.tracks_area import TracksArea
from app.shell.application import borrowed_window, show_document, wait_until
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tracking.recording import Recording, open_recording
from tracking.session import Session
from tracking.synthesis import render_recording
from tracking.tracks import DETECTION_COLUMNS, TRACK_COLUMNS, Particles, Run, empty

PEOPLE, PARTICLES_EACH = 15, 500
FPS, FRAMES, ROUNDS = 60.0, 150, 3
LIVE_FRAMES = 140
WINDOW = (1600, 1000)
_BEAT_MS, _LATE_MS = 5, 16.0
_DRAWN = {
    PictureView: "picture",
    OverheadView: "floor",
    TracksArea: "lanes",
    OverviewStrip: "overview",
}


class Heartbeat(QObject):
    """A timer that notes how long the event loop kept it waiting, in ms.

    `gaps_ms` is what the user would feel; `own_ms` the processor time this process took meanwhile,
    which leaves out what else the machine was busy with.
    """

    def __init__(self) -> None:
        super().__init__()
        self.gaps_ms: list[float] = []
        self.own_ms: list[float] = []
        self._last_s = self._own_s = 0.0
        self._timer = QTimer(self, interval=_BEAT_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)

    def start(self) -> None:
        self.gaps_ms.clear()
        self.own_ms.clear()
        self._last_s, self._own_s = time.perf_counter(), time.process_time()
        self._timer.start()

    def stop(self) -> None:
        self._timer.stop()

    def figures(self) -> dict[str, float]:
        """Of the time between two beats; `late` counts those of more than 16 ms."""
        gaps, own = np.array(self.gaps_ms), np.array(self.own_ms)
        return {
            "gap_median_ms": float(np.median(gaps)),
            "gap_p99_ms": float(np.quantile(gaps, 0.99)),
            "gap_max_ms": float(gaps.max()),
            "gap_late_share": float((gaps > _LATE_MS).mean()),
            "own_gap_p99_ms": float(np.quantile(own, 0.99)),
            "own_gap_max_ms": float(own.max()),
            "own_gap_late_share": float((own > _LATE_MS).mean()),
        }

    def _beat(self) -> None:
        now_s = time.perf_counter()
        self.gaps_ms.append(1000 * (now_s - self._last_s))
        own_s = time.process_time()
        self.own_ms.append(1000 * (own_s - self._own_s))
        self._last_s, self._own_s = now_s, own_s


@contextmanager
def timed_paints() -> Iterator[dict[str, list[float]]]:
    """Milliseconds of every paint of the views that are made inside, by kind of view."""
    taken: dict[str, list[float]] = {name: [] for name in _DRAWN.values()}
    before = {kind: kind.paintEvent for kind in _DRAWN}
    try:
        for kind, name in _DRAWN.items():
            kind.paintEvent = _timed(kind.paintEvent, taken[name])
        yield taken
    finally:
        for kind, paint in before.items():
            kind.paintEvent = paint


def _timed(paint: Callable[[Any, Any], None], taken: list[float]) -> Callable[[Any, Any], None]:
    def paint_timed(self: QWidget, event: Any) -> None:
        begun_s = time.perf_counter()
        paint(self, event)
        taken.append(1000 * (time.perf_counter() - begun_s))

    return paint_timed


def walkers(recording: Recording) -> Run:
    """Fifteen people who walk in circles, with five hundred particles each."""
    rng, view = np.random.default_rng(0), recording.view
    assert view is not None
    rows, frames = PEOPLE * FRAMES, np.repeat(np.arange(FRAMES), PEOPLE)
    phase = np.tile(np.arange(PEOPLE) * 2.4, FRAMES) + frames / FPS
    radius = np.tile(np.linspace(0.5, 2.5, PEOPLE), FRAMES)
    middle_y = float(view.field_of_view(12.0)[:, 1].mean())
    xy = np.column_stack((radius * np.cos(phase), middle_y + radius * np.sin(phase)))
    boxes = view.box_of_person(xy, 1.7, 0.5)
    values = {"frame": frames, "track": np.tile(np.arange(1, PEOPLE + 1), FRAMES)}
    values |= dict(zip(("left", "top", "width", "height"), boxes.T, strict=True))
    values |= {"x": xy[:, 0], "y": xy[:, 1], "confidence": np.full(rows, 0.9)}
    values |= {"vx": -radius * np.sin(phase), "vy": radius * np.cos(phase)}
    values |= {"visibility": np.ones(rows), "predicted": (frames // 30 + values["track"]) % 5 == 0}
    spread = rng.normal(0, 0.2, (rows, PARTICLES_EACH, 2))
    weights = np.exp(-(spread**2).sum(axis=2) / 0.05).ravel()
    at = (xy[:, None] + spread).reshape(-1, 2).astype(np.float32)
    track = np.repeat(values["track"], PARTICLES_EACH).astype(np.int32)
    columns = {"track": track, "x": at[:, 0], "y": at[:, 1], "weight": weights.astype(np.float32)}
    return Run(
        tracker="benchmark",
        settings={},
        seed=0,
        frames=(0, FRAMES),
        tracks={name: values[name].astype(dtype) for name, dtype in TRACK_COLUMNS.items()},
        detections=empty(DETECTION_COLUMNS),
        particles=Particles(np.arange(FRAMES + 1) * PEOPLE * PARTICLES_EACH, columns),
    )


def measure() -> dict[str, float]:
    """Frames a second shown, ms a paint of each view, and how long the event loop is kept busy.

    `shown_fps` counts the frames painted while a 60 fps recording plays at its own speed, and
    `frame_cpu_ms` is the processor time of all threads for each; `live_` is with a tracker at work.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory(prefix="trackwright-") as folder:
        place, session = Path(folder) / "plaza", Path(folder) / "plaza.h5"
        render_recording(place, "plaza", FRAMES / FPS, PEOPLE, 1, fps=FPS)
        with open_recording(place) as recording:
            Session.create(recording, [walkers(recording)], session).close()
        with timed_paints() as taken, borrowed_window("dark", WINDOW) as window:
            playing = _play(window, session, taken)
        with borrowed_window("dark", WINDOW) as window:
            return playing | {f"live_{name}": value for name, value in _live(window, place).items()}


def _play(window: MainWindow, session: Path, taken: dict[str, list[float]]) -> dict[str, float]:
    """Play what is cached several times over."""
    show_document(window, session, 0)
    controller, heart = window.controller, Heartbeat()
    assert controller is not None
    controller.set_cameras("both")
    controller.editing.pick(1)
    wait_until(lambda: controller.playback.loaded == ((0, FRAMES),))
    _round(controller)  # what is made once is made
    for times in taken.values():
        times.clear()
    heart.start()
    begun_s, busy_s = time.perf_counter(), time.process_time()
    for _ in range(ROUNDS):
        _round(controller)
    passed_s, busy_s = time.perf_counter() - begun_s, time.process_time() - busy_s
    heart.stop()
    paints = {f"{name}_paint_ms": float(np.median(times)) for name, times in taken.items()}
    return {
        "shown_fps": len(taken["floor"]) / passed_s,
        "frame_cpu_ms": 1000 * busy_s / len(taken["floor"]),
        **paints,
        **heart.figures(),
    }


def _live(window: MainWindow, recording: Path) -> dict[str, float]:
    """Play while the best tracker works on the recording, both from its first frame."""
    show_document(window, recording, 0)
    controller, heart = window.controller, Heartbeat()
    assert controller is not None
    controller.set_cameras("both")
    wait_until(lambda: len(controller.playback.loaded) > 0)
    heart.start()
    controller.toggle()
    wait_until(lambda: controller.live.done >= LIVE_FRAMES or not controller.live.running)
    heart.stop()
    return heart.figures()


def _round(controller: RecordingController) -> None:
    """Play from the start to the end."""
    controller.playback.go(0)
    controller.toggle()
    wait_until(lambda: not controller.playback.clock.playing)
