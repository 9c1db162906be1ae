"""All trackers over the same clips, in one run."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.tracker_peers.clips import Clip
from tests.benchmarks.tracker_peers.crossing import crossing_clip
from tests.benchmarks.tracker_peers.ours import follow
from tests.benchmarks.tracker_peers.rows import PeerRow, figures_of
from tests.peers.followers import FOLLOWERS, Follower, Settings

OURS = ("stereo-joint", "stereo-direction", "stereo-colour")
REPORTED_SEEDS = (6101, 6102, 6103)
CHOSEN = Path(__file__).with_name("chosen.json")
"""Settings of the peers by what they are for, by tracker; made by `choosing`."""


def compared(seeds: Sequence[int] = REPORTED_SEEDS) -> tuple[PeerRow, ...]:
    """All trackers over the crossing walkers of these seeds."""
    with tempfile.TemporaryDirectory() as folder:
        clips = [crossing_clip(Path(folder) / "crossing", seed) for seed in seeds]
        return compared_on(clips, "crossing")


def compared_on(
    clips: Sequence[Clip], settings: str, ours: Sequence[str] = OURS
) -> tuple[PeerRow, ...]:
    """All trackers over these clips.

    Args:
        settings: which settings the peers have: chosen for "crossing" walkers or for "rendered"
            recordings.
    """
    chosen = chosen_settings(settings)
    peers = [_peer_row(one, clips, chosen[one.name]) for one in FOLLOWERS]
    return (*(row for name in ours for row in _our_rows(name, clips)), *peers)


def chosen_settings(settings: str) -> Mapping[str, Any]:
    """What was chosen for each peer on the seeds for choosing."""
    chosen: dict[str, Any] = json.loads(CHOSEN.read_text(encoding="utf-8"))
    return chosen[settings]


def _peer_row(follower: Follower, clips: Sequence[Clip], settings: Settings) -> PeerRow:
    if not follower.peer.installed:
        return PeerRow(follower.name, False, False, False, None, follower.peer.absent)
    given = {clip.name: (len(clip.observations), clip.fps, clip.seen) for clip in clips}
    (followed,) = follower.follow(given, [settings])
    return PeerRow(follower.name, False, False, False, figures_of(clips, followed))


def _our_rows(tracker: str, clips: Sequence[Clip]) -> list[PeerRow]:
    """With colours and without, as frames come and finished."""
    rows = []
    for colour in (False, True):
        seen = [clip if colour else clip.without_colours for clip in clips]
        both = {clip.name: follow(tracker, clip) for clip in seen}
        for at, finished in enumerate((False, True)):
            followed = {name: result[at] for name, result in both.items()}
            rows.append(PeerRow(tracker, True, colour, finished, figures_of(clips, followed)))
    return rows
