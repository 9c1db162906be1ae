"""Our trackers and those of others over the same detections, in one run."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.command import tell
from tests.benchmarks.tracker_peers.crossings import FRAMES, crossing_clip
from tests.benchmarks.tracker_peers.detections import SeenClip
from tests.peers.followers import FOLLOWERS, Followed, Follower, Settings
from tracking.pipeline import run_of_steps
from tracking.recording import open_recording
from tracking.scoring import FloorMatch, ScoringTable, combined, score
from tracking.settings import settings_values
from tracking.trackers import tracker_named
from tracking.tracks import Columns

REPORTED_SEEDS = (6101, 6102, 6103)
CHOOSING_SEEDS = (6001, 6002, 6003)
"""Of crossing walkers on which the peers' settings were chosen."""
RADIUS_M = 0.5
"""A row is a person's at most this far from where the person stands."""
_CHOSEN = Path(__file__).with_name("chosen.json")
"""Settings of the peers by what they are for, by tracker: of many tried, those with the best IDF1
less a tenth of the switches a person."""
_SEED = 0

Row = dict[str, Any]
"""A tracker beside the others: `tracker`, its name; `ours`; `colour`: it was given colours;
`finished`: the run was looked over as a whole, else rows are told as frames come; `figures`, None
where it could not be measured; `absent`, why not."""


def compared(seeds: Sequence[int], ours: Sequence[str]) -> list[Row]:
    """All trackers over the crossing walkers of these seeds."""
    with tempfile.TemporaryDirectory() as folder:
        clips = [crossing_clip(Path(folder) / "crossing", seed, FRAMES) for seed in seeds]
        return compared_on(clips, "crossing", ours)


def compared_on(clips: Sequence[SeenClip], settings: str, ours: Sequence[str]) -> list[Row]:
    """All trackers over these clips.

    Args:
        settings: which settings the peers have: chosen for "crossing" walkers or for "rendered"
            recordings.
    """
    chosen = chosen_settings(settings)
    peers = [_peer_row(one, clips, chosen[one.name]) for one in FOLLOWERS]
    return [*(row for name in ours for row in _our_rows(name, clips)), *peers]


def chosen_settings(settings: str) -> Mapping[str, Any]:
    """What was chosen for each peer on the seeds for choosing."""
    chosen: dict[str, Any] = json.loads(_CHOSEN.read_text(encoding="utf-8"))
    return chosen[settings]


def _peer_row(follower: Follower, clips: Sequence[SeenClip], settings: Settings) -> Row:
    row: Row = {"tracker": follower.name, **dict.fromkeys(("ours", "colour", "finished"), False)}
    if not follower.peer.installed:
        return {**row, "figures": None, "absent": follower.peer.absent}
    tell(f"  {follower.name} on {len(clips)} clips")
    given = {clip.name: (len(clip.observations), clip.fps, clip.seen) for clip in clips}
    try:
        (followed,) = follower.follow(given, [settings])
    except RuntimeError as why:  # one that fails does not take the others' figures with it
        last = str(why).splitlines()[-1]
        return {**row, "figures": None, "absent": f"{follower.name} failed: {last}"}
    return {**row, "figures": figures_of(clips, followed), "absent": ""}


def _our_rows(tracker: str, clips: Sequence[SeenClip]) -> list[Row]:
    """With colours and without, as frames come and finished."""
    rows: list[Row] = []
    for colour in (False, True):
        tell(f"  {tracker} {'with' if colour else 'without'} colours on {len(clips)} clips")
        seen = [clip if colour else clip.without_colours for clip in clips]
        both = {clip.name: _follow(tracker, clip) for clip in seen}
        for at, finished in enumerate((False, True)):
            figures = figures_of(clips, {name: result[at] for name, result in both.items()})
            row = {"tracker": tracker, "ours": True, "colour": colour, "finished": finished}
            rows.append({**row, "figures": figures, "absent": ""})
    return rows


def _follow(tracker: str, clip: SeenClip) -> tuple[Followed, Followed]:
    """A tracker's rows as frames came, and of the run looked over as a whole, at its defaults.

    The times of the second are the first's and, shared out evenly, that of looking it over.
    """
    spec = tracker_named(tracker)
    settings = spec.settings_type()
    with open_recording(clip.recording) as recording:
        _, following = spec.build(recording, settings, _SEED)
        steps, taken = [], []
        for observation in clip.observations:
            begun = time.process_time()
            steps.append(following.step(observation))
            taken.append(time.process_time() - begun)
        online_s, begun = np.array(taken), time.process_time()
        run = run_of_steps(steps, spec.name, settings_values(settings), _SEED, 0, recording)
        finished_s = online_s + (time.process_time() - begun) / len(steps)
    online = np.concatenate([_rows(step.tracks) for step in steps])
    return (online, online_s), (_rows(run.tracks), finished_s)


def _rows(tracks: Columns) -> NDArray[np.float64]:
    """(n, 4) by `tests.peers.follow.FOLLOWED`."""
    return np.column_stack([tracks[name] for name in ("frame", "track", "x", "y")])


def figures_of(clips: Sequence[SeenClip], followed: Mapping[str, Followed]) -> dict[str, Any]:
    """Figures of rows by the names of the clips, over all together, matched on the floor.

    `kept` as in the papers' tracking accuracy; `floor_error_m` of matched rows; `ms` of processor
    time a frame.
    """
    match = FloorMatch(RADIUS_M)
    told = combined([score(c.truth, _table(followed[c.name][0]), match) for c in clips])
    seconds = sum(float(followed[clip.name][1].sum()) for clip in clips)
    return {
        "id_switches": told.clear.id_switches,
        "people": told.people.detected,
        "kept": told.people.kept,
        "idf1": told.identity.idf1,
        "hota": told.hota.hota,
        "floor_error_m": float(told.position_error.distances_m.mean()),
        "ms": 1000.0 * seconds / sum(len(clip.observations) for clip in clips),
    }


def _table(rows: NDArray[np.float64]) -> ScoringTable:
    columns: dict[str, Any] = dict(zip(("frame", "track", "x", "y"), rows.T, strict=True))
    columns |= {name: columns[name].astype(np.int64) for name in ("frame", "track")}
    boxes = dict.fromkeys(("left", "top", "width", "height"), np.full(len(rows), np.nan))
    return ScoringTable.from_columns({**columns, **boxes})
