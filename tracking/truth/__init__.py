"""The tables of truth beside a rendered recording: where parts are, and what is seen of people."""

from tracking.truth.true_parts import TRUE_PART_COLUMNS, TRUE_PARTS, TrueParts, read_true_parts
from tracking.truth.visibility import (
    VISIBILITY,
    VISIBILITY_COLUMNS,
    Visibility,
    read_visibility,
)
