"""The settings of the joint stereo tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting
from tracking.trackers.stereo_settings import StereoFilterSettings
from tracking.trackers.stereo_walking import WalkingSettings


@dataclass(frozen=True, slots=True)
class JointSettings(WalkingSettings, StereoFilterSettings):
    """Settings of `stereo-joint`."""

    confirm_s: float = setting(
        0.1, "s", (0.0, 10.0), "how long a newcomer must be seen at least, before it is a track"
    )
    lost_after_s: float = setting(
        0.5, "s", (0.05, 60.0), "time without a detection after which somebody is only remembered"
    )
    least_margin: float = setting(
        0.1, "", (0.0, 5.0), "a detection that suits two people nearly alike is nobody's"
    )
    agility: float = setting(
        1.0, "m²/s³", (0.001, 100.0), "how much people change their velocity, as white noise"
    )
    new_at_edge: float = setting(
        1.0, "1/m²/s", (1e-6, 100.0), "people who appear at the picture's edge"
    )
    new_within: float = setting(
        0.05, "1/m²/s", (1e-6, 100.0), "people who appear in the middle of the picture"
    )
    overlooked: float = setting(
        0.05, "", (0.001, 0.9), "share of frames in which somebody in full view is not detected"
    )
    looks_weight: float = setting(
        0.5, "", (0.0, 4.0), "how far colours and height are taken for independent of each other"
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "once tracked, give everybody one id for their whole stay, smooth paths and boxes from "
        "both ends and fill their gaps",
    )
    direction_weight: float = setting(
        1.0, "nat", (0.0, 10.0), "cost of a turn by the threshold or more"
    )
    remember_s: float = setting(
        8.0, "s", (0.0, 60.0), "how long somebody lost within the picture is remembered"
    )
    slowing_s: float = setting(
        2.0, "s", (0.1, 60.0), "time in which somebody missed is thought to slow down"
    )
