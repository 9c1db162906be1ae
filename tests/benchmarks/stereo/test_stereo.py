"""Trackers for two cameras: clips for one purpose each, what is measured, what the page says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks import runner
from tests.benchmarks.clips import Clip
from tests.benchmarks.intervals import interval
from tests.benchmarks.stereo import measures
from tests.benchmarks.stereo.__main__ import ACCURACY_GOALS, PAGE
from tests.benchmarks.stereo.clips import (
    AS_THEY_COME,
    FIRST_FRESH,
    FRESH,
    OWN,
    REPORTED,
    TUNED,
    columns_of,
)
from tracking.scoring import BoxMatch, ScoringTable, examine
from tracking.synthesis import SCENES, Disturbances, render_recording
from tracking.trackers import TRACKERS


def test_wilson_s_interval_of_few_people_is_wide() -> None:
    assert interval(9, 10) == pytest.approx((0.5958, 0.9821), abs=1e-4)
    assert interval(0, 0) == (0.0, 1.0)


def test_no_clip_is_used_for_two_purposes_and_enough_people_come_by() -> None:
    for scene, fresh in FRESH.items():
        seeds = [{clip.seed for clip in clips[scene]} for clips in (FRESH, REPORTED, TUNED)]
        assert sum(map(len, seeds)) == len(set.union(*seeds))
        assert min(seeds[0]) >= FIRST_FRESH
        assert len(fresh) == 4 * len(REPORTED[scene])
    for scene in ACCURACY_GOALS:
        assert len(REPORTED[scene]) * (SCENES[scene].people - 1) >= 30


def test_every_column_is_the_papers_own_method_but_ours() -> None:
    for scene in ("indoor", "lobby"):
        for name, case in columns_of(scene).items():
            assert name == OWN or case.chosen().paper


def test_every_tracker_for_two_cameras_is_compared_as_it_comes() -> None:
    stereo = {spec.name for spec in TRACKERS.values() if spec.needs_stereo}
    assert stereo == set(map(str, AS_THEY_COME))


def test_trackers_and_goals_are_measured_and_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runner, "clips_cache", lambda: tmp_path)
    monkeypatch.setattr(measures, "folder_of", lambda clip: tmp_path / clip.name)
    clip, late = Clip("lobby", 1), Disturbances(begin_s=8.0)
    render_recording(
        tmp_path / clip.name, "lobby", 1.0, 3, 6001, size=(320, 240), disturbances=late
    )
    clips = {"lobby": (clip,)}
    trackers = json.loads(json.dumps(measures.trackers(clips)))
    assert trackers["clips"] == [clip.name]
    assert trackers["all"] == trackers["scenes"]["lobby"]
    goals = measures.goals(clips)
    assert goals["lobby"]["IDF1"] == trackers["all"]["stereo-joint"]["IDF1"]
    page = PAGE.text({"trackers": trackers, "goals": {"fresh": goals, "often": goals}})
    assert "Fisher's exact test" in page
    unjudged = PAGE.text({"goals": {"fresh": {}, "often": goals}})
    assert "have not been measured since" in unjudged
    assert "met" not in unjudged.partition("have not been measured")[2].replace("metres", "")


def _table(*rows: tuple[int, int, float]) -> dict[str, np.ndarray]:
    """Rows of frame, id and x in metres, as boxes 100 px a metre to the right."""
    frame, track, x = np.array(rows, float).T
    box = {"left": 100 * x, "top": 0 * x, "width": 0 * x + 60, "height": 0 * x + 100}
    return {"frame": frame, "track": track, **box, "x": x, "y": 0 * x}


def test_a_track_that_stands_nearer_to_somebody_else_is_matched_by_box_alone() -> None:
    truth = _table((0, 1, 0.0), (0, 2, 0.3), (1, 1, 0.0), (1, 2, 0.3))
    result = _table((0, 8, 0.01), (1, 8, 0.16))
    result["left"][1] = 0.0
    examined = examine(
        ScoringTable.from_columns(truth), ScoringTable.from_columns(result), BoxMatch(0.5)
    )
    assert measures.stand_there(truth, examined).tolist() == [True, False]


def test_only_who_is_seen_for_long_without_a_break_must_be_found() -> None:
    frame, person = np.arange(40), np.where(np.arange(40) % 15, 1, 2)
    frames = np.concatenate([frame, np.arange(20)])
    people = np.concatenate([person, np.full(20, 3)])
    assert measures.visible_for(frames, people, 20) == {3}


def _peers(switches: int, *others: int | None) -> dict[str, Any]:
    """Our tracker, with colours and without, finished; the others after it."""
    told = {"people": 15, "kept": 9, "idf1": 0.9, "hota": 0.8, "floor_error_m": 0.05, "ms": 1.0}
    own = [
        {
            "tracker": "stereo-joint",
            "ours": True,
            "colour": colour,
            "finished": True,
            "figures": {**told, "id_switches": switches},
        }
        for colour in (False, True)
    ]
    peers = [
        {
            "tracker": "SORT",
            "ours": False,
            "colour": False,
            "finished": False,
            "figures": None if count is None else {**told, "id_switches": count},
            "absent": "SORT is not installed",
        }
        for count in others
    ]
    return {"crossing": own + peers, "rendered": own + peers, "clips": ["lobby-1"]}


def test_switches_are_held_against_the_best_of_the_others_that_are_there() -> None:
    page = PAGE.sections({"peers": _peers(5, 30, 9, None)})["peers"]
    assert "Fewest switches of the others: 9." in page
    assert "without colours, no more: stereo-joint 5 finished (met)" in page
    assert "with colours, at most half: stereo-joint 5 finished (missed)" in page
    assert "| SORT | SORT is not installed |" in page
    assert "at most half" not in PAGE.sections({"peers": _peers(0, 0)})["peers"]
    assert "None of the others" in PAGE.sections({"peers": _peers(5, None)})["peers"]
