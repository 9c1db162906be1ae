"""Counts in real footage: passages seen by eye, and tracks that others have drawn."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.flow.counts import JITTER_M, TRACKERS, counts_of
from tests.benchmarks.rendered_clips import run_of
from tracking.counting import Passages, passages
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.tracks import CountingLine, Region

OVERHEAD = "overhead-real"
BY_EYE = ((20, 110, False), (180, 320, True), (380, 470, False), (480, 570, False))
"""First frame, last frame, from left to right: the passages in the overhead recording."""

BELOW = CountingLine("below the camera", (0.0, -3.0), (0.0, 3.0))
"""Forward is from left to right."""

TWO_EYES = "stereo-direction"
"""To compare with, where both cameras are there."""

PETS = "pets-s2l1-real"
PETS_LINES = (
    CountingLine("along", (3.0, 11.0), (3.0, 36.0)),
    CountingLine("across", (12.5, 25.0), (-9.5, 25.0)),
)
PETS_REGION = Region("middle", ((-2.0, 20.0), (8.0, 20.0), (8.0, 30.0), (-2.0, 30.0)))


def measure(data: Path) -> dict[str, Any]:
    """What is counted in the real recordings that are there."""
    found: dict[str, Any] = {}
    if (data / OVERHEAD / "recording.toml").is_file():
        found["overhead"] = [
            _overhead(data / OVERHEAD, tracker) for tracker in (*TRACKERS, TWO_EYES)
        ]
    if (data / PETS / "truth.txt").is_file():
        truth = read_mot(data / PETS / "truth.txt")
        found["pets"] = [
            counts_of(data / PETS, tracker, truth, PETS_LINES, PETS_REGION) for tracker in TRACKERS
        ]
    return found


def _overhead(folder: Path, tracker: str) -> dict[str, Any]:
    with open_recording(folder) as recording:
        fps = recording.fps
    found = passages(run_of(folder, tracker).tracks, fps, [BELOW], jitter_m=JITTER_M)
    hit = hits_by_eye(found)
    return {
        "tracker": tracker,
        "happened": len(BY_EYE),
        "found": len(found),
        "hit": hit,
        "passages": [
            (int(frame), bool(ahead))
            for frame, ahead in zip(found.frame, found.forward, strict=True)
        ],
    }


def hits_by_eye(found: Passages, seen: Sequence[tuple[int, int, bool]] = BY_EYE) -> int:
    """How many passages seen by eye were found in their time and direction; each found one once."""
    free = np.ones(len(found), bool)
    hit = 0
    for first, last, rightward in seen:
        fits = free & (found.frame >= first) & (found.frame <= last)
        fits &= found.forward == rightward
        if fits.any():
            free[int(np.argmax(fits))] = False
            hit += 1
    return hit
