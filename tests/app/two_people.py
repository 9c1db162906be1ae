"""Two people who cross, as tables: track 4 walks right, track 7 walks left, they meet at 50."""

from __future__ import annotations

import numpy as np

from tracking.trackers import StepResult
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    Run,
    TrackTable,
    empty,
)
from tracking.tracks.run import Particles

FRAMES = 100
PARTICLES = 5


def columns(frames: int = FRAMES, tracks: tuple[int, int] = (4, 7)) -> Columns:
    """`TRACK_COLUMNS` of the two; 7 is only predicted in frames 60 to 69 and is late by 10."""
    rows = []
    for frame in range(frames):
        along = (frame - 50) * 0.1
        rows.append((frame, tracks[0], along, 5.0, 1.0, False))
        if frame >= 10:
            rows.append((frame, tracks[1], -along, 5.3, -1.0, 60 <= frame < 70))
    made = empty(TRACK_COLUMNS)
    frame, track, x, y, vx, lost = (np.array(column) for column in zip(*rows, strict=True))
    values = {"frame": frame, "track": track, "x": x, "y": y, "vx": vx, "predicted": lost}
    size = len(frame)
    values |= {"left": 300 + 40 * x, "top": 200 + 2 * y, "width": np.full(size, 30.0)}
    values |= {"height": np.full(size, 80.0), "vy": np.zeros(size)}
    values |= {"confidence": np.full(size, 0.9), "visibility": np.ones(size)}
    return {name: values[name].astype(made[name].dtype) for name in made}


def table() -> TrackTable:
    """The two as a corrected table."""
    return TrackTable(columns())


def run(measured: bool = False) -> Run:
    """The two as a run, with five particles a person, and each row `measured` or none."""
    rows = columns()
    repeated = {name: np.repeat(rows[name], PARTICLES) for name in ("track", "x", "y")}
    weight = np.tile(np.array([0.4, 0.3, 0.1, 0.1, 0.1]), len(rows["frame"]))
    particles = {**repeated, "weight": weight}
    start = np.searchsorted(np.repeat(rows["frame"], PARTICLES), np.arange(FRAMES + 1))
    return Run(
        tracker="stereo-direction",
        settings={},
        seed=0,
        frames=(0, FRAMES),
        tracks=rows,
        detections=_measured(rows) if measured else empty(DETECTION_COLUMNS),
        particles=Particles(
            start.astype(np.int64),
            {name: particles[name].astype(PARTICLE_COLUMNS[name]) for name in PARTICLE_COLUMNS},
        ),
    )


def _measured(rows: Columns) -> Columns:
    """A detection where each row is, half a man's height above the floor."""
    values = {**rows, "z": np.full(len(rows["frame"]), 0.9)}
    return {name: values[name].astype(dtype) for name, dtype in DETECTION_COLUMNS.items()}


def steps() -> list[StepResult]:
    """The two as a tracker at work gives them."""
    made = run()
    rows = made.tracks
    results = []
    for frame in range(FRAMES):
        here = rows["frame"] == frame
        tracks = {name: column[here] for name, column in rows.items()}
        particles = made.particles.of_frame(frame)
        results.append(
            StepResult(
                frame, tracks, empty(DETECTION_COLUMNS), particles, empty(ASSOCIATION_COLUMNS)
            )
        )
    return results
