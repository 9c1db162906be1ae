"""How well the stereo trackers do, as plain figures: scores, who is kept, who is not and why."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.flow.counts import BY_EYE, OVERHEAD
from tests.benchmarks.runner import KeptRun, run_of, runs_over
from tests.benchmarks.spheroid.measures import ghosts_s
from tests.benchmarks.stereo.clips import (
    AS_THEY_COME,
    OURS,
    PAPERS,
    OfScene,
    columns_of,
    dimmed,
    sound,
)
from tests.benchmarks.stereo.reasons import VISIBLE_S, NotKept, matches_of, not_kept
from tests.benchmarks.stereo.troubles import TROUBLES, troubled
from tests.benchmarks.stereo.truth import Truth, truth_of, visible_for
from tracking.scoring import (
    BoxMatch,
    FloorMatch,
    Score,
    ScoringTable,
    combined,
    examine,
    per_person_of,
    score,
    score_of,
)
from tracking.scoring.papers import detected_and_kept
from tracking.tracks import Columns

Figures = dict[str, Any]

FLOOR_M = 0.5
"""Within which rows match where boxes do not count."""
LONGEST = 10
"""Frames: in real footage no track beside those of the passers may be longer."""
_BY_BOX = BoxMatch(0.5)
_KINDS = ("detected", "kept", "detected_by_place", "kept_by_place", "not_kept")
"""Of people; "by place" where only tracks count that stand nearer to them than to anybody else."""
_SCORES = (
    *("tracking_accuracy", "MOTA", "IDF1", "HOTA", "id_switches"),
    *("people_kept", "people_detected", "misses", "false_positives", "truth_rows"),
)


def figures_of(score: Score) -> Figures:
    """What is told of a score."""
    figures = score.as_json()
    told = {name: figures[name] for name in _SCORES}
    return {**told, "error_m": figures["position_error_m"]["mean"]}


def trackers(clips: OfScene, kept: Path | None = None) -> Figures:
    """Each tracker's figures as it comes, over everything and by scene."""
    found = {
        scene: [_scored_runs(folder_of(clip, kept)) for clip in several]
        for scene, several in clips.items()
    }
    return {
        "all": _of_each([runs for several in found.values() for runs in several]),
        "scenes": {scene: _of_each(several) for scene, several in found.items()},
        "clips": [clip.name for several in clips.values() for clip in several],
    }


def _scored_runs(folder: Path) -> dict[str, tuple[Score, KeptRun]]:
    truth = truth_of(folder).table
    return {
        case.tracker: (score(truth, ScoringTable.from_columns(run.tracks), _BY_BOX), run)
        for case, run in runs_over(folder, AS_THEY_COME).items()
    }


def _of_each(clips: Sequence[Mapping[str, tuple[Score, KeptRun]]]) -> Figures:
    return {
        case.tracker: _over_clips([runs[case.tracker] for runs in clips]) for case in AS_THEY_COME
    }


def _over_clips(runs: Sequence[tuple[Score, KeptRun]]) -> Figures:
    frames, seeing_s, following_s = (
        sum(float(run.times[name][0]) for _, run in runs)
        for name in ("frames", "seeing_s", "following_s")
    )
    return {
        **figures_of(combined([own for own, _ in runs])),
        "seeing_ms": 1000 * seeing_s / frames,
        "following_ms": 1000 * following_s / frames,
    }


def tables(clips: OfScene, kept: Path | None = None) -> Figures:
    """Of each scene of the papers, by column: who is detected, who is kept, why the others not."""
    return {
        scene: _columns(scene, several, kept) for scene, several in clips.items() if scene in PAPERS
    }


def _columns(scene: str, clips: Sequence[Clip], kept: Path | None) -> Figures:
    columns = columns_of(scene)
    found: Figures = {name: {kind: [] for kind in _KINDS} for name in columns}
    for clip in clips:
        folder = folder_of(clip, kept)
        truth, runs = truth_of(folder), runs_over(folder, list(columns.values()))
        for name, case in columns.items():
            _add(found[name], truth, runs[case].tracks, folder.name)
    return found


def _add(column: Figures, truth: Truth, tracks: Columns, clip: str) -> None:
    """One clip's people; each is named by clip and id."""
    examined = examine(truth.table, ScoringTable.from_columns(tracks), _BY_BOX)
    by_place = examined.matched.some(matches_of(truth, examined).right)
    people = np.unique(examined.comparison.truth.track)
    for matched, kinds in ((examined.matched, _KINDS[:2]), (by_place, _KINDS[2:4])):
        flags = detected_and_kept(examined.comparison, matched)
        for kind, flag in zip(kinds, flags, strict=True):
            column[kind] += [f"{clip}/{person}" for person in people[flag]]
    column["not_kept"] += [told(one, clip) for one in not_kept(truth, tracks)]


def told(one: NotKept, clip: str) -> Figures:
    """Somebody who was not kept, as plain values."""
    values = asdict(one)
    context = values.pop("context")
    own = {**values, "tracks": list(one.tracks), **context}
    return {"name": f"{clip}/{one.person}", "clip": clip, **own}


def lost(clips: OfScene, kept: Path | None = None) -> dict[str, list[Figures]]:
    """Of each scene: everybody our tracker did not keep."""
    return {
        scene: [one for clip in several for one in _lost(folder_of(clip, kept))]
        for scene, several in clips.items()
    }


def _lost(folder: Path) -> list[Figures]:
    return [told(one, folder.name) for one in not_kept(truth_of(folder), _our_tracks(folder))]


def _our_tracks(folder: Path) -> Columns:
    return run_of(folder, OURS).tracks


def goals(clips: OfScene, kept: Path | None = None) -> Figures:
    """Of each scene: how well our tracker does, and who is not kept."""
    return {
        scene: _scored([folder_of(clip, kept) for clip in several])
        for scene, several in clips.items()
    }


def _scored(folders: Sequence[Path]) -> Figures:
    scores, by_floor, visible, detected = [], [], 0, 0
    for place in folders:
        truth, tracks = truth_of(place), ScoringTable.from_columns(_our_tracks(place))
        examined = examine(truth.table, tracks, _BY_BOX)
        scores.append(score_of(examined))
        by_floor.append(score(truth.table, tracks, FloorMatch(FLOOR_M)))
        seen = visible_for(truth, VISIBLE_S)
        found = {one.person for one in per_person_of(examined) if one.followed.detected}
        visible, detected = visible + len(seen), detected + len(seen & found)
    figures = [figures_of(one) for one in scores]
    return {
        **figures_of(combined(scores)),
        "by_floor": figures_of(combined(by_floor)),
        "kept_by_clip": [one["people_kept"] for one in figures],
        "detected_by_clip": [one["people_detected"] for one in figures],
        "visible": visible,
        "visible_detected": detected,
        "clips": [place.name for place in folders],
    }


def robustness(clips: OfScene, kept: Path | None = None) -> list[Figures]:
    """Scores of clips with troubled cameras, and for how long a track stood where nobody was."""
    return [
        {"what": what, "clip": clip.scene, **_robust(folder)}
        for what, clip, folder in _troubled_clips(clips, kept)
    ]


def _troubled_clips(clips: OfScene, kept: Path | None) -> Iterator[tuple[str, Clip, Path]]:
    for clip in dimmed(clips):
        yield "part of the light goes out", clip, folder_of(clip, kept)
    for clip in sound(clips):
        folder = folder_of(clip, kept)
        yield "nothing", clip, folder
        for trouble in TROUBLES:
            yield trouble.name, clip, troubled(folder, trouble)


def _robust(folder: Path) -> Figures:
    truth, tracks = truth_of(folder), _our_tracks(folder)
    result = score(truth.table, ScoringTable.from_columns(tracks), _BY_BOX)
    alone_s = ghosts_s(truth.columns, dict(tracks), truth.fps)
    return {**figures_of(result), "alone_s": float(alone_s.max(initial=0.0))}


def real_footage(data: Path) -> Figures:
    """Who was followed in each passage of the overhead recording; empty where it is not there."""
    folder = data / OVERHEAD
    there = (folder / "recording.toml").is_file()
    return passages_by_eye(_our_tracks(folder)) if there else {}


def passages_by_eye(tracks: Columns) -> Figures:
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
        "extra": [_stretch(track, frames) for track, frames in long.items()],
        "short": len(others) - len(long),
    }


def _passer(own: dict[int, Any], first: int, last: int, ahead: bool) -> Figures:
    within = {t: int(((f >= first) & (f <= last)).sum()) for t, f in own.items()}
    track = max(within, key=lambda t: within[t], default=0)
    row = {"first": first, "last": last, "to_the_right": ahead, "frames": last - first + 1}
    if not within.get(track):
        return {**row, "track": 0, "covered": 0, "before": 0, "after": 0}
    found = _stretch(track, own[track])
    before, after = max(0, found["began"] - first), max(0, last - found["ended"])
    return {**row, **found, "covered": within[track], "before": before, "after": after}


def _stretch(track: int, frames: Any) -> dict[str, int]:
    return {"track": track, "began": int(frames[0]), "ended": int(frames[-1])}
