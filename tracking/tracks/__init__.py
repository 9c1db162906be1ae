"""The columnar track table, runs and labels."""

from tracking.tracks.attribute_schema import (
    MOST_ATTRIBUTES,
    MOST_CHOICES,
    NO,
    YES,
    Attribute,
    AttributeType,
    Schema,
    as_stored,
    attribute_named,
    why_unfit,
)
from tracking.tracks.attribute_values import (
    label_as_stored,
    labels_as_stored,
    missing_values,
    unfit_values,
    used_values,
)
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
from tracking.tracks.limits import LONGEST_KEY, LONGEST_NAME, LONGEST_VALUE
from tracking.tracks.part_labels import (
    PART_SOURCES,
    Box,
    PartKey,
    PartLabel,
    PartLabels,
)
from tracking.tracks.row_keys import pairs_of, row_keys
from tracking.tracks.run import DetectionsInput, ParticleColumn, Particles, Run
from tracking.tracks.schema_checks import (
    attribute_as_values,
    attribute_from_values,
    check_attribute,
    check_schema,
    schema_as_values,
    schema_from_values,
)
from tracking.tracks.table import TrackTable, check_known, next_track
from tracking.tracks.validation import LARGEST_NUMBER, between, check_tracks, checked_columns
