"""Spheroids in the floor plane: people of one calibrated camera ([Waechter2013])."""

from tracking.trackers.spheroid.overlays import (
    SPHEROID_OVERLAYS,
    outlines,
    region_of_evaluation,
)
from tracking.trackers.spheroid.perception import SpheroidPerception
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.setup import build_spheroid

__all__ = [
    "SPHEROID_OVERLAYS",
    "SpheroidPerception",
    "SpheroidSettings",
    "build_spheroid",
    "outlines",
    "region_of_evaluation",
]
