"""Names of body parts."""

from __future__ import annotations

from app.core.i18n import tr
from app.core.keymap import in_brackets
from tracking.trackers import body_part_tracker
from tracking.tracks import PART_NAMES
from tracking.translation import Message, msg


def part_name(part: int) -> str:
    """The name of a part in the user's language."""
    names = (tr("head"), tr("torso"), tr("hip-leg"))
    return names[part % len(PART_NAMES)]


def no_parts() -> Message:
    """What to do where no body parts were tracked."""
    return msg(
        "No parts were tracked: track with {tracker}{key} first",
        tracker=body_part_tracker(),
        key=in_brackets("tracks.track"),
    )
