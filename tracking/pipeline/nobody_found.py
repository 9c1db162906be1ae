"""Why a tracker may have found nobody."""

from __future__ import annotations

from tracking.recording import Recording
from tracking.trackers import tracker_named
from tracking.translation import Message, joined, msg


def why_nobody(recording: Recording, tracker: str) -> Message:
    """What is told beside a run without a track, where nothing else has been told of it.

    Args:
        tracker: name of the one that looked. Two cameras tell which of two lasting looks is
            farther.
    """
    much = msg("nearly all") if tracker_named(tracker).needs_stereo else msg("half")
    still = msg(
        "nobody was found; what stands still for {much} of the footage is taken for background: "
        "track more of it, or look at the foreground in the window",
        much=much,
    )
    if recording.looked_at is None:
        return still
    region = msg(
        "people are seen only as far as they are within the region of the recording: its outline "
        "must hold their heads, too, not the floor alone"
    )
    return joined("; ", (still, region))
