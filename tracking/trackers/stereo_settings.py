"""The settings that stereo trackers share."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting
from tracking.stereo import StereoSettings


@dataclass(frozen=True, slots=True)
class StereoFilterSettings:
    """What every stereo tracker can be told; see the `help` of each field."""

    particles: int = setting(500, "", (10, 20000), "particles for each person")
    start_spread_m: float = setting(
        0.25, "m", (0.01, 2.0), "spread of a newcomer's particles around the first detection"
    )
    sigma_near_m: float = setting(
        0.12, "m", (0.01, 2.0), "likelihood's standard deviation close to the camera"
    )
    sigma_range: float = setting(
        0.001, "m/m²", (0.0, 0.1), "growth of that deviation with the square of the range"
    )
    hidden_below: float = setting(
        0.3, "", (0.0, 1.0), "share of a body that must be expected to show to look for it"
    )
    unseen_s: float = setting(
        0.2, "s", (0.01, 60.0), "time in which somebody not seen is thought to be behind others"
    )
    least_margin: float = setting(
        0.2, "", (0.0, 5.0), "a detection that suits two people nearly alike is nobody's"
    )
    colour_distance_m: float = setting(
        0.6, "m", (0.0, 5.0), "colours are learnt while nobody else is closer than this"
    )
    confirm_matches: int = setting(
        3, "", (1, 100), "frames a newcomer must be seen in before it becomes a track"
    )
    birth_distance_m: float = setting(
        0.5, "m", (0.0, 5.0), "no newcomer starts closer than this to somebody followed"
    )
    lost_after_s: float = setting(
        1.5, "s", (0.05, 60.0), "time without a detection after which a track ends"
    )
    lost_hidden_s: float = setting(
        4.0, "s", (0.05, 60.0), "the same while a person is expected to be hidden by others"
    )
    lost_at_edge_s: float = setting(
        0.5, "s", (0.05, 60.0), "the same for a person last seen at the image's edge"
    )
    smooth: bool = setting(
        True, "", None, "once tracked, smooth paths and boxes from both ends and fill their gaps"
    )
    foreground: ForegroundSettings = field(default_factory=ForegroundSettings)
    stereo: StereoSettings = field(default_factory=StereoSettings)
    people: PeopleSettings = field(default_factory=PeopleSettings)


@dataclass(frozen=True, slots=True)
class StereoTrackerSettings(StereoFilterSettings):
    """What a tracker that sums up the costs of the papers' cues can be told."""

    spread_m: float = setting(
        0.25, "m", (0.01, 3.0), "random spread of the particles after one second of prediction"
    )
    spread_growth: float = setting(
        1.0, "1/s", (0.0, 10.0), "how much the spread grows with each second a person is missed"
    )
    velocity_memory_s: float = setting(
        0.4, "s", (0.05, 5.0), "time over which the velocity is smoothed"
    )
    gate_m: float = setting(
        0.9, "m", (0.1, 5.0), "farthest a detection may lie from where a person is expected"
    )
    gate_growth: float = setting(
        1.0, "1/s", (0.0, 10.0), "how much wider that is with each second a person is missed"
    )
    cost_limit: float = setting(
        2.0, "", (0.1, 10.0), "total cost above which a person rather stays without a detection"
    )
    distance_weight: float = setting(
        2.0, "1/m", (0.0, 20.0), "weight of the distance cue in the cost"
    )
    colour_weight: float = setting(1.0, "", (0.0, 10.0), "weight of the colour cue in the cost")
    hidden_weight: float = setting(
        0.5, "", (0.0, 10.0), "cost of seeing somebody who is expected to be hidden by others"
    )
