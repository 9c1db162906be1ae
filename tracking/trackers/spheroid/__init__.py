"""Spheroids in the floor plane: people of one calibrated camera ([Waechter2013])."""

from tracking.trackers.spheroid.building import build_spheroid
from tracking.trackers.spheroid.drawing import (
    RegionOfEvaluation,
    outlines,
    ramp_picture,
    region_of_evaluation,
)
from tracking.trackers.spheroid.finishing import finished
from tracking.trackers.spheroid.perception import SpheroidPerception
from tracking.trackers.spheroid.settings import SpheroidSettings

__all__ = [
    "RegionOfEvaluation",
    "SpheroidPerception",
    "SpheroidSettings",
    "build_spheroid",
    "finished",
    "outlines",
    "ramp_picture",
    "region_of_evaluation",
]
