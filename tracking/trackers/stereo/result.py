"""A stereo tracker's frame as the columns of a run."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, cloud_shapes
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.shown_boxes import steady_boxes
from tracking.trackers.stereo.boxes import visibility
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.stage_values import AssociatedPeople
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

Floats = NDArray[np.float64]
Float32s = NDArray[np.float32]
Ids = NDArray[np.int32]
Rows = NDArray[np.intp]


def step_result(
    observation: Observation,
    people: Population,
    box: Floats,
    associated: AssociatedPeople,
    view: View,
    reported: NDArray[np.bool_] | None = None,
) -> StepResult:
    """The frame's result: confirmed people only, sorted by track.

    Args:
        box: (people, 4) px of their bodies. associated: who of them is which detection.
        reported: (people,) who of those confirmed is reported; None: everybody.
    """
    pairs, alone, box = associated.pairs, associated.alone, box.copy()
    box[pairs.track] = steady_boxes(
        box[pairs.track], observation.people.box[pairs.detection], alone
    )
    rows = np.flatnonzero(people.confirmed if reported is None else people.confirmed & reported)
    rows = rows[np.argsort(people.track[rows])]
    frame, track = observation.frame, people.track[rows]
    particles, weight = people.particles[rows], people.weight[rows]
    own = _seen_alone(people, pairs, alone)[rows]
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, people, rows, box[rows], view),
        detections=_detections(frame, observation.people, people, pairs),
        particles=_particles(track, particles, weight),
        associations=_associations(frame, people, pairs, associated.costs),
        signals=_signals(frame, track, observation.people, own, cloud_shapes(particles, weight)),
    )


def _tracks(frame: int, people: Population, rows: Rows, box: Floats, view: View) -> Columns:
    """The people at these rows; box: (rows, 4) px, theirs."""
    (x, y), (vx, vy) = people.position[rows].T, people.velocity[rows].T
    values = {
        "frame": np.full(len(rows), frame),
        "track": people.track[rows],
        **box_columns(box),
        "x": x,
        "y": y,
        "vx": vx,
        "vy": vy,
        "confidence": people.confidence[rows],
        "visibility": visibility(box, np.hypot(x, y), view.camera.size),
        "predicted": people.missed_s[rows] > 0.0,
    }
    return typed(values, TRACK_COLUMNS)


def _detections(frame: int, seen: Detections, people: Population, pairs: Association) -> Columns:
    track = np.zeros(len(seen), np.int32)
    track[pairs.detection] = people.track[pairs.track]
    x, y, z = seen.position.T
    values = {
        "frame": np.full(len(seen), frame),
        **box_columns(seen.box),
        "x": x,
        "y": y,
        "z": z,
        "track": track,
    }
    return typed(values, DETECTION_COLUMNS)


def _particles(track: Ids, particles: Float32s, weight: Float32s) -> Columns:
    values = {
        "track": np.repeat(track, weight.shape[1]),
        "x": particles[..., 0].ravel(),
        "y": particles[..., 1].ravel(),
        "weight": weight.ravel(),
    }
    return typed(values, PARTICLE_COLUMNS)


def _associations(frame: int, people: Population, pairs: Association, costs: Costs) -> Columns:
    """Matches of people with an id, sorted by track."""
    track = people.track[pairs.track]
    order = np.argsort(track, kind="stable")
    order = order[track[order] > 0]
    chosen = pairs.track[order], pairs.detection[order]
    values = {
        "frame": np.full(len(order), frame),
        "track": track[order],
        "distance": costs.distance[chosen],
        "colour": costs.colour[chosen],
        "direction": costs.direction[chosen],
        "total": costs.total[chosen],
        "margin": pairs.margin[order],
    }
    return typed(values, ASSOCIATION_COLUMNS)


def _seen_alone(people: Population, pairs: Association, alone: NDArray[np.bool_]) -> Rows:
    """(people,) the detection that shows nobody but this person; -1 without one."""
    detection = np.full(len(people), -1)
    detection[pairs.track[alone]] = pairs.detection[alone]
    return detection


def _signals(
    frame: int, track: Ids, seen: Detections, own: Rows, shapes: tuple[Float32s, Float32s]
) -> Columns:
    """What is noticed of people beside where they are.

    Args:
        own: (people,) the detection that shows nobody else, -1 without one.
        shapes: of their clouds, as `cloud_shapes`.
    """
    spread_m, split = shapes
    height_m = np.append(np.where(seen.truncated, np.nan, seen.size[:, 1]), np.nan)
    clothes = np.append(seen.clothes.reshape(-1, 6), np.full((1, 6), np.nan), axis=0)
    values = {
        "frame": np.full(len(track), frame),
        "track": track,
        "height_m": height_m[own],
        **dict(zip(CLOTHES, clothes[own].T, strict=True)),
        "spread_m": spread_m,
        "split": split,
    }
    return typed(values, SIGNAL_COLUMNS)
