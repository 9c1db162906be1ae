"""Trackers of one clip share what is seen, and their runs are kept."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks.rendered_clips import Clip
from tests.benchmarks.stereo import choice, clip_scores, report, trackers
from tests.benchmarks.stereo.columns import OURS
from tests.benchmarks.stereo.loss_context import LossContext
from tests.benchmarks.stereo.lost_people import counted, line
from tests.benchmarks.stereo.reasons import NotKept
from tests.benchmarks.stereo.trackers import Variant, runs_over
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.synthesis import Disturbances, render_recording

FEWER = Variant("stereo-direction", (("particles", 50),))


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A second in which people are there from the start."""
    folder = tmp_path_factory.mktemp("clips") / "lobby-1"
    late = Disturbances(begin_s=8.0)
    return render_recording(folder, "lobby", 1.0, 3, 6001, size=(320, 240), disturbances=late)


def test_a_run_over_shared_perception_is_the_run_alone(clip: Path) -> None:
    seen = runs_over(clip, [FEWER, OURS])
    with open_recording(clip) as recording:
        for variant in (FEWER, OURS):
            with track(recording, variant.tracker, variant.chosen(), trackers.SEED) as alone:
                for _ in alone:
                    pass
                tracks = alone.run().tracks
            assert len(tracks["track"]) > 0
            for name, column in tracks.items():
                np.testing.assert_array_equal(seen[variant].tracks[name], column)


def test_a_run_is_tracked_once_until_sources_change(
    clip: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tracked: list[int] = []
    fresh = trackers._tracked

    def counting(*given: Any) -> Any:
        tracked.append(1)
        return fresh(*given)

    monkeypatch.setattr(trackers, "_tracked", counting)
    first, again = (runs_over(clip, [FEWER], tmp_path)[FEWER] for _ in range(2))
    assert len(tracked) == 1
    np.testing.assert_array_equal(first.tracks["x"], again.tracks["x"])
    monkeypatch.setattr(trackers, "sources", lambda: "edited")
    runs_over(clip, [FEWER], tmp_path)
    assert len(tracked) == 2


def test_a_kept_run_tells_what_seeing_and_following_took(clip: Path, tmp_path: Path) -> None:
    for _ in range(2):
        times = runs_over(clip, [FEWER, OURS], tmp_path)[FEWER].times
        assert times["frames"].tolist() == [20]
        assert 0 < times["following_s"][0] < times["seeing_s"][0] < 60


def test_trackers_and_goals_are_measured_and_written(clip: Path) -> None:
    of_scene = {"lobby": (Clip("lobby", 1),)}
    choices = json.loads(json.dumps(choice.measure(of_scene, clip.parent)))
    assert choices["clips"] == [clip.name]
    assert choices["all"] == choices["scenes"]["lobby"]
    goals = clip_scores.both(of_scene, of_scene, clip.parent)
    own = choices["all"][OURS.tracker]
    assert goals["fresh"]["lobby"]["IDF1"] == goals["often"]["lobby"]["IDF1"] == own["IDF1"]
    writers = report.writers()
    assert "Take `stereo-" in writers["trackers"](choices)
    assert "the difference may be chance" in writers["goals"](goals)


def test_somebody_not_kept_is_told_on_one_line_and_counted() -> None:
    around = LossContext("behind somebody", 4, 0.02)
    one = NotKept(7, "new id", 413, 396, 0, (6, 14), around)
    assert line(one) == (
        "person   7: new id, frames 396-413, track 6->14, behind somebody 4, 2 % seen"
    )
    assert counted([one, one]) == ["   2 new id, behind somebody"]
