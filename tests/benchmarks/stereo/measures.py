"""How well the stereo trackers do, as plain figures: scores, and who is kept."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import Clip, folder_of
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
from tests.benchmarks.stereo.troubles import TROUBLES, troubled
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring import (
    BoxMatch,
    Examination,
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
from tracking.truth.true_parts import VISIBILITY, read_visibility

Figures = dict[str, Any]

FLOOR_M = 0.5
"""Within which rows match where boxes do not count."""
_BY_BOX = BoxMatch(0.5)
_SEEN = 0.3
"""Share of a person from which on it counts: less is a don't-care in truth.txt."""
_VISIBLE_S = 1.0
"""Who is seen so long without a break should be detected."""
_KINDS = ("detected", "kept", "detected_by_place", "kept_by_place")
"""Of people; "by place" where only tracks count that stand nearer to them than to anybody else."""
_SCORES = (
    *("tracking_accuracy", "MOTA", "IDF1", "HOTA", "id_switches"),
    *("people_kept", "people_detected", "misses", "false_positives", "truth_rows"),
)


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """What is true of a rendered clip.

    Attributes:
        columns: of truth.txt, sorted by frame.
        fps: frames a second.
        visible: who is seen, at least three tenths of them, for a second without a break.
    """

    columns: Columns
    fps: float
    visible: frozenset[int]

    @property
    def table(self) -> ScoringTable:
        """As it is scored, with don't-cares."""
        return ScoringTable.from_columns(dict(self.columns), dont_cares=True)


def truth_of(folder: Path) -> Truth:
    """The truth beside a rendered recording."""
    with open_recording(folder) as recording:
        fps = recording.fps
    columns = read_mot(folder / "truth.txt")
    order = np.lexsort((columns["track"], columns["frame"]))
    columns = {name: column[order] for name, column in columns.items()}
    seen = read_visibility(folder / VISIBILITY)
    enough = seen.share >= _SEEN
    visible = visible_for(seen.frame[enough], seen.person[enough], round(_VISIBLE_S * fps))
    return Truth(columns, fps, visible)


def visible_for(frame: NDArray[Any], person: NDArray[Any], least: int) -> frozenset[int]:
    """Who is in so many consecutive frames.

    Args:
        frame, person: (n,) rows in which somebody is seen well enough.
        least: frames.
    """
    found = set()
    for one in np.unique(person).tolist():
        frames = np.unique(frame[person == one])
        ends = np.concatenate(([-1], np.flatnonzero(np.diff(frames) > 1), [len(frames) - 1]))
        if np.diff(ends).max() >= least:
            found.add(one)
    return frozenset(found)


def figures_of(score: Score) -> Figures:
    """What is told of a score."""
    figures = score.as_json()
    told = {name: figures[name] for name in _SCORES}
    return {**told, "error_m": figures["position_error_m"]["mean"]}


def trackers(clips: OfScene) -> Figures:
    """Each tracker's figures as it comes, over everything and by scene."""
    found = {
        scene: [_scored_runs(folder_of(clip)) for clip in several]
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


def tables(clips: OfScene) -> Figures:
    """Of each scene of the papers, by column: who is detected, and who is kept."""
    return {scene: _columns(scene, several) for scene, several in clips.items() if scene in PAPERS}


def _columns(scene: str, clips: Sequence[Clip]) -> Figures:
    columns = columns_of(scene)
    found: Figures = {name: {kind: [] for kind in _KINDS} for name in columns}
    for clip in clips:
        folder = folder_of(clip)
        truth, runs = truth_of(folder), runs_over(folder, list(columns.values()))
        for name, case in columns.items():
            _add(found[name], truth, runs[case].tracks, folder.name)
    return found


def _add(column: Figures, truth: Truth, tracks: Columns, clip: str) -> None:
    """One clip's people; each is named by clip and id."""
    examined = examine(truth.table, ScoringTable.from_columns(tracks), _BY_BOX)
    by_place = examined.matched.some(stand_there(truth.columns, examined))
    people = np.unique(examined.comparison.truth.track)
    for matched, kinds in ((examined.matched, _KINDS[:2]), (by_place, _KINDS[2:])):
        flags = detected_and_kept(examined.comparison, matched)
        for kind, flag in zip(kinds, flags, strict=True):
            column[kind] += [f"{clip}/{person}" for person in people[flag]]


def stand_there(truth: Columns, examined: Examination) -> NDArray[np.bool_]:
    """(k,) whether each matched track stands nearer to its person than to anybody else.

    Args:
        truth: everybody of whom anything is seen, sorted by frame.
        examined: what was matched.
    """
    rows, own = examined.matched.rows, examined.comparison.truth
    place = examined.comparison.result.position[rows.result]
    right = np.ones(len(place), bool)
    for number, row in enumerate(rows.truth.tolist()):
        start, end = np.searchsorted(truth["frame"], (own.frame[row], own.frame[row] + 1))
        away = np.hypot(
            *(truth[axis][start:end] - at for axis, at in zip("xy", place[number], strict=True))
        )
        right[number] = truth["track"][start + int(np.argmin(away))] == own.track[row]
    return right


def goals(clips: OfScene) -> Figures:
    """Of each scene: how well our tracker does."""
    return {
        scene: _scored([folder_of(clip) for clip in several]) for scene, several in clips.items()
    }


def _scored(folders: Sequence[Path]) -> Figures:
    scores, by_floor, visible, detected = [], [], 0, 0
    for place in folders:
        truth, tracks = truth_of(place), ScoringTable.from_columns(run_of(place, OURS).tracks)
        examined = examine(truth.table, tracks, _BY_BOX)
        scores.append(score_of(examined))
        by_floor.append(score(truth.table, tracks, FloorMatch(FLOOR_M)))
        found = {one.person for one in per_person_of(examined) if one.followed.detected}
        visible += len(truth.visible)
        detected += len(truth.visible & found)
    return {
        **figures_of(combined(scores)),
        "by_floor": figures_of(combined(by_floor)),
        "visible": visible,
        "visible_detected": detected,
        "clips": [place.name for place in folders],
    }


def robustness(clips: OfScene) -> list[Figures]:
    """Scores of clips with troubled cameras, and for how long a track stood where nobody was."""
    found = [("part of the light goes out", clip, folder_of(clip)) for clip in dimmed(clips)]
    for clip in sound(clips):
        folder = folder_of(clip)
        found.append(("nothing", clip, folder))
        found += [(one.name, clip, troubled(folder, one)) for one in TROUBLES]
    return [{"what": what, "clip": clip.scene, **_robust(folder)} for what, clip, folder in found]


def _robust(folder: Path) -> Figures:
    truth, tracks = truth_of(folder), run_of(folder, OURS).tracks
    result = score(truth.table, ScoringTable.from_columns(tracks), _BY_BOX)
    alone_s = ghosts_s(dict(truth.columns), tracks, truth.fps)
    return {**figures_of(result), "alone_s": float(alone_s.max(initial=0.0))}
