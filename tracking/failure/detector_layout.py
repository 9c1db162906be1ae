"""The detector file's layout: names and version. One definition to write and to read."""

from __future__ import annotations

FORMAT = "trackwright-detector"
VERSION = (1, 0)
"""Major: older programs cannot read it. Minor: they can, and miss something."""

PARTS = ("head", "torso", "hip-leg")
MACHINES = (*PARTS, "several")
"""The last one may be missing."""

MOST_BYTES = 128 << 20
"""Of all arrays together: four machines that kept all of the most samples they may learn from."""
