"""A stereo tracker's frame as the columns of a run."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, cloud_shapes
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.result_columns import (
    detection_columns,
    looks_of,
    particle_columns,
    signal_columns,
    track_columns,
)
from tracking.trackers.shared.shown_boxes import steady_boxes
from tracking.trackers.stereo.boxes import visibility
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.stage_values import AssociatedPeople
from tracking.tracks.columns import Columns, typed

Floats = NDArray[np.float64]
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
    looks = looks_of(observation.people, _seen_alone(people, pairs, alone)[rows])
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, people, rows, box[rows], view),
        detections=_detections(frame, observation.people, people, pairs),
        particles=particle_columns(track, particles, weight),
        associations=_associations(frame, people, pairs, associated.costs),
        signals=signal_columns(frame, track, looks, cloud_shapes(particles, weight)),
    )


def _tracks(frame: int, people: Population, rows: Rows, box: Floats, view: View) -> Columns:
    """The people at these rows; box: (rows, 4) px, theirs."""
    place = people.position[rows]
    return track_columns(
        frame,
        people.track[rows],
        box,
        place,
        people.velocity[rows],
        confidence=people.confidence[rows],
        visibility=visibility(box, np.hypot(*place.T), view.camera.size),
        predicted=people.missed_s[rows] > 0.0,
    )


def _detections(frame: int, seen: Detections, people: Population, pairs: Association) -> Columns:
    track = np.zeros(len(seen), np.int32)
    track[pairs.detection] = people.track[pairs.track]
    return detection_columns(frame, seen.box, seen.position, track)


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
