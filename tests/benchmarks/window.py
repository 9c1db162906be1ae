"""The whole real window while it plays what is cached: both cameras, floor and timeline."""

from __future__ import annotations

import os
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
from PySide6.QtCore import QObject, Qt, QTimer

from app.features.pictures.overhead_view import OverheadView
from app.shell.application import borrowed_window, show_document, wait_until
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tests.benchmarks.large_sessions import crowd
from tracking.recording import open_recording
from tracking.session import Session
from tracking.synthesis import render_recording

PEOPLE, PARTICLES_EACH = 15, 500
FPS, FRAMES, ROUNDS = 60.0, 150, 3
LIVE_FRAMES = 140
WINDOW = (1600, 1000)
_BEAT_MS, _LATE_MS = 5, 16.0


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
def counted_paints() -> Iterator[Counter[str]]:
    """How often the floor is painted inside: once for each frame that is shown."""
    counted, paint = Counter[str](), OverheadView.paintEvent

    def counting(self: OverheadView, event: Any) -> None:
        counted["floor"] += 1
        paint(self, event)

    with patch.object(OverheadView, "paintEvent", counting):
        yield counted


def measure() -> dict[str, float]:
    """Frames a second shown, and how long the event loop is kept busy.

    `shown_fps` counts the frames painted while a 60 fps recording plays at its own speed, and
    `frame_cpu_ms` is the processor time of all threads for each; `live_` is with a tracker at work.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory(prefix="trackwright-") as folder:
        place, session = Path(folder) / "plaza", Path(folder) / "plaza.h5"
        render_recording(place, "plaza", FRAMES / FPS, PEOPLE, 1, fps=FPS)
        with open_recording(place) as recording:
            run = crowd(PEOPLE * FRAMES, PEOPLE, FRAMES, PEOPLE * PARTICLES_EACH)
            Session.create(recording, [run], session).close()
        with counted_paints() as shown, borrowed_window("dark", WINDOW) as window:
            playing = _play(window, session, shown)
        with borrowed_window("dark", WINDOW) as window:
            return playing | {f"live_{name}": value for name, value in _live(window, place).items()}


def _play(window: MainWindow, session: Path, shown: Counter[str]) -> dict[str, float]:
    """Play what is cached several times over."""
    show_document(window, session, 0)
    controller, heart = window.controller, Heartbeat()
    assert controller is not None
    controller.set_cameras("both")
    controller.editing.pick(1)
    wait_until(lambda: controller.playback.loaded == ((0, FRAMES),))
    _round(controller)  # what is made once is made
    shown.clear()
    heart.start()
    begun_s, busy_s = time.perf_counter(), time.process_time()
    for _ in range(ROUNDS):
        _round(controller)
    passed_s, busy_s = time.perf_counter() - begun_s, time.process_time() - busy_s
    heart.stop()
    return {
        "shown_fps": shown["floor"] / passed_s,
        "frame_cpu_ms": 1000 * busy_s / shown["floor"],
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
