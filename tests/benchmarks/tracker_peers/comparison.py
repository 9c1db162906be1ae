"""All trackers over the same clips, in one run."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.page_texts import tell
from tests.benchmarks.tracker_peers.clips import Clip
from tests.benchmarks.tracker_peers.crossings import FRAMES, crossing_clip
from tests.benchmarks.tracker_peers.ours import follow
from tests.benchmarks.tracker_peers.rows import PeerRow, figures_of
from tests.peers.followers import FOLLOWERS, Follower, Settings

OURS = ("stereo-joint", "stereo-direction", "stereo-colour")
REPORTED_SEEDS = (6101, 6102, 6103)
CHOSEN = Path(__file__).with_name("chosen.json")
"""Settings of the peers by what they are for, by tracker; made by `choosing`."""


def compared(
    seeds: Sequence[int] = REPORTED_SEEDS, ours: Sequence[str] = OURS, frames: int = FRAMES
) -> tuple[PeerRow, ...]:
    """All trackers over the crossing walkers of these seeds."""
    with tempfile.TemporaryDirectory() as folder:
        clips = [crossing_clip(Path(folder) / "crossing", seed, frames) for seed in seeds]
        return compared_on(clips, "crossing", ours)


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
    tell(f"  {follower.name} on {len(clips)} clips")
    given = {clip.name: (len(clip.observations), clip.fps, clip.seen) for clip in clips}
    try:
        (followed,) = follower.follow(given, [settings])
    except RuntimeError as why:  # one that fails does not take the others' figures with it
        last = str(why).splitlines()[-1]
        return PeerRow(follower.name, False, False, False, None, f"{follower.name} failed: {last}")
    return PeerRow(follower.name, False, False, False, figures_of(clips, followed))


def _our_rows(tracker: str, clips: Sequence[Clip]) -> list[PeerRow]:
    """With colours and without, as frames come and finished."""
    rows = []
    for colour in (False, True):
        tell(f"  {tracker} {'with' if colour else 'without'} colours on {len(clips)} clips")
        seen = [clip if colour else clip.without_colours for clip in clips]
        both = {clip.name: follow(tracker, clip) for clip in seen}
        for at, finished in enumerate((False, True)):
            followed = {name: result[at] for name, result in both.items()}
            rows.append(PeerRow(tracker, True, colour, finished, figures_of(clips, followed)))
    return rows


def measure() -> dict[str, float | None]:
    """Figures of each tracker on the crossing walkers, under `NAME_FIGURE`; null without a peer.

    Ours are told without and with colours, as frames come; `best_peer_...` are the fewest switches
    and the greatest IDF1 of all peers.
    """
    figures: dict[str, float | None] = {}
    rows = compared()
    for row in rows:
        if row.finished:
            continue
        name = row.tracker.lower().replace(" ", "_").replace("-", "_")
        name += "_with_colours" if row.colour else ""
        found = row.figures
        figures |= {
            f"{name}_id_switches": None if found is None else found.id_switches,
            f"{name}_idf1": None if found is None else found.idf1,
            f"{name}_hota": None if found is None else found.hota,
            f"{name}_floor_error_m": None if found is None else found.floor_error_m,
            f"{name}_ms": None if found is None else found.ms,
        }
        if row.absent:
            tell(row.absent)
    peers = [row.figures for row in rows if not row.ours and row.figures is not None]
    figures["best_peer_id_switches"] = min((one.id_switches for one in peers), default=None)
    figures["best_peer_idf1"] = max((one.idf1 for one in peers), default=None)
    return figures
