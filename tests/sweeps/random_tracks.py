"""Tracks at random, and what is known of them and their footage where they are written."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.formats.read_result import with_all_columns
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackLabel, TrackTable

SIZE_PX = (640, 480)
BOX = ("left", "top", "width", "height")
FLOOR = ("x", "y")


def random_tracks(seed: int | list[int], frames: int, people: int) -> TrackTable:
    """People who come, vanish for a while and go; some rows without box, some without place."""
    random = np.random.default_rng(seed)
    frame, track = np.nonzero(random.random((frames, people)) < 0.7)
    count = len(frame)
    rows: dict[str, NDArray[Any]] = {
        "frame": frame,
        "track": np.sort(random.choice(10_000, people, replace=False) + 1)[track],
        **{name: random.normal(300, 90, count) for name in ("left", "top")},
        **{name: random.uniform(0.1, 200, count) for name in ("width", "height")},
        **{name: random.normal(0, 9, count) for name in ("x", "y", "vx", "vy")},
        "visibility": random.random(count),
        "source": random.integers(0, 3, count),
    }
    for names in (BOX, FLOOR):
        lost = random.random(count) < 0.1
        for name in names:
            rows[name][lost] = np.nan
    return TrackTable(with_all_columns(rows))


def exported(made: TrackTable, frames: int) -> Exported:
    """With what is known of the footage and of some people."""
    names = TrackLabel('Zoë "<&>', {"bag": "yes"}), TrackLabel("", {"class": "dog"})
    labels = dict(zip(made.track_ids, names, strict=False))
    return Exported.of_table(
        made, frames=frames, fps=12.5, size_px=SIZE_PX, name="yard", labels=labels
    )
