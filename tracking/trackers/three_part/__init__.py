"""People followed by rectangles in the picture: three parts each, or whole [ZhaoLee2009]."""

from tracking.trackers.three_part.detectors import PAPER_DETECTOR, detector_fingerprint
from tracking.trackers.three_part.settings import ThreePartSettings, WholeBodySettings
from tracking.trackers.three_part.setup import (
    build_three_part,
    build_three_part_joint,
    build_whole_body,
)

__all__ = [
    "PAPER_DETECTOR",
    "ThreePartSettings",
    "WholeBodySettings",
    "build_three_part",
    "build_three_part_joint",
    "build_whole_body",
    "detector_fingerprint",
]
