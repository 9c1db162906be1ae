"""Boxes that a detector of another program found: read, chosen, and handed to perception."""

from tracking.detections.detections_file import DetectionsFile, read_detections
from tracking.detections.frame_numbers import Footage
from tracking.detections.settings import DetectionSettings
from tracking.detections.source import (
    RecordingDetections,
    detections_stage,
    files_beside,
    load_detections,
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
    "RecordingDetections",
    "detections_stage",
    "files_beside",
    "learnt_threshold",
    "load_detections",
    "outside",
    "place_of",
    "read_detections",
    "with_relative_paths",
]
