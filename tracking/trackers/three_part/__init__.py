"""People followed by rectangles in the picture: three parts each, or whole [ZhaoLee2009]."""

from tracking.trackers.three_part.detectors import BUILT_IN_DETECTORS, detector_fingerprint
from tracking.trackers.three_part.places import link_refined
from tracking.trackers.three_part.settings import ThreePartSettings, WholeBodySettings
from tracking.trackers.three_part.setup import (
    build_three_part,
    build_three_part_joint,
    build_whole_body,
)

__all__ = [
    "BUILT_IN_DETECTORS",
    "ThreePartSettings",
    "WholeBodySettings",
    "build_three_part",
    "build_three_part_joint",
    "build_whole_body",
    "detector_fingerprint",
    "link_refined",
]
