"""The file of samples as HDF5: names, version and size. One definition to write, check and read."""

from __future__ import annotations

from tracking.failure.core.features import FEATURES, PAPER_FEATURES
from tracking.failure.core.samples import BESIDES, SAMPLE_COLUMNS, TEXT

HDF5_FORMAT = "trackwright-samples"
VERSION = (1, 2)
"""Major: older programs cannot read it. Minor: they can, and miss something.

1.1: person and time_s. 1.2: evidence among the features."""

MOST_BYTES = 512 << 20
"""Of all numbers together: a million samples."""
MOST_TEXT = 256 << 20
"""Characters of all text together."""

SHARED = tuple(name for name in BESIDES if name != "session")
"""Columns besides `SAMPLE_COLUMNS` that stand in files; those of version 1.0 lack them."""

TEXTS = tuple(name for name, dtype in SAMPLE_COLUMNS.items() if dtype == TEXT)
NUMBERS = tuple(name for name, dtype in SAMPLE_COLUMNS.items() if dtype != TEXT)

WIDTHS = (PAPER_FEATURES, FEATURES)
"""How many features a sample may have: before 1.2 the paper's alone."""
