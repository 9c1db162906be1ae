"""A run with body parts: where a standing body has them, some of them failing for a while."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracking.tracks import (
    PART_COLUMNS,
    PART_EVIDENCE,
    PART_PARTICLE_COLUMNS,
    Columns,
    Particles,
    Run,
)

SHARES = ((0.0, 0.15), (0.15, 0.52), (0.52, 1.0))
FAILS_EVERY, FAILS_FOR = 20, 5
"""Each part fails for five frames of twenty; a part later than the one above it."""
PARTICLES = 60
HIDDEN_EVERY = 17


def with_parts(run: Run, seed: int = 4101) -> Run:
    """The run as a tracker that follows parts would have made it."""
    parts = parts_of(run.tracks)
    frames = len(run.particles.start) - 1
    return replace(run, parts=parts, part_particles=_particles(parts, frames, seed))


def parts_of(tracks: Columns) -> Columns:
    """`PART_COLUMNS` of the rows' people, in the order of the rows, then parts."""
    rows = np.repeat(np.arange(len(tracks["frame"])), 3)
    part = np.tile(np.arange(3), len(tracks["frame"]))
    frame, (upper, lower) = tracks["frame"][rows], np.array(SHARES)[part].T
    height, age = tracks["height"][rows], (frame + 6 * part + tracks["track"][rows]) % FAILS_EVERY
    hidden = (frame + tracks["track"][rows]) % HIDDEN_EVERY == 0
    failed = (age < FAILS_FOR) & ~hidden
    values = {
        "frame": frame,
        "track": tracks["track"][rows],
        "part": part,
        "cx": tracks["left"][rows] + tracks["width"][rows] / 2 + 12.0 * failed,
        "cy": tracks["top"][rows] + height * (upper + lower) / 2,
        "width": tracks["width"][rows] * 0.7,
        "height": height * (lower - upper),
        "vx": np.zeros(len(rows)),
        "vy": np.zeros(len(rows)),
        "failed": failed,
        "score": np.where(failed, 1.2, -0.8) + 0.3 * np.sin(frame / 3.0 + part),
        "entropy": 0.55 + 0.3 * np.sin(frame / 7.0 + part),
        "particles": 300 + 100 * part + 40 * (frame % 5),
        "occluded": hidden,
    }
    values |= {name: np.where(failed, 0.1, 0.9) for name in PART_EVIDENCE}
    return {name: np.asarray(values[name]).astype(kind) for name, kind in PART_COLUMNS.items()}


def _particles(parts: Columns, frames: int, seed: int) -> Particles:
    rng = np.random.default_rng(seed)
    rows = np.repeat(np.arange(len(parts["frame"])), PARTICLES)
    values = {
        "track": parts["track"][rows],
        "part": parts["part"][rows],
        "u": parts["cx"][rows] + rng.normal(0.0, 4.0, len(rows)),
        "v": parts["cy"][rows] + rng.normal(0.0, 4.0, len(rows)),
        "weight": rng.random(len(rows)) / PARTICLES,
    }
    start = np.searchsorted(parts["frame"][rows], np.arange(frames + 1))
    columns = {name: values[name].astype(kind) for name, kind in PART_PARTICLE_COLUMNS.items()}
    return Particles(start.astype(np.int64), columns)
