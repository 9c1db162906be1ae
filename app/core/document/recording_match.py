"""Whether two sessions are of the same recording."""

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
            "{named} is of another recording ({difference}); choose a session of the same one",
            named=named,
            difference=_difference(one, other),
        )


def _difference(one: RecordingReference, other: RecordingReference) -> str:
    """What tells two recordings apart, which may be called alike."""
    if other.name != one.name:
        return f"{other.name}, not {one.name}"
    if other.frame_count != one.frame_count:
        return f"{other.frame_count} frames, not {one.frame_count}"
    return f"{other.name}, too, but its files are others"
