"""The direction people walk in: where it is taken from, and what a turn costs."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import direction_cost, turning_angle
from tracking.trackers.population import Population

Floats = NDArray[np.float64]


class DirectionSettings(Protocol):
    """The settings of the direction cue."""

    @property
    def direction_weight(self) -> float:
        """Cost of a turn by the threshold or more."""

    @property
    def direction_threshold_rad(self) -> float:
        """Turn from which on the cost no longer grows."""

    @property
    def direction_step_m(self) -> float:
        """How far apart the positions are that a direction is taken between."""

    @property
    def direction_memory_s(self) -> float:
        """A person who takes longer for that distance is standing."""


def turning_cost(people: Population, measured: Floats, settings: DirectionSettings) -> Floats:
    """Da of every pair (people, detections): how much the way there turns from the way walked.

    The way to a detection starts at the newer anchor, or at the older one where the detection
    is too close to the newer to give a direction. NaN where a direction is missing.
    """
    older, newer = people.anchors[:, 0], people.anchors[:, 1]
    standing = people.anchor_age_s > settings.direction_memory_s
    walked = np.where(standing[:, None], np.nan, newer - older)
    from_newer = measured[None] - newer[:, None]
    too_close = np.hypot(from_newer[..., 0], from_newer[..., 1]) < settings.direction_step_m
    way = np.where(too_close[..., None], measured[None] - older[:, None], from_newer)
    angle = turning_angle(walked, way)
    return direction_cost(angle, settings.direction_threshold_rad, settings.direction_weight)


def walked_on(people: Population, elapsed_s: float, step_m: float) -> Population:
    """Where a person is becomes the newer anchor once it is far enough from the last."""
    newer = people.anchors[:, 1]
    gone = people.position - newer
    seen = people.missed_s == 0.0
    far = seen & (np.hypot(gone[:, 0], gone[:, 1]) >= step_m)
    moved = np.stack((newer, people.position), axis=1)
    return people.replace(
        anchors=np.where(far[:, None, None], moved, people.anchors),
        anchor_age_s=np.where(far, 0.0, people.anchor_age_s + elapsed_s),
    )
