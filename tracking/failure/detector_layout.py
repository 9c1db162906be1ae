"""The detector file's layout: names and version. One definition to write and to read."""

from __future__ import annotations

from tracking.tracks.body_parts import PART_NAMES

FORMAT = "trackwright-detector"
VERSION = (2, 0)
"""Major: older programs cannot read it. Minor: they can, and miss something."""
PAPER_VERSION = (1, 0)
"""Of files of detectors that see the paper's features alone, which older programs read, too."""

MACHINES = (*PART_NAMES, "several")
"""The last one may be missing."""

MOST_BYTES = 128 << 20
"""Of all arrays together: four machines that kept all of the most samples they may learn from."""
