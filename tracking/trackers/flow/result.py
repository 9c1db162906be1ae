"""A frame of the flow tracker as the columns of a run."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.flow.point_tracker import Tracklets
from tracking.trackers.flow.silhouettes import USUAL_HEIGHT_M
from tracking.trackers.flow.walkers import Walkers
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.result_columns import detection_columns, track_columns
from tracking.tracks.columns import (
    PARTICLE_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    empty,
    typed,
)

Floats = NDArray[np.float64]

BODY_WIDTH_M = 0.55
CHEST_M = 1.1
PLENTY = 8
"""Tracklets with which somebody is as sure as can be."""


def step_result(
    frame: int,
    walkers: Walkers,
    tracklets: Tracklets,
    owner: NDArray[np.int32],
    foot_v: NDArray[np.float32],
    view: View,
) -> StepResult:
    """The frame's result.

    Nobody is detected apart from being followed: detections are the people themselves, where
    something is seen of them.

    Args:
        owner: (n,) the track each tracklet belongs to; 0: none.
        foot_v: (n,) px where the foreground below each ends, see `foot_lines`.
    """
    seen = walkers.missed_s == 0.0
    box = view.box_of_person(walkers.place, USUAL_HEIGHT_M, BODY_WIDTH_M)
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, walkers, seen, box, view),
        detections=_detections(frame, walkers, seen, box),
        particles=empty(PARTICLE_COLUMNS),
        associations=empty(ASSOCIATION_COLUMNS),
        tracklets=_tracklets(tracklets, owner, foot_v),
    )


def _tracks(
    frame: int, walkers: Walkers, seen: NDArray[np.bool_], box: Floats, view: View
) -> Columns:
    sure = np.minimum(walkers.count / PLENTY, 1.0)
    return track_columns(
        frame,
        walkers.track,
        box,
        walkers.place,
        walkers.pace,
        confidence=np.where(seen, sure, 0.0),
        visibility=np.where(seen, shown_share(box, view), 0.0),
        predicted=~seen,
    )


def _detections(frame: int, walkers: Walkers, seen: NDArray[np.bool_], box: Floats) -> Columns:
    chest = np.column_stack((walkers.place, np.full(len(walkers), CHEST_M)))
    return detection_columns(frame, box[seen], chest[seen], walkers.track[seen])


def _tracklets(
    tracklets: Tracklets, owner: NDArray[np.int32], foot_v: NDArray[np.float32]
) -> Columns:
    """Those with all their positions, grouped by track."""
    whole = np.flatnonzero(np.isfinite(tracklets.path[:, 2, 0]))
    rows = whole[np.argsort(owner[whole], kind="stable")]
    path = tracklets.path[rows]
    values: dict[str, NDArray[Any]] = {"track": owner[rows], "foot_v": foot_v[rows]}
    for step in range(3):
        values[f"u{step}"], values[f"v{step}"] = path[:, step, 0], path[:, step, 1]
    return typed(values, TRACKLET_COLUMNS)


def shown_share(box: Floats, view: View) -> Floats:
    """(m,) share of the boxes that lies in the picture."""
    low, high = box[:, :2], box[:, :2] + box[:, 2:]
    edge = np.array(view.camera.size, np.float64) - 0.5
    shown = np.minimum(high, edge) - np.maximum(low, -0.5)
    share = np.prod(np.maximum(shown, 0.0) / np.maximum(box[:, 2:], 1e-6), axis=1)
    return np.asarray(np.nan_to_num(share))
