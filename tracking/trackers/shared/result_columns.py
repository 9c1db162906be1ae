"""A frame's people, what was seen and particles as the columns of a run."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.tracks.columns import (
    CLOTHES,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    box_columns,
    typed,
)

Values = NDArray[Any]


def track_columns(
    frame: int | Values,
    track: Values,
    box: Values,
    place: Values,
    velocity: Values,
    *,
    confidence: float | Values,
    visibility: float | Values,
    predicted: bool | Values,
) -> Columns:
    """`TRACK_COLUMNS` of people: box (n, 4) px, place (n, 2) m, velocity (n, 2) m/s."""
    (x, y), (vx, vy) = place.T, velocity.T
    moving = {"x": x, "y": y, "vx": vx, "vy": vy}
    told = {"confidence": confidence, "visibility": visibility, "predicted": predicted}
    alike = {name: np.broadcast_to(value, track.shape) for name, value in told.items()}
    every = np.broadcast_to(frame, track.shape)
    values = {"frame": every, "track": track, **box_columns(box), **moving, **alike}
    return typed(values, TRACK_COLUMNS)


def detection_columns(frame: int | Values, box: Values, position: Values, track: Values) -> Columns:
    """`DETECTION_COLUMNS` of boxes (n, 4) px at positions (n, 3) m, of these tracks; 0: none."""
    x, y, z = position.T
    every = np.broadcast_to(frame, track.shape)
    values = {"frame": every, **box_columns(box), "x": x, "y": y, "z": z, "track": track}
    return typed(values, DETECTION_COLUMNS)


def particle_columns(track: Values, place: Values, weight: Values) -> Columns:
    """`PARTICLE_COLUMNS` of places (people, N, 2 or more) m with weights (people, N)."""
    values = {
        "track": np.repeat(track, weight.shape[1]),
        "x": place[..., 0].ravel(),
        "y": place[..., 1].ravel(),
        "weight": weight.ravel(),
    }
    return typed(values, PARTICLE_COLUMNS)


def signal_columns(
    frame: int, track: Values, looks: tuple[Values, Values], shapes: tuple[Values, Values] | None
) -> Columns:
    """`SIGNAL_COLUMNS` of people.

    Args:
        looks: heights (n,) m and clothes (n, 6); NaN: not known.
        shapes: of their clouds, as `cloud_shapes`; None: they have none on the floor.
    """
    height_m, clothes = looks
    spread_m, split = shapes or np.full((2, len(track)), np.nan)
    values = {
        "frame": np.broadcast_to(frame, track.shape),
        "track": track,
        "height_m": height_m,
        **dict(zip(CLOTHES, clothes.T, strict=True)),
        "spread_m": spread_m,
        "split": split,
    }
    return typed(values, SIGNAL_COLUMNS)


def looks_of(seen: Detections, own: NDArray[np.intp]) -> tuple[Values, Values]:
    """Heights (n,) m and clothes (n, 6) of these detections, NaN where not known; -1: of none."""
    height_m = np.append(np.where(seen.truncated, np.nan, seen.size[:, 1]), np.nan)
    clothes = np.append(seen.clothes.reshape(-1, 6), np.full((1, 6), np.nan), axis=0)
    return height_m[own], clothes[own]
