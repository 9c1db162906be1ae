"""A frame of the spheroid tracker as the columns of a run."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.filtering import cloud_shapes
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.spheroid.appearance import bgr_of
from tracking.trackers.spheroid.hypotheses import SpheroidPeople
from tracking.tracks.columns import (
    CLOTHES,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    box_columns,
    empty,
    typed,
)


def step_result(
    frame: int, people: SpheroidPeople, box: NDArray[np.float64], clothes: NDArray[np.float32]
) -> StepResult:
    """The frame's result; the people are sorted by track.

    What was measured of those who are seen stands among the detections, as this tracker explains
    the picture by people and has no detections before.

    Args:
        box: (people, 4) left, top, width, height px as recorded.
        clothes: (people, 6) CIELAB of upper and lower body; NaN: not known.
    """
    missed = people.missed_s > 0.0
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, people, box, missed),
        detections=_detections(frame, people, box, np.flatnonzero(~missed)),
        particles=_particles(people),
        associations=empty(ASSOCIATION_COLUMNS),
        signals=_signals(frame, people, clothes),
    )


def clothes_of(people: SpheroidPeople) -> NDArray[np.float32]:
    """(people, 6) CIELAB of upper and lower body as they are known; NaN where they are not."""
    colour = np.full((len(people), 2, 3), np.nan, np.float32)
    if len(people) == 0:
        return colour.reshape(0, 6)
    for half, cells in enumerate((slice(1, 4), slice(4, 7))):
        seen = people.counts[:, cells].sum(axis=1) > 0
        colour[seen, half] = bgr_of(people.appearance[seen, cells].mean(axis=1))
    lab = cv2.cvtColor(np.clip(np.nan_to_num(colour) / 255.0, 0, 1), cv2.COLOR_BGR2Lab)
    return np.where(np.isnan(colour), np.nan, lab).reshape(-1, 6)


def _tracks(
    frame: int, people: SpheroidPeople, box: NDArray[np.float64], missed: NDArray[np.bool_]
) -> Columns:
    values = {
        "frame": np.full(len(people), frame),
        "track": people.track,
        **box_columns(box),
        **dict(zip(("x", "y", "vx", "vy"), people.mean.T, strict=True)),
        "confidence": np.clip(people.coverage * people.shown, 0.0, 1.0),
        "visibility": np.clip(people.shown, 0.0, 1.0),
        "predicted": missed,
    }
    return typed(values, TRACK_COLUMNS)


def _detections(
    frame: int, people: SpheroidPeople, box: NDArray[np.float64], rows: NDArray[np.intp]
) -> Columns:
    values = {
        "frame": np.full(len(rows), frame),
        **box_columns(box[rows]),
        "x": people.xy[rows, 0],
        "y": people.xy[rows, 1],
        "z": people.height[rows] / 2,
        "track": people.track[rows],
    }
    return typed(values, DETECTION_COLUMNS)


def _particles(people: SpheroidPeople) -> Columns:
    values = {
        "track": np.repeat(people.track, people.weight.shape[1]),
        "x": people.state[..., 0].ravel(),
        "y": people.state[..., 1].ravel(),
        "weight": people.weight.ravel(),
    }
    return typed(values, PARTICLE_COLUMNS)


def _signals(frame: int, people: SpheroidPeople, clothes: NDArray[np.float32]) -> Columns:
    spread_m, split = cloud_shapes(people.state[..., :2], people.weight)
    values = {
        "frame": np.full(len(people), frame),
        "track": people.track,
        "height_m": people.height,
        **dict(zip(CLOTHES, clothes.T, strict=True)),
        "spread_m": spread_m,
        "split": split,
    }
    return typed(values, SIGNAL_COLUMNS)
