"""The columnar track table, runs and labels."""

from tracking.tracks.columns import (
    ASSOCIATION_COLUMNS,
    CLOTHES,
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    Source,
    empty,
)
from tracking.tracks.labels import Labels, Occluder, ReviewedRange, TrackLabel
from tracking.tracks.run import ParticleColumn, Particles, Run
from tracking.tracks.table import TrackTable, check_known, next_track
from tracking.tracks.validation import LARGEST_NUMBER, between, check_tracks, checked_columns

__all__ = [
    "ASSOCIATION_COLUMNS",
    "CLOTHES",
    "CORRECTED_COLUMNS",
    "DETECTION_COLUMNS",
    "LARGEST_NUMBER",
    "PARTICLE_COLUMNS",
    "PART_COLUMNS",
    "SIGNAL_COLUMNS",
    "TRACK_COLUMNS",
    "Columns",
    "Labels",
    "Occluder",
    "ParticleColumn",
    "Particles",
    "ReviewedRange",
    "Run",
    "Source",
    "TrackLabel",
    "TrackTable",
    "between",
    "check_known",
    "check_tracks",
    "checked_columns",
    "empty",
    "next_track",
]
