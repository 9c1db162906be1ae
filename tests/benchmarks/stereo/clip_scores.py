"""The rendered scenes as plain figures: who is kept by which tracker, and how well ours scores."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.rendered_clips import Clip
from tests.benchmarks.stereo.clips import PAPERS, folder
from tests.benchmarks.stereo.columns import OURS, columns_of
from tests.benchmarks.stereo.reasons import VISIBLE_S, NotKept, matches_of, not_kept
from tests.benchmarks.stereo.trackers import Seen, runs_over
from tests.benchmarks.stereo.truth import Truth, truth_of, visible_for
from tracking.scoring import (
    BoxMatch,
    FloorMatch,
    Score,
    ScoringTable,
    combined,
    examine,
    per_person_of,
    score_of,
)
from tracking.scoring.papers import detected_and_kept

Figures = dict[str, Any]
OfScene = Mapping[str, Sequence[Clip]]

_KINDS = ("detected", "kept", "detected_by_place", "kept_by_place", "not_kept")
"""Of people; "by place" where only tracks count that stand nearer to them than to anybody else."""

FLOOR_M = 0.5
"""Within which rows match where boxes do not count."""

SCORES = ("tracking_accuracy", "MOTA", "IDF1", "HOTA", "id_switches")
_COUNTS = ("people_kept", "people_detected", "misses", "false_positives", "truth_rows")


def tables(of_scene: OfScene, kept: Path | None = None) -> Figures:
    """Of each scene of the papers, by column: who is detected, who is kept, why the others not."""
    return {
        scene: _columns(scene, clips, kept) for scene, clips in of_scene.items() if scene in PAPERS
    }


def goals(of_scene: OfScene, kept: Path | None = None) -> Figures:
    """Of each scene: how well our tracker does, and who is not kept."""
    return {
        scene: _scored([folder(clip, kept) for clip in clips]) for scene, clips in of_scene.items()
    }


def both(fresh: OfScene, often: OfScene, kept: Path | None = None) -> Figures:
    """The same of clips nobody has looked at, and of those that are measured after each change."""
    return {"fresh": goals(fresh, kept), "often": goals(often, kept)}


def not_kept_of(of_scene: OfScene, kept: Path | None = None) -> dict[str, list[Figures]]:
    """Of each scene: everybody our tracker did not keep."""
    return {
        scene: [one for clip in clips for one in _not_kept(folder(clip, kept))]
        for scene, clips in of_scene.items()
    }


def _not_kept(place: Path) -> list[Figures]:
    found = not_kept(truth_of(place), runs_over(place, [OURS])[OURS].tracks)
    return [told(one, place.name) for one in found]


def _columns(scene: str, clips: Sequence[Clip], kept: Path | None) -> Figures:
    columns = columns_of(scene)
    found: Figures = {name: {kind: [] for kind in _KINDS} for name in columns}
    for clip in clips:
        place = folder(clip, kept)
        truth = truth_of(place)
        runs = runs_over(place, list(columns.values()))
        for name, variant in columns.items():
            _add(found[name], truth, runs[variant], place.name)
    return found


def _add(column: Figures, truth: Truth, seen: Seen, clip: str) -> None:
    """One clip's people; each is named by clip and id."""
    examined = examine(truth.table, ScoringTable.from_columns(seen.tracks), BoxMatch(0.5))
    by_place = examined.matched.some(matches_of(truth, examined).right)
    people = np.unique(examined.comparison.truth.track)
    for matched, kinds in ((examined.matched, _KINDS[:2]), (by_place, _KINDS[2:4])):
        flags = detected_and_kept(examined.comparison, matched)
        for kind, flag in zip(kinds, flags, strict=True):
            column[kind] += [f"{clip}/{person}" for person in people[flag]]
    column["not_kept"] += [told(one, clip) for one in not_kept(truth, seen.tracks)]


def told(one: NotKept, clip: str) -> Figures:
    """Somebody who was not kept, as plain values."""
    return {"name": f"{clip}/{one.person}", "clip": clip, **_flat(asdict(one))}


def _flat(values: Figures) -> Figures:
    context = values.pop("context")
    return {**values, "tracks": list(values["tracks"]), **context}


def _scored(folders: Sequence[Path]) -> Figures:
    scores, by_floor, visible, detected = [], [], 0, 0
    for place in folders:
        truth = truth_of(place)
        tracks = ScoringTable.from_columns(runs_over(place, [OURS])[OURS].tracks)
        examined = examine(truth.table, tracks, BoxMatch(0.5))
        scores.append(score_of(examined))
        by_floor.append(score_of(examine(truth.table, tracks, FloorMatch(FLOOR_M))))
        seen = visible_for(truth, VISIBLE_S)
        found = {one.person for one in per_person_of(examined) if one.followed.detected}
        visible, detected = visible + len(seen), detected + len(seen & found)
    return {
        **figures_of(combined(scores)),
        "by_floor": figures_of(combined(by_floor)),
        "kept_by_clip": [score.as_json()["people_kept"] for score in scores],
        "detected_by_clip": [score.as_json()["people_detected"] for score in scores],
        "visible": visible,
        "visible_detected": detected,
        "clips": [place.name for place in folders],
    }


def figures_of(score: Score) -> Figures:
    """What is told of a score."""
    figures = score.as_json()
    return {
        **{name: figures[name] for name in (*SCORES, *_COUNTS)},
        "error_m": figures["position_error_m"]["mean"],
    }
