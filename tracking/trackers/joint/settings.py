"""The settings of the joint stereo tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting
from tracking.trackers.stereo.settings import StereoFilterSettings
from tracking.trackers.stereo.walking_direction import WalkingSettings


@dataclass(frozen=True, slots=True)
class JointSettings(WalkingSettings, StereoFilterSettings):
    """Settings of `stereo-joint`."""

    confirm_s: float = setting(
        0.1,
        "s",
        (0.0, 10.0),
        "Seconds of detections after which a tentative track is confirmed; higher: fewer false "
        "tracks, which start later",
        group="Track management",
        expert=True,
    )
    report_s: float = setting(
        0.5,
        "s",
        (0.05, 60.0),
        "Seconds a track in plain view is reported without a detection. After that it coasts "
        "unreported, and keeps its id when the person is detected again; higher: longer guesses",
        formerly=("lost_after_s",),
        group="Track management",
    )
    report_occluded_s: float = setting(
        4.0,
        "s",
        (0.05, 60.0),
        "Seconds an occluded track is reported without a detection; higher: longer guesses "
        "behind other people",
        formerly=("lost_hidden_s",),
        group="Track management",
    )
    association_margin: float = setting(
        0.1,
        "",
        (0.0, 5.0),
        "Margin by which a detection must fit one track better than the next, as a difference "
        "in cost (0.1 is 1 nat: 2.7 times as likely); higher: fewer id switches, more gaps",
        formerly=("least_margin",),
        group="Association",
    )
    process_noise: float = setting(
        1.0,
        "m²/s³",
        (0.001, 100.0),
        "Intensity of the process noise: how suddenly people turn, stop and start; higher: "
        "tracks follow turns at once, but are rougher and switch sooner",
        formerly=("agility",),
        group="Particles and motion",
    )
    birth_rate_edge: float = setting(
        1.0,
        "1/m²/s",
        (1e-6, 100.0),
        "Birth rate at the image edge: new people per square metre of floor and second; higher: a"
        " detection there more often starts a new track than continues a coasting one",
        formerly=("new_at_edge",),
        group="Track management",
        expert=True,
    )
    birth_rate_interior: float = setting(
        0.05,
        "1/m²/s",
        (1e-6, 100.0),
        "Birth rate away from the image edge, as through doors or from behind pillars; higher: a "
        "detection there more often starts a new track than continues a coasting one",
        formerly=("new_within",),
        group="Track management",
        expert=True,
    )
    miss_probability: float = setting(
        0.05,
        "",
        (0.001, 0.9),
        "Probability that a person in full view is not detected (1 minus the detection "
        "probability); higher: missed detections cost less",
        formerly=("overlooked",),
        group="Association",
        expert=True,
    )
    appearance_weight: float = setting(
        0.5,
        "",
        (0.0, 4.0),
        "Weight of appearance (clothes and body height) beside position in association; higher: "
        "appearance decides, which fails among people who are dressed alike",
        formerly=("looks_weight",),
        group="Association",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "After tracking, correct ids over the whole recording, smooth positions and boxes, and "
        "fill gaps. Off: the run holds exactly what was tracked live",
    )
    direction_weight: float = setting(
        1.0,
        "nat",
        (0.0, 10.0),
        "Cost of a sharp turn in association, in nats (1 nat: 2.7 times less likely); higher: "
        "people are expected to walk straight on",
        group="Association",
        expert=True,
    )
    coast_s: float = setting(
        8.0,
        "s",
        (0.0, 60.0),
        "Seconds a track away from the image edge coasts without a detection before it is "
        "deleted; higher: more people get their id back, and more ids go to the wrong person",
        formerly=("remember_s",),
        group="Track management",
    )
    velocity_decay_s: float = setting(
        2.0,
        "s",
        (0.1, 60.0),
        "Time constant with which a coasting track slows down; lower: it is searched for nearer "
        "to its last detection",
        formerly=("slowing_s",),
        group="Particles and motion",
        expert=True,
    )

    @property
    def unseen_limit_s(self) -> float:
        """A track without a detection for longer is unreported, unless it is occluded."""
        return self.report_s
