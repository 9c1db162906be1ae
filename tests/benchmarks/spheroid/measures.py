"""How well one camera follows people on the floor: errors, mix-ups, ghosts ([Waechter2013])."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import Clip, Columns, floor_truth, folder_of, moments, truth_table
from tests.benchmarks.runner import Case, run_of
from tracking.formats import read_mot
from tracking.scoring import FloorMatch, ScoringTable, score
from tracking.scoring.clear_matches import clear_matches
from tracking.scoring.comparison import compare
from tracking.synthesis.marks import MARKS_M

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

OURS = Case("spheroid")
RADIUS_M = 1.0
"""Within which rows match where trackers are compared."""
LONGEST_S = 5.0
"""No ghost may last longer (the goal)."""
_SPOT_RADIUS_M, _SITUATION_RADIUS_M = 0.6, 0.7  # farther off is not that person
_NEAR_M = 1.0
_FOUND_SHARE = 0.5  # of the frames in which a person is seen well enough
_SEEN_FRAMES = 8


@dataclass(frozen=True, slots=True, eq=False)
class Followed:
    """Rows of the ground truth that are asked about, by frame.

    Attributes:
        frame, person: (n,) of the truth.
        place: (n, 2) true x, y.
        track: (n,) the result's track that is matched; 0: none.
        found: (n, 2) where that track is; NaN: none.
    """

    frame: Integers
    person: Integers
    place: Floats
    track: Integers
    found: Floats

    @property
    def error_m(self) -> Floats:
        """(n,) distance on the floor; NaN where nobody follows."""
        return np.asarray(np.hypot(*(self.found - self.place).T))

    def during(self, start: int, end: int, person: int = 0) -> Followed:
        """The rows of some frames, half-open, and of one person unless that is 0."""
        kept = (self.frame >= start) & (self.frame < end)
        if person:
            kept &= self.person == person
        return Followed(*(getattr(self, column.name)[kept] for column in fields(self)))


def follow(truth: Mapping[str, NDArray[np.generic]], tracks: Columns, radius_m: float) -> Followed:
    """Match rows by floor distance as MOTA does: last frame's partners stay together.

    Args:
        truth: frame, track, x, y.
        tracks: a run's.
        radius_m: farther apart is not the same person.
    """
    comparison = compare(_floor_table(truth), _floor_table(tracks), FloorMatch(radius_m))
    matched = clear_matches(comparison).rows
    said = comparison.truth
    track = np.zeros(len(said), np.int64)
    found = np.full((len(said), 2), np.nan)
    track[matched.truth] = comparison.result.track[matched.result]
    found[matched.truth] = comparison.result.position[matched.result]
    return Followed(said.frame, said.track, said.position, track, found)


def _floor_table(columns: Mapping[str, NDArray[np.generic]]) -> ScoringTable:
    """Floor positions as they are scored."""
    nowhere = np.full(len(columns["frame"]), np.nan)
    boxes = {name: columns.get(name, nowhere) for name in ("left", "top", "width", "height")}
    named = {name: columns[name] for name in ("frame", "track", "x", "y")}
    return ScoringTable.from_columns({**boxes, **named})


def standing(clips: Sequence[Clip]) -> dict[str, Any]:
    """Error on each mark: mean and deviation in cm, share of frames that are followed."""
    found = _by_name(clips, "stands")
    return {name: errors_cm(rows) for name, rows in found.items()} | {"all": _all(found)}


def walking(clips: Sequence[Clip]) -> dict[str, Any]:
    """The same of each straight line, and the distance across it, as the paper measured."""
    found = _by_name(clips, "walks")
    lines = {
        name: {**errors_cm(rows), "across_cm": _mean_cm(_across(rows, name))}
        for name, rows in found.items()
    }
    return lines | {"all": _all(found)}


def _by_name(clips: Sequence[Clip], kind: str) -> dict[str, list[Followed]]:
    found: dict[str, list[Followed]] = {}
    for clip in clips:
        folder = folder_of(clip)
        followed = follow(floor_truth(folder), run_of(folder, OURS).tracks, _SPOT_RADIUS_M)
        for moment in moments(folder):
            if moment.kind == kind:
                rows = followed.during(moment.start, moment.end, moment.person)
                found.setdefault(moment.name, []).append(rows)
    return found


def _all(found: Mapping[str, list[Followed]]) -> dict[str, Any]:
    return errors_cm([rows for several in found.values() for rows in several])


def errors_cm(several: Sequence[Followed]) -> dict[str, Any]:
    """Mean and deviation of the error, how many frames are followed, and of how many."""
    error_m = np.concatenate([rows.error_m for rows in several])
    known = error_m[np.isfinite(error_m)]
    return {
        "mean_cm": _mean_cm(error_m),
        "std_cm": float(100 * known.std()) if len(known) else None,
        "followed": len(known) / max(len(error_m), 1),
        "frames": len(error_m),
    }


def _mean_cm(error_m: Floats) -> float | None:
    known = error_m[np.isfinite(error_m)]
    return float(100 * known.mean()) if len(known) else None


def _across(several: Sequence[Followed], name: str) -> Floats:
    """Distance of what was found from the straight line between two marks."""
    start, end = (np.array(MARKS_M[mark]) for mark in name.split("-"))
    along = (end - start) / np.linalg.norm(end - start)
    found = np.concatenate([rows.found for rows in several])
    return np.abs((found - start) @ np.array([-along[1], along[0]]))


def situations(clips: Sequence[Clip]) -> list[dict[str, Any]]:
    """What happened in each hard situation, by difficulty ([Waechter2013] table 3)."""
    rows = [_situation(clip, folder_of(clip)) for clip in clips]
    return sorted(rows, key=lambda row: (row["difficulty"], row["scene"], row["seed"]))


def _situation(clip: Clip, folder: Path) -> dict[str, Any]:
    moment, columns = moments(folder)[0], read_mot(folder / "truth.txt")
    kept = columns["confidence"] > 0
    seen = {name: columns[name][kept] for name in ("frame", "track", "x", "y")}
    followed = follow(seen, run_of(folder, OURS).tracks, _SITUATION_RADIUS_M)
    return {
        "scene": clip.scene,
        "seed": clip.seed,
        "title": moment.name,
        "difficulty": moment.difficulty,
        "people": len(np.unique(followed.person)),
        **mix_ups(followed),
    }


def mix_ups(followed: Followed) -> dict[str, int]:
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


def robustness(clips: Sequence[Clip]) -> list[dict[str, Any]]:
    """Scores and ghosts of clips in which something is out of the ordinary."""
    return [_robust(clip, folder_of(clip)) for clip in clips]


def _robust(clip: Clip, folder: Path) -> dict[str, Any]:
    run = run_of(folder, OURS).run
    result = score(truth_table(folder), _floor_table(run.tracks), FloorMatch(RADIUS_M))
    alone_s = ghosts_s(read_mot(folder / "truth.txt"), run.tracks, clip.fps)
    return {
        "recording": clip.name,
        **{name: result.as_json()[name] for name in ("MOTA", "IDF1")},
        "ghosts": int((alone_s > LONGEST_S).sum()),
        "longest_s": float(alone_s.max(initial=0.0)),
        "notes": list(run.notes),
    }


def ghosts_s(truth: Mapping[str, NDArray[Any]], tracks: Columns, fps: float) -> Floats:
    """How long each track is without anybody near, at a stretch, in seconds.

    Args:
        truth: of everybody of whom anything is seen.
        tracks: a run's.
        fps: frames a second.
    """
    rows = zip(*(tracks[name].tolist() for name in ("frame", "x", "y")), strict=True)
    alone = np.array([_nobody_near(truth, *row) for row in rows], bool)
    longest = []
    for track in np.unique(tracks["track"]):
        own = tracks["track"] == track
        longest.append(_longest_run(tracks["frame"][own], alone[own]))
    return np.array(longest, float) / fps


def _nobody_near(truth: Mapping[str, NDArray[Any]], frame: int, x: float, y: float) -> bool:
    start, end = np.searchsorted(truth["frame"], (frame, frame + 1))
    away = np.hypot(truth["x"][start:end] - x, truth["y"][start:end] - y)
    return not (away < _NEAR_M).any()


def _longest_run(frames: NDArray[Any], alone: NDArray[np.bool_]) -> int:
    """Frames of the longest stretch that is alone throughout."""
    lonely = frames[alone]
    stretches = np.split(lonely, np.flatnonzero(np.diff(lonely) != 1) + 1)
    return max(map(len, stretches))
