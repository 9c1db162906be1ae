"""How fast the whole stereo pipeline is on one core: decoded frames in, stored particles out."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks import peers
from tracking.pipeline import Tracking, track
from tracking.recording import open_recording
from tracking.synthesis import render_recording

SCENE, PEOPLE, SECONDS, SEED = "square", 17, 12.0, 1
"""A scene with about fifteen people in view in the frames that count."""
_KEPT = Path(tempfile.gettempdir()) / f"trackwright-benchmark-{SCENE}-{PEOPLE}-{SEED}"
_IN_VIEW = 13


def recording() -> Path:
    """The benchmark's recording; rendered once and kept in the system's temporary folder."""
    if not (_KEPT / "truth.txt").is_file():
        render_recording(_KEPT, SCENE, SECONDS, PEOPLE, SEED)
    return _KEPT


def measure() -> dict[str, float | None]:
    """Frames a second of processor time, and milliseconds of it a frame and a stage.

    Only frames with about fifteen tracked people count. The time is the whole process's, with one
    thread in OpenCV, so that other work on the machine does not count; it is shared out among the
    stages by their share of the clock. `vs_primitives` and `vs_obvious` are our time over theirs
    (see `peers`): below 1 we are quicker.
    """
    cv2.setNumThreads(1)
    with open_recording(recording()) as opened, track(opened, "stereo-direction") as tracking:
        next(tracking)
        spent_s, stages_s, people = _steps(tracking)
    busy = np.array(people) >= _IN_VIEW
    frame_ms = 1000.0 * float(np.mean(np.array(spent_s)[busy]))
    clock_s = {stage: float(np.mean(np.array(each)[busy])) for stage, each in stages_s.items()}
    scale = frame_ms / sum(clock_s.values())
    return {
        "fps": 1000.0 / frame_ms,
        "people": float(np.mean(np.array(people)[busy])),
        **{f"{stage}_ms": scale * clock for stage, clock in clock_s.items()},
        **_ratios(frame_ms, 1 + np.flatnonzero(busy)),
    }


def _ratios(ours_ms: float, frames: NDArray[np.intp]) -> dict[str, float]:
    """Our time over the peers' on the same frames of the recording."""
    with open_recording(recording()) as opened:
        works = {"primitives": peers.primitives(opened), "obvious": peers.obvious(opened)}
        return {
            f"vs_{name}": ours_ms / peers.frame_ms(opened, work, frames.tolist())
            for name, work in works.items()
        }


def _steps(tracking: Tracking) -> tuple[list[float], dict[str, list[float]], list[int]]:
    """Per frame: processor seconds, seconds of the clock of each stage, people tracked."""
    spent_s: list[float] = []
    stages_s: dict[str, list[float]] = {"decode": [], "perception": [], "tracker": []}
    people: list[int] = []
    before, begun = tracking.stage_s, time.process_time()
    for result in tracking:
        spent_s.append(time.process_time() - begun)
        for stage, each in stages_s.items():
            each.append(tracking.stage_s[stage] - before[stage])
        people.append(len(result.tracks["track"]))
        before, begun = tracking.stage_s, time.process_time()
    return spent_s, stages_s, people
