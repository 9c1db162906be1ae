"""A frame of a tracker of rectangles as the columns of a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections, Observation
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.result_columns import (
    detection_columns,
    looks_of,
    signal_columns,
    track_columns,
)
from tracking.trackers.three_part.people import Flags, Floats, Indices, Layout, PartPeople
from tracking.tracks import PART_EVIDENCE
from tracking.tracks.columns import (
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    Columns,
    empty,
    typed,
)

_RECTANGLE = ("cx", "cy", "width", "height")
_STEPS_A_PIXEL = 8
"""Particles are kept to an eighth of a pixel, which packs to half."""


@dataclass(frozen=True, slots=True, eq=False)
class Shown:
    """What a frame says of people besides their parts.

    Attributes:
        box: (people, 4) left, top, width, height px.
        inside: (people,) share of that in the picture.
        region: (people,) the detection they are in; -1: none.
        alone: (people,) whether nobody else is in it.
        unseen: (people,) nothing of them was seen.
    """

    box: Floats
    inside: Floats
    region: Indices
    alone: Flags
    unseen: Flags

    def select(self, rows: Indices) -> Shown:
        """Of the people at these rows."""
        return Shown(
            self.box[rows],
            self.inside[rows],
            self.region[rows],
            self.alone[rows],
            self.unseen[rows],
        )


def in_sight(
    people: PartPeople, shown: Shown, which: Flags, layout: Layout
) -> tuple[PartPeople, Shown]:
    """Those people (people,) who are in sight, and what is told of them.

    Where a region is of one person, who has none for a while is seldom where they are expected:
    they are followed on without being told, and gaps are filled when the run is finished.
    """
    rows = np.flatnonzero(which)
    return people.select(rows, layout.filters), shown.select(rows)


def step_result(
    observation: Observation,
    people: PartPeople,
    shown: Shown,
    layout: Layout,
    fps: float,
    kept: int,
) -> StepResult:
    """The frame's result, sorted by track as the people are.

    Args:
        kept: particles of a part that go into the result at most.
    """
    frame = observation.frame
    looks = looks_of(observation.people, np.where(shown.alone, shown.region, -1))
    return StepResult(
        frame=frame,
        tracks=_tracks(frame, people, shown),
        detections=_detections(frame, observation.people, people, shown),
        particles=empty(PARTICLE_COLUMNS),
        associations=empty(ASSOCIATION_COLUMNS),
        signals=signal_columns(frame, people.track, looks, None),
        parts=_parts(frame, people, layout, fps),
        part_particles=_part_particles(people, layout, kept),
    )


def _tracks(frame: int, people: PartPeople, shown: Shown) -> Columns:
    in_sight = 1.0 - people.occluded.mean(axis=1)
    return track_columns(
        frame,
        people.track,
        shown.box,
        people.place,
        np.where(np.isfinite(people.place[:, :1]), people.walk, np.nan),
        confidence=people.similarity.mean(axis=1) * in_sight,
        visibility=shown.inside * in_sight,
        predicted=shown.unseen | people.occluded.all(axis=1),
    )


def _detections(frame: int, seen: Detections, people: PartPeople, shown: Shown) -> Columns:
    track = np.zeros(len(seen), np.int32)
    own = shown.alone & (shown.region >= 0)
    track[shown.region[own]] = people.track[own]
    return detection_columns(frame, seen.box, seen.position, track)


def _parts(frame: int, people: PartPeople, layout: Layout, fps: float) -> Columns:
    if layout.parts == 1:
        return empty(PART_COLUMNS)
    rows = people.occluded.size
    count = np.repeat(people.clouds.count, layout.together)
    filtered = np.isfinite(people.entropy).ravel()
    values = {
        "frame": np.full(rows, frame),
        "track": np.repeat(people.track, layout.parts),
        "part": np.tile(np.arange(layout.parts), len(people)),
        **dict(zip(_RECTANGLE, people.rectangles.reshape(-1, 4).T, strict=True)),
        "vx": people.state[..., 4].ravel() / fps,
        "vy": people.state[..., 5].ravel() / fps,
        "failed": people.failed.ravel(),
        "score": people.score.ravel(),
        "entropy": people.entropy.ravel(),
        "particles": np.where(filtered, count, 0),
        "occluded": people.occluded.ravel(),
        **dict(
            zip(PART_EVIDENCE, people.evidence.reshape(rows, len(PART_EVIDENCE)).T, strict=True)
        ),
    }
    return typed(values, PART_COLUMNS)


def _part_particles(people: PartPeople, layout: Layout, kept: int) -> Columns:
    """An even choice of every filter's particles, a row for each rectangle they hold.

    Of a person followed whole the part is 0.
    """
    clouds = people.clouds
    few = np.minimum(clouds.count, kept)
    if not few.any():
        return empty(PART_PARTICLE_COLUMNS)
    owner = np.repeat(np.arange(len(few)), few)
    turn = np.arange(few.sum()) - np.repeat(np.cumsum(few) - few, few)
    rows = clouds.start[owner] + turn * clouds.count[owner] // few[owner]
    weight = clouds.weight[rows].astype(np.float64)
    weight /= np.maximum(np.bincount(owner, weight, len(few)), 1e-30)[owner]
    place = np.rint(clouds.state[rows, :, :2] * _STEPS_A_PIXEL) / _STEPS_A_PIXEL
    part = owner[:, None] % layout.filters * layout.together + np.arange(layout.together)
    order = np.argsort(_part_row(owner, part, layout), axis=None, kind="stable")
    values = {
        "track": np.repeat(people.track[owner // layout.filters], layout.together)[order],
        "part": part.ravel()[order],
        "u": place[..., 0].ravel()[order],
        "v": place[..., 1].ravel()[order],
        "weight": np.repeat(weight, layout.together)[order],
    }
    return typed(values, PART_PARTICLE_COLUMNS)


def _part_row(owner: Indices, part: NDArray[np.intp], layout: Layout) -> NDArray[np.intp]:
    """(particles, together) the number of the part among those of all people."""
    return np.asarray(owner[:, None] // layout.filters * layout.parts + part)
