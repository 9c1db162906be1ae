"""The settings of the joint stereo tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting
from tracking.trackers.stereo_direction import StereoDirectionSettings


@dataclass(frozen=True, slots=True)
class JointSettings(StereoDirectionSettings):
    """Settings of `stereo-joint`."""

    colour_weight: float = setting(0.4, "", (0.0, 10.0), "weight of each colour cue in the cost")
