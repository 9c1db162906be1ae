"""What is kept of people: which way they walk, their colours, and what both cost."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import direction_cost, turning_angle
from tracking.setting import setting
from tracking.trackers.stereo.population import Population

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class WalkingSettings:
    """Settings of what [Kawashita2014] keeps up to date of people: their way and their colours.

    Has no room of its own: it is mixed into the settings of trackers, which are slotted.
    """

    __slots__ = ()

    direction_weight: float = setting(
        0.2,
        "",
        (0.0, 10.0),
        "Cost of a sharp turn in association; higher: people are expected to walk straight on",
        group="Association",
    )
    direction_threshold_rad: float = setting(
        1.22,
        "rad",
        (0.01, 3.1416),
        "Angle from which on a turn has its full cost (1.57 is a right angle); higher: turning "
        "back costs more than turning aside",
        group="Association",
        expert=True,
    )
    direction_step_m: float = setting(
        0.4,
        "m",
        (0.05, 5.0),
        "Distance a person must walk before the walking direction is known; higher: steadier, "
        "but turns are noticed later",
        group="Association",
        expert=True,
    )
    direction_timeout_s: float = setting(
        1.5,
        "s",
        (0.1, 60.0),
        "A person who needs longer than this for the direction step stands and has no walking "
        "direction; higher: slow walkers have a direction",
        formerly=("direction_memory_s",),
        group="Association",
        expert=True,
    )
    colour_forgetting_factor: float = setting(
        0.97,
        "",
        (0.0, 1.0),
        "Share of the colour model that remains after each update; higher: the model follows "
        "the light more slowly, and a wrong association harms it less",
        formerly=("colour_memory",),
        group="Association",
        expert=True,
    )


def turning_cost(people: Population, measured: Floats, settings: WalkingSettings) -> Floats:
    """Da of every pair (people, detections): how much the way there turns from the way walked.

    The way to a detection starts at the newer anchor, or at the older one where the detection
    is too close to the newer to give a direction. NaN where a direction is missing.
    """
    older, newer = people.anchors[:, 0], people.anchors[:, 1]
    standing = people.anchor_age_s > settings.direction_timeout_s
    walked = np.where(standing[:, None], np.nan, newer - older)
    from_newer = measured[None] - newer[:, None]
    too_close = np.hypot(from_newer[..., 0], from_newer[..., 1]) < settings.direction_step_m
    way = np.where(too_close[..., None], measured[None] - older[:, None], from_newer)
    angle = turning_angle(walked, way)
    return direction_cost(angle, settings.direction_threshold_rad, settings.direction_weight)


def move_anchors(people: Population, elapsed_s: float, step_m: float) -> Population:
    """Where a person is becomes the newer anchor once it is far enough from the last."""
    newer = people.anchors[:, 1]
    moved_m = people.position - newer
    seen = people.missed_s == 0.0
    far = seen & (np.hypot(moved_m[:, 0], moved_m[:, 1]) >= step_m)
    moved = np.stack((newer, people.position), axis=1)
    return people.replace(
        anchors=np.where(far[:, None, None], moved, people.anchors),
        anchor_age_s=np.where(far, 0.0, people.anchor_age_s + elapsed_s),
    )


@dataclass(frozen=True, slots=True)
class WalkingCues:
    """Colours that follow the person, and the way walked; trackers add what they see of people."""

    settings: WalkingSettings

    def update_colours(
        self, model: NDArray[np.float32], seen: NDArray[np.float32], matches: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """The models after one more match: a running mean, at first of everything seen.

        Args:
            model, seen: (people, cues, bins). matches: (people,) before this one.
        """
        return model + self.newest_share(matches)[:, None, None] * (seen - model)

    def newest_share(self, matches: NDArray[np.int32]) -> NDArray[np.float32]:
        """(people,) the share of one more match in what is known of somebody matched so often."""
        share = np.maximum(1.0 / (matches + 1), 1.0 - self.settings.colour_forgetting_factor)
        return share.astype(np.float32)

    def is_complete(self, matches: NDArray[np.int32]) -> NDArray[np.bool_]:
        """(people,) everybody from the first sighting on."""
        return np.asarray(matches > 0)

    def direction(self, people: Population, measured: Floats) -> Floats:
        """Da of every pair: how much the way to each detection turns from the way walked."""
        return turning_cost(people, measured, self.settings)

    def update_anchors(self, people: Population, elapsed_s: float) -> Population:
        """The people with the positions brought up to date that directions are taken between."""
        return move_anchors(people, elapsed_s, self.settings.direction_step_m)
