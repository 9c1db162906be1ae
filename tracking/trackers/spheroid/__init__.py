"""Spheroids in the floor plane: people of one calibrated camera ([Waechter2013])."""

from tracking.trackers.spheroid.finisher import finish_run
from tracking.trackers.spheroid.overlays import (
    RegionOfEvaluation,
    outlines,
    ramp_picture,
    region_of_evaluation,
)
from tracking.trackers.spheroid.perception import SpheroidPerception
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.setup import build_spheroid

__all__ = [
    "RegionOfEvaluation",
    "SpheroidPerception",
    "SpheroidSettings",
    "build_spheroid",
    "finish_run",
    "outlines",
    "ramp_picture",
    "region_of_evaluation",
]
