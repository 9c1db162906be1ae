"""Who is mixed up or lost in hard situations ([Waechter2013] table 3)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.rendered_clips import Clip, Columns, folder_of, moments, run_of
from tests.benchmarks.spheroid.people_kept import Followed, follow
from tests.benchmarks.spheroid.spots import TRACKER
from tracking.formats import read_mot

_RADIUS_M = 0.7
_FOUND_SHARE = 0.5  # of the frames in which a person is seen well enough
_SEEN_FRAMES = 8


def situations(clips: Sequence[Clip], kept: Path | None = None) -> list[dict[str, Any]]:
    """What happened in each situation, by difficulty."""
    rows = [_situation(clip, folder_of(clip, kept)) for clip in clips]
    return sorted(rows, key=lambda row: (row["difficulty"], row["scene"], row["seed"]))


def _situation(clip: Clip, folder: Path) -> dict[str, Any]:
    moment = moments(folder)[0]
    followed = follow(_seen(folder), run_of(folder, TRACKER).tracks, _RADIUS_M)
    return {
        "scene": clip.scene,
        "seed": clip.seed,
        "title": moment.name,
        "difficulty": moment.difficulty,
        "people": len(np.unique(followed.person)),
        **verdict(followed),
    }


def _seen(folder: Path) -> Columns:
    """Floor places of people of whom enough is seen."""
    columns = read_mot(folder / "truth.txt")
    kept = columns["confidence"] > 0
    return {name: columns[name][kept] for name in ("frame", "track", "x", "y")}


def verdict(followed: Followed) -> dict[str, int]:
    """What went wrong.

    Returns:
        swapped: tracks that went from one person to another.
        renamed: times a person was lost and found again under a new id.
        missed: people followed in less than half of the frames in which they are seen.
    """
    owners: dict[int, int] = {}
    tracks: dict[int, int] = {}
    swapped = renamed = 0
    rows = zip(followed.person.tolist(), followed.track.tolist(), strict=True)
    for person, track in rows:
        if not track:
            continue
        if owners.setdefault(track, person) != person:
            swapped += 1
            owners[track] = person
        elif tracks.get(person, track) != track:
            renamed += 1
        tracks[person] = track
    people, of = np.unique(followed.person, return_inverse=True)
    seen = np.bincount(of, minlength=len(people))
    share = np.bincount(of, followed.track > 0, minlength=len(people)) / np.maximum(seen, 1)
    missed = int(((share < _FOUND_SHARE) & (seen >= _SEEN_FRAMES)).sum())
    return {"swapped": swapped, "renamed": renamed, "missed": missed}
