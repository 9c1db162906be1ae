"""The tables of truth beside a rendered recording: where parts are, and what is seen of people."""

from tracking.truth.true_parts import (
    TRUE_PART_COLUMNS,
    TRUE_PARTS,
    VISIBILITY,
    VISIBILITY_COLUMNS,
    TrueParts,
    Visibility,
    read_true_parts,
    read_visibility,
)
