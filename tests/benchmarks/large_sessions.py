"""Runs and sessions made up, as long as a day: no images, everybody walks."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.recording import Fingerprint
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Particles,
    Run,
    empty,
)

_STRETCH = 150
"""Every so many frames of a track a short stretch is predicted, and another one is missing."""


@dataclass(frozen=True)
class NoPictures:
    """A recording as far as a session asks for one."""

    folder: Path
    name: str = "benchmark"
    fps: float = 30.0
    frame_count: int = 864_000
    size: tuple[int, int] = (640, 480)
    is_stereo: bool = True
    manifest_text: str = ""
    own_manifest: bool = True
    calibration_text: str = ""

    def fingerprints(self) -> tuple[Fingerprint, ...]:
        return ()


def crowd(rows: int, tracks: int, frames: int, particles: int = 0, seed: int = 3100) -> Run:
    """A run of about so many rows: tracks of equal length, begun all over the recording.

    Each has short stretches that are predicted and gaps. Values change from frame to frame as
    those of walking people do, so that they pack as well. `particles` stand in every frame.
    """
    rng = np.random.default_rng(seed)
    length = min(round(rows / tracks * _STRETCH / (_STRETCH - 5)), frames)
    begun = np.sort(rng.integers(0, frames - length + 1, tracks))
    frame = (begun[:, None] + np.arange(length)).astype(np.int32)
    track = np.broadcast_to(np.arange(1, tracks + 1, dtype=np.int32)[:, None], frame.shape)
    phase = (frame + 37 * track) % _STRETCH
    there = phase >= 5
    frame, track, phase = frame[there], track[there], phase[there]
    order = np.argsort(frame, kind="stable")
    frame, track, phase = frame[order], track[order], phase[order]
    values = _walking(frame, track, phase)
    return Run(
        tracker="benchmark",
        settings={},
        seed=seed,
        frames=(0, frames),
        tracks={name: values[name].astype(dtype) for name, dtype in TRACK_COLUMNS.items()},
        detections=empty(DETECTION_COLUMNS),
        particles=_cloud(frames, particles, rng),
        associations=empty(ASSOCIATION_COLUMNS),
        software="",
    )


def _walking(
    frame: NDArray[np.int32], track: NDArray[np.int32], phase: NDArray[np.int32]
) -> dict[str, NDArray[Any]]:
    """Columns of people who walk in circles; a stretch of each is predicted."""
    angle = frame / 40.0 + track
    return {
        "frame": frame,
        "track": track,
        "left": 300 + 200 * np.cos(angle),
        "top": 200 + 90 * np.sin(angle),
        "width": 40 + 5 * np.sin(angle),
        "height": 120 + 15 * np.sin(angle),
        "x": 3 * np.cos(angle),
        "y": 6 + 3 * np.sin(angle),
        "vx": -3 * np.sin(angle),
        "vy": 3 * np.cos(angle),
        "confidence": 0.5 + 0.5 * np.sin(angle) ** 2,
        "visibility": np.ones(len(frame)),
        "predicted": phase < 15,
    }


def _cloud(frames: int, each: int, rng: np.random.Generator) -> Particles:
    if not each:
        return Particles(np.zeros(frames + 1, np.int64), empty(PARTICLE_COLUMNS))
    rows = frames * each
    values = {
        "track": np.ones(rows, np.int32),
        "x": rng.normal(0, 0.2, rows).astype(np.float32),
        "y": rng.normal(6, 0.2, rows).astype(np.float32),
        "weight": np.full(rows, 1 / each, np.float32),
    }
    return Particles(np.arange(frames + 1, dtype=np.int64) * each, values)
