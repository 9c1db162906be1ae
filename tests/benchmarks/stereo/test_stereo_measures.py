"""Trackers for two cameras are measured, and who was not kept is told."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.benchmarks import runner
from tests.benchmarks.clips import Clip
from tests.benchmarks.stereo import measures
from tests.benchmarks.stereo.__main__ import PAGE
from tests.benchmarks.stereo.loss_context import LossContext
from tests.benchmarks.stereo.lost_people import counted, line
from tests.benchmarks.stereo.reasons import NotKept
from tracking.synthesis import Disturbances, render_recording


def test_trackers_and_goals_are_measured_and_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runner, "clips_cache", lambda: tmp_path)
    clip, late = Clip("lobby", 1), Disturbances(begin_s=8.0)
    render_recording(
        tmp_path / clip.name, "lobby", 1.0, 3, 6001, size=(320, 240), disturbances=late
    )
    clips = {"lobby": (clip,)}
    trackers = json.loads(json.dumps(measures.trackers(clips, tmp_path)))
    assert trackers["clips"] == [clip.name]
    assert trackers["all"] == trackers["scenes"]["lobby"]
    goals = measures.goals(clips, tmp_path)
    assert goals["lobby"]["IDF1"] == trackers["all"]["stereo-joint"]["IDF1"]
    page = PAGE.text({"trackers": trackers, "goals": {"fresh": goals, "often": goals}})
    assert "Take `stereo-" in page
    assert "the difference may be chance" in page


def test_somebody_not_kept_is_told_on_one_line_and_counted() -> None:
    around = LossContext("behind somebody", 4, 0.02)
    one = NotKept(7, "new id", 413, 396, 0, (6, 14), around)
    assert line(one) == (
        "person   7: new id, frames 396-413, track 6->14, behind somebody 4, 2 % seen"
    )
    assert counted([one, one]) == ["   2 new id, behind somebody"]
