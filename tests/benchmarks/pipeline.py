"""How fast the whole stereo pipeline is on one core: decoded frames in, stored particles out."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.peers import Obvious, Primitives
from tracking.pipeline import Tracking, track
from tracking.recording import StereoFrame, open_recording

CLIP = Clip("square", 1, 12.0, 16)
"""A scene of sixteen people, of whom fifteen or all are in view in the frames that count."""
PARTICLES = 500
"""Of each person: what the default tracker has, too."""
_IN_VIEW = range(14, 17)


def recording() -> Path:
    """The benchmark's recording, kept in the user's cache."""
    return folder_of(CLIP)


@dataclass(slots=True)
class _Spent:
    """Milliseconds of processor time a frame, by part; the whole of a frame is "frame"."""

    ms: dict[str, list[float]] = field(default_factory=dict)

    def add(self, **seconds: float) -> None:
        """One frame more."""
        for part, each in seconds.items():
            self.ms.setdefault(part, []).append(1000.0 * each)

    def mean(self, part: str, counted: list[int]) -> float:
        """The mean of a part over the frames that count."""
        return float(np.mean(np.array(self.ms[part])[counted]))


def measure() -> dict[str, float | None]:
    """Frames a second of processor time, and milliseconds of it a frame and a part.

    The tracker is the default one. Only frames with about fifteen tracked people count. The time
    is the whole process's, with one thread in OpenCV, so that other work on the machine does not
    count; ours is shared out among the stages by their share of the clock. `vs_primitives` and
    `vs_obvious` are our time over theirs (see `peers`): below 1 we are quicker. The three take
    turns at each frame, so that a machine that is now faster, now slower, is so for all of them.
    """
    cv2.setNumThreads(1)
    ours, people = _Spent(), []
    primitives, obvious = _Spent(), _Spent()
    with open_recording(recording()) as opened, track(opened) as tracking:
        bare, first_idea = Primitives(opened), Obvious(opened, PARTICLES)
        bare_frames, obvious_frames = opened.frames(), opened.frames()
        for seen in _steps(tracking, ours):
            people.append(seen)
            _look(bare, bare_frames, seen, primitives)
            _look(first_idea, obvious_frames, seen, obvious)
    counted = [k for k, seen in enumerate(people) if k and seen in _IN_VIEW]
    return _figures(ours, primitives, obvious, counted, people)


def _steps(tracking: Tracking, spent: _Spent) -> Iterator[int]:
    """Track frame by frame; gives how many people are followed in each."""
    while True:
        before, begun = tracking.stage_s, time.process_time()
        result = next(tracking, None)
        taken = time.process_time() - begun
        if result is None:
            return
        clock = {name: tracking.stage_s[name] - before.get(name, 0.0) for name in before}
        scale = taken / sum(clock.values())
        stages = ("decode", "perception", "tracker")
        spent.add(frame=taken, **{name: scale * clock[name] for name in stages})
        yield len(result.tracks["track"])


def _look(
    work: Primitives | Obvious, frames: Iterator[StereoFrame], people: int, spent: _Spent
) -> None:
    """A peer's turn at the next frame, decoded by its own decoder."""
    begun = time.process_time()
    frame = next(frames)
    decoded = time.process_time() - begun
    work(frame, people)
    spent.add(frame=time.process_time() - begun, decode=decoded, **work.spent_s)


def _figures(
    ours: _Spent, primitives: _Spent, obvious: _Spent, counted: list[int], people: list[int]
) -> dict[str, float | None]:
    """The table: ours, the ratios, and what the peers' parts took."""
    frame_ms = ours.mean("frame", counted)
    return {
        "fps": 1000.0 / frame_ms,
        "people": float(np.mean(np.array(people)[counted])),
        "frame_ms": frame_ms,
        **{f"{part}_ms": ours.mean(part, counted) for part in ours.ms if part != "frame"},
        "vs_primitives": frame_ms / primitives.mean("frame", counted),
        "vs_obvious": frame_ms / obvious.mean("frame", counted),
        **{f"primitives_{part}_ms": primitives.mean(part, counted) for part in primitives.ms},
        **{f"obvious_{part}_ms": obvious.mean(part, counted) for part in obvious.ms},
    }
