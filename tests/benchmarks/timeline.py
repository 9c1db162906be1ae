"""The real timeline over ten million rows, a thousand tracks and eight hours: ms of the clock."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtWidgets import QApplication

from app.core.document.edit_history import EditMarks
from app.core.look.theme import Look, apply_look
from app.core.scenes import MarkKind, TimelineMark, TimelineScene
from app.core.tracks.frame_state import FrameState
from app.core.tracks.session_tracks import SessionTracks
from app.features.timeline.panel import TimelineView
from app.features.timeline.presenter import TimelinePresenter
from app.features.timeline.rows import Arrangement, LaneHeight, LaneOrder
from tests.benchmarks.large_sessions import NoPictures, crowd
from tracking.editing import Change, plan_delete, plan_move_box, plan_swap
from tracking.session import Session

ROWS, TRACKS, FPS, HOURS = 10_000_000, 1000, 30.0, 8
FRAMES = int(HOURS * 3600 * FPS)
_SIZE = 1600, 420
_TIMES = 40


class Bench:
    """The presenter and the widget over one large session, as the window puts them together."""

    def __init__(self, session: Session) -> None:
        self.session, self.tracks = session, SessionTracks(session.tracks, session.runs[0])
        self.presenter, self._marks = TimelinePresenter(FRAMES, FPS), EditMarks()
        self.frame, self.selected = FRAMES // 2, 0
        self.presenter.take(self.tracks, {})
        self.presenter.take_review_items(review_items())
        self.view = TimelineView()
        self.view.resize(*_SIZE)
        ratio = self.view.devicePixelRatioF()
        self._target = QImage(self.view.size() * ratio, QImage.Format.Format_RGB32)
        self._target.setDevicePixelRatio(ratio)

    def scene(self) -> TimelineScene:
        state = FrameState(self.frame, self.tracks, selected=self.selected)
        return self.presenter.scene(self.frame, state, (), None)

    def show(self) -> None:
        """Show and paint what there is to see by now."""
        self.view.show_scene(self.scene())
        self.view.render(self._target)

    def edit(self, change: Change) -> None:
        self.session.apply(change)
        self._take(change)

    def undo(self) -> None:
        self._take(self.session.undo().change.inverse)

    def _take(self, change: Change) -> None:
        frames = change.before.rows["frame"], change.after.rows["frame"]
        marks = self._marks.of(self.session.history)
        self.presenter.take_changed(change.tracks, self.tracks, frames, marks)

    def turn_wheel(self, notches: float, held: Qt.KeyboardModifier) -> None:
        area = self.view.area
        at = QPointF(area.axis.x_of(self.frame), area.ruler_height + 20)
        event = QWheelEvent(
            *(at, area.mapToGlobal(at), QPoint(), QPoint(0, round(120 * notches))),
            *(Qt.MouseButton.NoButton, held, Qt.ScrollPhase.NoScrollPhase, False),
        )
        QApplication.sendEvent(area, event)


def review_items() -> tuple[TimelineMark, ...]:
    """Ten thousand of them."""
    rng = np.random.default_rng(3101)
    frames, tracks = rng.integers(0, FRAMES, 10_000), rng.integers(1, TRACKS + 1, 10_000)
    places = zip(frames.tolist(), tracks.tolist(), strict=True)
    return tuple(TimelineMark(MarkKind.REVIEW_ITEM, *place, "likely swap") for place in places)


def measure() -> dict[str, float]:
    """Of each gesture the median and the 95th percentile, from it until all is painted again.

    `_own` is the processor time of this program: what else the machine was busy with is left out.

    The widget is 1600 x 420, painted offscreen in software; QT_SCALE_FACTOR=2 makes it as many
    pixels as a fine screen has. `first_ms` is once, from the table to the first picture; the window
    does the most of it in the background.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    application = QApplication.instance() or QApplication([])
    assert isinstance(application, QApplication)
    apply_look(application, Look.DARK)
    recording = NoPictures(Path(), fps=FPS, frame_count=FRAMES)
    session = Session.create(recording, [crowd(ROWS, TRACKS, FRAMES)])
    begun_s = time.perf_counter()
    bench = Bench(session)
    bench.show()
    first_ms = 1000 * (time.perf_counter() - begun_s)
    figures = {"rows": float(len(session.tracks)), "first_ms": first_ms}
    for name, gestures in _gestures(bench):
        taken = _timed(gestures, bench.show)
        clock, own = np.array(taken).T
        figures[f"{name}_ms"] = float(np.median(clock))
        figures[f"{name}_p95_ms"] = float(np.quantile(clock, 0.95))
        figures[f"{name}_own_p95_ms"] = float(np.quantile(own, 0.95))
    return figures


def _gestures(bench: Bench) -> Iterator[tuple[str, Iterator[Callable[[], object]]]]:
    none, shift = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
    area, table = bench.view.area, bench.session.tracks
    rng = np.random.default_rng(3102)
    yield "playhead", (lambda: _go(bench, bench.frame + 1) for _ in range(_TIMES))
    yield "scroll", (lambda: bench.turn_wheel(-1, shift) for _ in range(_TIMES))
    yield "zoom", (lambda: bench.turn_wheel(1, none) for _ in range(_TIMES))
    yield "pan", (lambda: area.stretch.pan(0.3) for _ in range(_TIMES))
    area.stretch.show(area.axis.around(bench.frame, 60 * FPS))
    yield "pan_minute", (lambda: area.stretch.pan(0.3) for _ in range(_TIMES))
    area.stretch.show_all()
    low = Arrangement(height=LaneHeight.LOW)
    area.controls.arrange(low)
    area.scroll_bar.setValue(0)
    yield "scroll_low_lanes", (lambda: bench.turn_wheel(-1, shift) for _ in range(_TIMES))
    sifted = Arrangement(LaneOrder.NUMBER, in_view_only=True)
    area.controls.arrange(sifted)
    area.stretch.show(area.axis.around(bench.frame, 600 * FPS))
    yield "pan_sifted", (lambda: area.stretch.pan(0.1) for _ in range(_TIMES))
    area.controls.arrange(Arrangement())
    area.stretch.show_all()
    picked = rng.choice(TRACKS, (_TIMES, 2), replace=False) + 1 if 2 * _TIMES <= TRACKS else []
    yield "select", (lambda a=int(pair[0]): _select(bench, a) for pair in picked)
    yield (
        "swap",
        (
            lambda a=int(a), b=int(b): bench.edit(plan_swap(table, a, b, _middle(bench, a)))
            for a, b in picked
        ),
    )
    yield "undo", (bench.undo for _ in picked)
    yield (
        "draw",
        (
            lambda a=int(a): bench.edit(plan_move_box(table, a, _middle(bench, a), (1, 2, 30, 80)))
            for a, _ in picked
        ),
    )
    yield "delete", (lambda a=int(a): bench.edit(plan_delete(table, a)) for a, _ in picked)


def _go(bench: Bench, frame: int) -> None:
    bench.frame = frame


def _select(bench: Bench, track: int) -> None:
    bench.selected = track


def _middle(bench: Bench, track: int) -> int:
    frames: NDArray[np.int32] = bench.session.tracks.frames_of_track(track)
    return int(frames[len(frames) // 2])


def _timed(
    gestures: Iterator[Callable[[], object]], show: Callable[[], None]
) -> list[tuple[float, float]]:
    """Of each gesture the time of the clock and that of this program's processor, in ms."""
    taken = []
    for gesture in gestures:
        begun_s, own_s = time.perf_counter(), time.process_time()
        gesture()
        show()
        passed_s, busy_s = time.perf_counter() - begun_s, time.process_time() - own_s
        taken.append((1000 * passed_s, 1000 * busy_s))
    return taken
