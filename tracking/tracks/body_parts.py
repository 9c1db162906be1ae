"""The body parts people are followed by: their numbers, their order and their names."""

from __future__ import annotations

from tracking.translation import N_

HEAD, TORSO, HIP_LEG = range(3)
"""As tables number them, and in the order of arrays with a place for each part."""

PART_NAMES = (N_("head"), N_("torso"), N_("hip-leg"))
"""By the number of the part; in messages they are translated."""

PARTS = len(PART_NAMES)

PART_WORDS = tuple(name.replace("-", "_") for name in PART_NAMES)
"""The names as single words: columns, keys and cells of files."""
