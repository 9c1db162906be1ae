"""How fast body parts are tracked on one core: decoded frames in, parts and particles out."""

from __future__ import annotations

import time

import cv2
import numpy as np

from tests.benchmarks.clips import folder_of
from tests.benchmarks.parts.clips import TUNED
from tracking.pipeline import Tracking, track
from tracking.recording import open_recording

PEOPLE = 5
"""Only frames with so many people tracked count."""


def measure() -> dict[str, float | None]:
    """Frames a second of processor time at 720x480, and milliseconds of it a frame and a stage.

    The time is the whole process's, with one thread in OpenCV, so that other work on the machine
    does not count; it is shared out among the stages by their share of the clock.
    """
    cv2.setNumThreads(1)
    spent_s: list[float] = []
    clock_s: list[dict[str, float]] = []
    for clip in TUNED:
        with (
            open_recording(folder_of(clip)) as recording,
            track(recording, "three-part") as tracking,
        ):
            next(tracking)
            _steps(tracking, spent_s, clock_s)
    frame_ms = 1000.0 * float(np.mean(spent_s))
    mean_s = {name: float(np.mean([one[name] for one in clock_s])) for name in clock_s[0]}
    scale = frame_ms / sum(mean_s[name] for name in ("decode", "perception", "tracker"))
    return {
        "fps": 1000.0 / frame_ms,
        "frames": float(len(spent_s)),
        **{f"{name}_ms": scale * each for name, each in mean_s.items()},
    }


def _steps(tracking: Tracking, spent_s: list[float], clock_s: list[dict[str, float]]) -> None:
    before, begun = tracking.stage_s, time.process_time()
    for result in tracking:
        after = tracking.stage_s
        if len(result.tracks["track"]) == PEOPLE:
            spent_s.append(time.process_time() - begun)
            clock_s.append({n: after[n] - before[n] for n in after if n != "learn"})
        before, begun = after, time.process_time()
