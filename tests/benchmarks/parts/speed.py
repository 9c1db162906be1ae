"""How fast body parts are tracked on one core: decoded frames in, parts and particles out."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

import cv2
import numpy as np

from tests.benchmarks.parts.clips import TUNED, folder_of
from tracking.pipeline import Tracking, track
from tracking.recording import open_recording
from tracking.trackers.three_part.tracker import PartTracker

PEOPLE = 5
"""Only frames with so many people tracked count."""
_STAGES = {
    "filters": "_filtered",
    "failures": "_put_right",
    "births": "_with_newcomers",
    "boxes": "_seen",
}
"""Steps of the tracker, by the methods that do them; colours and columns are the rest."""


def measure() -> dict[str, float | None]:
    """Frames a second of processor time at 720x480, and milliseconds of it a frame and a stage.

    The time is the whole process's, with one thread in OpenCV, so that other work on the machine
    does not count; it is shared out among the stages by their share of the clock.
    """
    cv2.setNumThreads(1)
    spent_s: list[float] = []
    clock_s: list[dict[str, float]] = []
    with _timed() as inner:
        for clip in TUNED:
            with (
                open_recording(folder_of(clip)) as recording,
                track(recording, "three-part") as tracking,
            ):
                next(tracking)
                _steps(tracking, inner, spent_s, clock_s)
    frame_ms = 1000.0 * float(np.mean(spent_s))
    mean_s = {name: float(np.mean([one[name] for one in clock_s])) for name in clock_s[0]}
    scale = frame_ms / sum(mean_s[name] for name in ("decode", "perception", "tracker"))
    return {
        "fps": 1000.0 / frame_ms,
        "frames": float(len(spent_s)),
        **{f"{name}_ms": scale * each for name, each in mean_s.items()},
    }


def _steps(
    tracking: Tracking,
    inner: dict[str, float],
    spent_s: list[float],
    clock_s: list[dict[str, float]],
) -> None:
    before, begun = {**tracking.stage_s, **inner}, time.process_time()
    for result in tracking:
        after = {**tracking.stage_s, **inner}
        if len(result.tracks["track"]) == PEOPLE:
            spent_s.append(time.process_time() - begun)
            clock_s.append({n: after[n] - before[n] for n in after if n != "learn"})
        before, begun = after, time.process_time()


@contextmanager
def _timed() -> Iterator[dict[str, float]]:
    """Seconds spent so far in each step of the tracker."""
    seconds = {f"tracker_{name}": 0.0 for name in _STAGES}
    patches = [
        patch.object(PartTracker, method, _timing(getattr(PartTracker, method), name, seconds))
        for name, method in _STAGES.items()
    ]
    for one in patches:
        one.start()
    try:
        yield seconds
    finally:
        for one in patches:
            one.stop()


def _timing(method: Callable[..., Any], name: str, seconds: dict[str, float]) -> Callable[..., Any]:
    def timed(*args: Any) -> Any:
        began = time.perf_counter()
        done = method(*args)
        seconds[f"tracker_{name}"] += time.perf_counter() - began
        return done

    return timed
