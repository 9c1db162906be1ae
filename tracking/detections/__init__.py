"""Boxes that a detector of another program found: read, chosen, and handed to perception."""

from tracking.detections.frame_numbers import Footage
from tracking.detections.reading import DetectionsFile, read_detections
from tracking.detections.settings import DetectionSettings
from tracking.detections.source import (
    GivenBoxes,
    box_source,
    detections_stage,
    outside,
    place_of,
    with_relative_paths,
)
from tracking.detections.table import BoxTable, learnt_threshold

__all__ = [
    "BoxTable",
    "DetectionSettings",
    "DetectionsFile",
    "Footage",
    "GivenBoxes",
    "box_source",
    "detections_stage",
    "learnt_threshold",
    "outside",
    "place_of",
    "read_detections",
    "with_relative_paths",
]
