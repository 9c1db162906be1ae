"""How long the window's drawings take, offscreen, in software: milliseconds per paint."""

from __future__ import annotations

import os
import time
from collections.abc import Callable

import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QWidget

from app.presenters.scenes import (
    FloorPerson,
    Lane,
    OverheadScene,
    PersonMark,
    PictureScene,
    Side,
    TimelineScene,
)
from app.views.look.theme import Look, apply_look
from app.views.pictures.overhead import OverheadView
from app.views.pictures.picture import PictureView
from app.views.timeline import TimelineView
from tests.benchmarks import window_playing

PEOPLE, PARTICLES_EACH, TRAIL = 15, 500, 60
LANES, FRAMES = 1000, 36_000
_PAINTS = 60
_COLOURS = [(0, 114, 178), (230, 159, 0), (0, 158, 115), (204, 121, 167), (86, 180, 233)]


def picture_scene(frame: int, rng: np.random.Generator) -> PictureScene:
    """A VGA picture with fifteen people and their trails."""
    image = rng.integers(0, 255, (480, 640, 3), np.uint8)
    people = []
    for track in range(1, PEOPLE + 1):
        left, top = rng.uniform((20, 20), (560, 300)).tolist()
        trail = np.column_stack([np.linspace(left - 60, left, TRAIL), np.full(TRAIL, top + 120.0)])
        colour = _COLOURS[track % len(_COLOURS)]
        box = (left, top, 40.0, 120.0)
        selected, predicted = track == PEOPLE, track % 5 == 0
        people.append(PersonMark(track, box, str(track), colour, selected, predicted, trail))
    return PictureScene(Side.LEFT, frame, image, tuple(people))


def overhead_scene(frame: int, rng: np.random.Generator) -> OverheadScene:
    """Fifteen people with five hundred particles each."""
    at = rng.uniform((-4, 2), (4, 9), (PEOPLE, 2))
    colours = np.array([_COLOURS[k % len(_COLOURS)] for k in range(PEOPLE)], np.uint8)
    spread = rng.normal(0, 0.2, (PEOPLE, PARTICLES_EACH, 2))
    weights = np.exp(-(spread**2).sum(axis=2) / 0.05)
    people = tuple(
        FloorPerson(
            k + 1,
            str(k + 1),
            (float(x), float(y)),
            (0.8, 0.4),
            _COLOURS[k % len(_COLOURS)],
            k == 0,
            k % 5 == 0,
            np.column_stack([np.linspace(x - 2, x, TRAIL), np.linspace(y - 1, y, TRAIL)]),
        )
        for k, (x, y) in enumerate(at)
    )
    return OverheadScene(
        frame,
        (at[:, None] + spread).reshape(-1, 2).astype(np.float32),
        np.repeat(colours, PARTICLES_EACH, axis=0),
        weights.reshape(-1).astype(np.float32),
        at + 0.05,
        people,
        np.array([(-2.0, 2.0), (2.0, 2.0), (5.0, 9.0), (-5.0, 9.0)]),
        (0.0, 0.0),
        (-5.5, -0.5, 5.5, 9.5),
    )


def timeline_scene(frame: int, rng: np.random.Generator) -> TimelineScene:
    """A thousand lanes over half an hour at twenty frames a second."""
    lanes = []
    for track in range(1, LANES + 1):
        edges = np.sort(rng.choice(FRAMES, 41, replace=False)).astype(np.int64)
        predicted = np.arange(40) % 2
        spans = np.column_stack([edges[:-1], edges[1:], predicted])
        lanes.append(Lane(track, str(track), _COLOURS[track % 5], track == 3, spans))
    activity = rng.integers(0, 12, FRAMES).astype(np.uint16)
    return TimelineScene(FRAMES, 20.0, frame, tuple(lanes), activity, (0, 20_000), ((0, 200),))


def _paint_ms(widget: QWidget, show: Callable[[int], None]) -> float:
    """The median processor time of showing another scene and painting it.

    Of all threads together: how busy the machine is with other things does not count.
    """
    target = QImage(widget.size(), QImage.Format.Format_RGB32)
    taken = []
    for paint in range(_PAINTS):
        begun = time.process_time()
        show(paint)
        widget.render(target)
        taken.append(1000 * (time.process_time() - begun))
    return float(np.median(taken))


def measure() -> dict[str, float]:
    """Milliseconds a paint takes: floor with 7,500 particles, picture, and a thousand lanes.

    `lanes_ms` draws all lanes in sight anew; `playhead_ms` is what a frame of playback costs. Then
    the whole window while it plays, see `window_playing`.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    application = QApplication.instance() or QApplication([])
    assert isinstance(application, QApplication)
    apply_look(application, Look.DARK)
    alone = _figures()  # the widgets are gone before the application is
    return alone | window_playing.measure()


def _figures() -> dict[str, float]:
    rng = np.random.default_rng(0)
    floors = [overhead_scene(frame, rng) for frame in range(8)]
    pictures = [picture_scene(frame, rng) for frame in range(8)]
    lanes = [timeline_scene(frame, rng) for frame in range(2)]
    overhead, picture, timeline = OverheadView(), PictureView(Side.LEFT), TimelineView()
    overhead.resize(700, 700)
    picture.resize(700, 560)
    timeline.resize(1500, 320)
    still = lanes[0]
    moving = [
        TimelineScene(FRAMES, 20.0, 100 * frame, still.lanes, still.activity, still.tracked)
        for frame in range(8)
    ]
    return {
        "overhead_ms": _paint_ms(overhead, lambda k: overhead.show_scene(floors[k % 8])),
        "picture_ms": _paint_ms(picture, lambda k: picture.show_scene(pictures[k % 8])),
        "lanes_ms": _paint_ms(timeline, lambda k: timeline.show_scene(lanes[k % 2])),
        "playhead_ms": _paint_ms(timeline, lambda k: timeline.show_scene(moving[k % 8])),
    }


if __name__ == "__main__":
    for name, value in measure().items():
        print(f"{name:16} {value:.2f}")
