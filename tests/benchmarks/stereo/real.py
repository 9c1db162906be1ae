"""Real footage: the overhead recording, in which four people pass one after the other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.flow.real import BY_EYE, OVERHEAD
from tests.benchmarks.stereo.clips import KEPT
from tests.benchmarks.stereo.columns import OURS
from tests.benchmarks.stereo.trackers import runs_over
from tracking.tracks import Columns

LONGEST = 10
"""Frames: no track beside the four may be longer."""


def measure(data: Path) -> dict[str, Any]:
    """Who was followed in each passage; empty where the recording is not there."""
    folder = data / OVERHEAD
    if not (folder / "recording.toml").is_file():
        return {}
    return passages_by_eye(runs_over(folder, [OURS], KEPT / "runs")[OURS].tracks)


def passages_by_eye(tracks: Columns) -> dict[str, Any]:
    """Who passed: of each passage the track that covers most of its frames.

    Returns:
        passages: by passage its frames, by eye, the id of the passer, how many frames of the
            passage it covers, how many went by before it began and after it ended.
        extra: every other track longer than `LONGEST` frames.
        short: how many others there are.
    """
    own = {
        int(track): tracks["frame"][tracks["track"] == track]
        for track in np.unique(tracks["track"])
    }
    passers = [_passer(own, first, last, ahead) for first, last, ahead in BY_EYE]
    others = {
        track: frames for track, frames in own.items() if track not in {p["track"] for p in passers}
    }
    long = {track: frames for track, frames in others.items() if len(frames) > LONGEST}
    return {
        "passages": passers,
        "extra": [_told(track, frames) for track, frames in long.items()],
        "short": len(others) - len(long),
    }


def _passer(own: dict[int, Any], first: int, last: int, ahead: bool) -> dict[str, Any]:
    within = {t: int(((f >= first) & (f <= last)).sum()) for t, f in own.items()}
    track = max(within, key=lambda t: within[t], default=0)
    row = {"first": first, "last": last, "to_the_right": ahead, "frames": last - first + 1}
    if not within.get(track):
        return {**row, "track": 0, "covered": 0, "before": 0, "after": 0}
    told = _told(track, own[track])
    before, after = max(0, told["began"] - first), max(0, last - told["ended"])
    return {**row, **told, "covered": within[track], "before": before, "after": after}


def _told(track: int, frames: Any) -> dict[str, int]:
    return {"track": track, "began": int(frames[0]), "ended": int(frames[-1])}
