"""Another person's session of the same recording beside the open one."""

from __future__ import annotations

from tracking.errors import SessionError
from tracking.session import RecordingReference


def refuse_other_recording(one: RecordingReference, other: RecordingReference, named: str) -> None:
    """Two sessions can be compared where they were made from the same sources.

    Args:
        one, other: what the sessions say of their recordings.
        named: the other session, as the user knows it.

    Raises:
        SessionError: the recordings differ.
    """
    here = [(part.size_bytes, part.sha256) for part in one.sources], one.frame_count
    there = [(part.size_bytes, part.sha256) for part in other.sources], other.frame_count
    if here != there:
        raise SessionError(
            f"{named} is of another recording ({other.name}, not {one.name}); "
            "choose a session of the same one"
        )
