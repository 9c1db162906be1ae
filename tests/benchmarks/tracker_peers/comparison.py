"""All trackers over the same detections, in one run."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
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

OURS = ("stereo-joint", "stereo-direction", "stereo-colour")
REPORTED_SEEDS = (6101, 6102, 6103)
CHOOSING_SEEDS = (6001, 6002, 6003)
"""Of crossing walkers on which the peers' settings were chosen."""
CHOSEN = Path(__file__).with_name("chosen.json")
"""Settings of the peers by what they are for, by tracker; made by `parameter_search`."""
RADIUS_M = 0.5
"""A row is a person's at most this far from where the person stands."""
_SEED = 0


@dataclass(frozen=True, slots=True)
class Figures:
    """What is told of a tracker over all clips together.

    Attributes:
        id_switches, people, kept: counts; `kept` as in the papers' tracking accuracy.
        idf1, hota, mota, tracking_accuracy: shares.
        floor_error_m: mean distance of matched rows.
        ms: mean milliseconds of processor time a frame.
    """

    id_switches: int
    people: int
    kept: int
    idf1: float
    hota: float
    mota: float
    tracking_accuracy: float
    floor_error_m: float
    ms: float


@dataclass(frozen=True, slots=True)
class PeerRow:
    """A tracker beside the others.

    Attributes:
        tracker: its name.
        ours: whether it is one of the catalogue's.
        colour: whether it was given colours.
        finished: whether the run was looked over as a whole; else rows are told as frames come.
        figures: None where it could not be measured.
        absent: why not; "" where it was.
    """

    tracker: str
    ours: bool
    colour: bool
    finished: bool
    figures: Figures | None
    absent: str = ""


def compared(
    seeds: Sequence[int] = REPORTED_SEEDS, ours: Sequence[str] = OURS
) -> tuple[PeerRow, ...]:
    """All trackers over the crossing walkers of these seeds."""
    with tempfile.TemporaryDirectory() as folder:
        clips = [crossing_clip(Path(folder) / "crossing", seed, FRAMES) for seed in seeds]
        return compared_on(clips, "crossing", ours)


def compared_on(
    clips: Sequence[SeenClip], settings: str, ours: Sequence[str] = OURS
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


def given_to_peers(clips: Sequence[SeenClip]) -> dict[str, tuple[int, float, Any]]:
    """Clips as the trackers of others get them, by name."""
    return {clip.name: (len(clip.observations), clip.fps, clip.seen) for clip in clips}


def _peer_row(follower: Follower, clips: Sequence[SeenClip], settings: Settings) -> PeerRow:
    if not follower.peer.installed:
        return PeerRow(follower.name, False, False, False, None, follower.peer.absent)
    tell(f"  {follower.name} on {len(clips)} clips")
    try:
        (followed,) = follower.follow(given_to_peers(clips), [settings])
    except RuntimeError as why:  # one that fails does not take the others' figures with it
        last = str(why).splitlines()[-1]
        return PeerRow(follower.name, False, False, False, None, f"{follower.name} failed: {last}")
    return PeerRow(follower.name, False, False, False, figures_of(clips, followed))


def _our_rows(tracker: str, clips: Sequence[SeenClip]) -> list[PeerRow]:
    """With colours and without, as frames come and finished."""
    rows = []
    for colour in (False, True):
        tell(f"  {tracker} {'with' if colour else 'without'} colours on {len(clips)} clips")
        seen = [clip if colour else clip.without_colours for clip in clips]
        both = {clip.name: _follow(tracker, clip) for clip in seen}
        for at, finished in enumerate((False, True)):
            followed = {name: result[at] for name, result in both.items()}
            rows.append(PeerRow(tracker, True, colour, finished, figures_of(clips, followed)))
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
    """(n, 4) by `tests.peers.peer_runs.FOLLOWED`."""
    return np.column_stack([tracks[name] for name in ("frame", "track", "x", "y")])


def figures_of(clips: Sequence[SeenClip], followed: Mapping[str, Followed]) -> Figures:
    """The figures of rows by the names of the clips, matched on the floor."""
    match = FloorMatch(RADIUS_M)
    told = combined([score(c.truth, _table(followed[c.name][0]), match) for c in clips])
    seconds = sum(float(followed[clip.name][1].sum()) for clip in clips)
    return Figures(
        id_switches=told.clear.id_switches,
        people=told.people.detected,
        kept=told.people.kept,
        idf1=told.identity.idf1,
        hota=told.hota.hota,
        mota=told.clear.mota,
        tracking_accuracy=told.tracking_accuracy,
        floor_error_m=float(told.position_error.distances_m.mean()),
        ms=1000.0 * seconds / sum(len(clip.observations) for clip in clips),
    )


def _table(rows: NDArray[np.float64]) -> ScoringTable:
    columns: dict[str, Any] = dict(zip(("frame", "track", "x", "y"), rows.T, strict=True))
    columns |= {name: columns[name].astype(np.int64) for name in ("frame", "track")}
    unknown = np.full(len(rows), np.nan)
    boxes = dict.fromkeys(("left", "top", "width", "height"), unknown)
    return ScoringTable.from_columns({**columns, **boxes})


def measure() -> dict[str, float | None]:
    """Figures of each tracker on the crossing walkers, under `NAME_FIGURE`; null without a peer.

    Ours are told without and with colours, as frames come; `best_peer_...` are the fewest switches
    and the greatest IDF1 of all peers.
    """
    figures: dict[str, float | None] = {}
    rows = [row for row in compared() if not row.finished]
    for row in rows:
        name = row.tracker.lower().replace(" ", "_").replace("-", "_")
        name += "_with_colours" if row.colour else ""
        for figure in ("id_switches", "idf1", "hota", "floor_error_m", "ms"):
            told = None if row.figures is None else getattr(row.figures, figure)
            figures[f"{name}_{figure}"] = told
        if row.absent:
            tell(row.absent)
    peers = [row.figures for row in rows if not row.ours and row.figures is not None]
    figures["best_peer_id_switches"] = min((one.id_switches for one in peers), default=None)
    figures["best_peer_idf1"] = max((one.idf1 for one in peers), default=None)
    return figures
