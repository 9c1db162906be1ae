"""The settings that stereo trackers share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from tracking.detections import DetectionSettings
from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting, stage
from tracking.stereo import StereoSettings


@dataclass(frozen=True, slots=True)
class StereoFilterSettings(ABC):
    """What every stereo tracker can be told; see the `help` of each field."""

    particles: int = setting(
        500,
        "",
        (10, 20000),
        "Particles per person; higher: tracking in crowds is more reliable but takes more time",
        group="Particles and motion",
    )
    initial_spread_m: float = setting(
        0.25,
        "m",
        (0.01, 2.0),
        "Standard deviation of a tentative track's particles around its first detection; higher: "
        "the next detection is matched more reliably, but neighbours are mixed up sooner",
        formerly=("start_spread_m",),
        group="Particles and motion",
        expert=True,
    )
    measurement_noise_m: float = setting(
        0.12,
        "m",
        (0.01, 2.0),
        "Standard deviation of a measured position close to the cameras; higher: tracks are "
        "smoother, but follow turns later",
        formerly=("sigma_near_m",),
        group="Particles and motion",
        expert=True,
    )
    measurement_noise_growth: float = setting(
        0.001,
        "m/m²",
        (0.0, 0.1),
        "Growth of the measurement noise with the square of the distance; higher: far "
        "detections count less",
        formerly=("sigma_range",),
        group="Particles and motion",
        expert=True,
    )
    min_visibility: float = setting(
        0.3,
        "",
        (0.0, 1.0),
        "Smallest expected visible share of a body; below it a track counts as occluded by other "
        "people; higher: more tracks count as occluded, and coast longer",
        formerly=("hidden_below",),
        group="Track management",
        expert=True,
    )
    negative_information_s: float = setting(
        0.2,
        "s",
        (0.01, 60.0),
        "Time constant with which the particles of a person without a detection move to places "
        "that other people occlude; higher: they move more slowly",
        formerly=("unseen_s",),
        group="Track management",
        expert=True,
    )
    association_margin: float = setting(
        0.2,
        "",
        (0.0, 5.0),
        "Margin by which a detection must fit one track better than the next, as a difference "
        "in cost; higher: fewer id switches, more gaps",
        formerly=("least_margin",),
        group="Association",
    )
    colour_update_distance_m: float = setting(
        0.6,
        "m",
        (0.0, 5.0),
        "The colour model of a track is updated only while no other person is closer than this; "
        "higher: cleaner colour models, updated less often",
        formerly=("colour_distance_m",),
        group="Association",
        expert=True,
    )
    confirm_matches: int = setting(
        3,
        "",
        (1, 100),
        "Detections after which a tentative track is confirmed; higher: fewer false tracks, "
        "which start later",
        group="Track management",
    )
    birth_distance_m: float = setting(
        0.5,
        "m",
        (0.0, 5.0),
        "Smallest distance of a new tentative track to another track; higher: fewer duplicate "
        "tracks, but people who arrive in pairs are found later",
        group="Track management",
        expert=True,
    )
    delete_at_edge_s: float = setting(
        0.5,
        "s",
        (0.05, 60.0),
        "Seconds before a track that was lost at the image edge is deleted; lower: people who "
        "leave are deleted sooner",
        formerly=("lost_at_edge_s",),
        group="Track management",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "After tracking, smooth positions and boxes forward and backward, and fill gaps. Off: "
        "the run holds exactly what was tracked live",
    )
    foreground: ForegroundSettings = stage(ForegroundSettings)
    stereo: StereoSettings = stage(StereoSettings)
    people: PeopleSettings = stage(PeopleSettings)
    detections: DetectionSettings = stage(DetectionSettings)

    @property
    @abstractmethod
    def unseen_limit_s(self) -> float:
        """A track without a detection for longer is unreported, unless it is occluded."""


@dataclass(frozen=True, slots=True)
class StereoTrackerSettings(StereoFilterSettings):
    """What a tracker that sums up the costs of the papers' cues can be told."""

    delete_after_s: float = setting(
        1.5,
        "s",
        (0.05, 60.0),
        "Seconds without a detection after which a track is deleted; higher: fewer "
        "fragmentations, longer guesses",
        formerly=("lost_after_s",),
        group="Track management",
    )
    delete_occluded_s: float = setting(
        4.0,
        "s",
        (0.05, 60.0),
        "Seconds without a detection after which an occluded track is deleted; higher: tracks "
        "wait longer behind other people",
        formerly=("lost_hidden_s",),
        group="Track management",
    )
    process_noise_m: float = setting(
        0.25,
        "m",
        (0.01, 3.0),
        "Process noise: standard deviation of a person's position after one second; higher: "
        "tracks follow sudden turns, but neighbours are mixed up sooner",
        formerly=("spread_m",),
        group="Particles and motion",
    )
    process_noise_growth: float = setting(
        1.0,
        "1/s",
        (0.0, 10.0),
        "Growth of the process noise with each second without a detection; higher: people are "
        "searched for in a wider area",
        formerly=("spread_growth",),
        group="Particles and motion",
        expert=True,
    )
    velocity_average_s: float = setting(
        0.4,
        "s",
        (0.05, 5.0),
        "Time over which the velocity is averaged; higher: steadier, but turns and stops are "
        "noticed later",
        formerly=("velocity_memory_s",),
        group="Particles and motion",
        expert=True,
    )
    gate_m: float = setting(
        0.9,
        "m",
        (0.1, 5.0),
        "Gate: largest distance of a detection from the predicted position; higher: fast walkers "
        "are kept, but ids switch sooner",
        group="Association",
    )
    gate_growth: float = setting(
        1.0,
        "1/s",
        (0.0, 10.0),
        "Growth of the gate with each second without a detection; higher: people are searched "
        "for in a wider area",
        group="Association",
        expert=True,
    )
    cost_limit: float = setting(
        2.0,
        "",
        (0.1, 10.0),
        "Highest cost at which a detection is associated with a track; higher: fewer gaps, more "
        "id switches",
        group="Association",
        expert=True,
    )
    distance_weight: float = setting(
        2.0,
        "1/m",
        (0.0, 20.0),
        "Cost of each metre between detection and predicted position; higher: position decides",
        group="Association",
        expert=True,
    )
    colour_weight: float = setting(
        1.0,
        "",
        (0.0, 10.0),
        "Weight of the colour difference in the cost; higher: clothes decide",
        group="Association",
    )
    occlusion_weight: float = setting(
        0.5,
        "",
        (0.0, 10.0),
        "Cost of a detection where the person should be occluded; higher: a person who appears "
        "from behind others more often gets a new track",
        formerly=("hidden_weight",),
        group="Association",
        expert=True,
    )

    @property
    def unseen_limit_s(self) -> float:
        """A track without a detection for longer is unreported, unless it is occluded."""
        return self.delete_after_s
