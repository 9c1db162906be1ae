"""A frame of the spheroid tracker as the columns of a run."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.filtering import cloud_shapes
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.result_columns import (
    detection_columns,
    particle_columns,
    signal_columns,
    track_columns,
)
from tracking.trackers.spheroid.appearance import bgr_of
from tracking.trackers.spheroid.hypotheses import SpheroidPeople
from tracking.tracks.columns import Columns, empty


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
    missed, track = people.missed_s > 0.0, people.track
    middle = np.column_stack((people.xy, people.height / 2))
    shapes = cloud_shapes(people.state[..., :2], people.weight)
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, people, box, missed),
        detections=detection_columns(frame, box[~missed], middle[~missed], track[~missed]),
        particles=particle_columns(track, people.state, people.weight),
        associations=empty(ASSOCIATION_COLUMNS),
        signals=signal_columns(frame, track, (people.height, clothes), shapes),
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
    return track_columns(
        frame,
        people.track,
        box,
        people.xy,
        people.mean[:, 2:],
        confidence=np.clip(people.coverage * people.shown, 0.0, 1.0),
        visibility=np.clip(people.shown, 0.0, 1.0),
        predicted=missed,
    )
