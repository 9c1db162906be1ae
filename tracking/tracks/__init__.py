"""The columnar track table, runs and labels."""

from tracking.tracks.body_parts import HEAD, HIP_LEG, PART_NAMES, PART_WORDS, PARTS, TORSO
from tracking.tracks.columns import (
    ASSOCIATION_COLUMNS,
    CLOTHES,
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_EVIDENCE,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    Source,
    Types,
    column_types,
    empty,
)
from tracking.tracks.label_checks import (
    LABEL_CHECKS,
    LONGEST_KEY,
    LONGEST_NAME,
    LONGEST_VALUE,
    check_line,
    check_name,
    check_occluder,
    check_part_label,
    check_region,
    check_reviewed,
    check_verdict,
)
from tracking.tracks.labels import (
    DECISIONS,
    CountingLine,
    Labels,
    Occluder,
    Region,
    ReviewedRange,
    TrackLabel,
    Verdict,
    VerdictKey,
)
from tracking.tracks.part_labels import (
    PART_SOURCES,
    Box,
    PartKey,
    PartLabel,
    PartLabels,
)
from tracking.tracks.row_keys import pairs_of, row_keys
from tracking.tracks.run import DetectionsInput, ParticleColumn, Particles, Run
from tracking.tracks.table import TrackTable, check_known, next_track
from tracking.tracks.validation import LARGEST_NUMBER, between, check_tracks, checked_columns
