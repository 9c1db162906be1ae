"""Names of body parts."""

from __future__ import annotations

from app.core.i18n import tr
from tracking.tracks import PART_NAMES


def part_name(part: int) -> str:
    """The name of a part in the user's language."""
    names = (tr("head"), tr("torso"), tr("hip-leg"))
    return names[part % len(PART_NAMES)]
