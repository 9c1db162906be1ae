"""Boxes that a detector of another program found: read, chosen, and handed to perception."""

from tracking.detections.reading import DetectionsFile, read_detections
from tracking.detections.settings import DetectionSettings
from tracking.detections.source import GivenBoxes, box_source
from tracking.detections.table import BoxTable, learnt_threshold

__all__ = [
    "BoxTable",
    "DetectionSettings",
    "DetectionsFile",
    "GivenBoxes",
    "box_source",
    "learnt_threshold",
    "read_detections",
]
