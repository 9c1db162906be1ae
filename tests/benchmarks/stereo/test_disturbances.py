"""Sound recordings become those of poorer cameras, the same each time, and nothing else changes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.kept_results import beside
from tests.benchmarks.stereo.disturbances import DISTURBANCES, Disturbance, disturbed
from tests.benchmarks.stereo.troubles import Trouble, troubled
from tracking.recording import open_recording
from tracking.synthesis import render_recording

PICTURE = np.random.default_rng(3).integers(60, 180, (48, 64, 3)).astype(np.uint8)


@pytest.mark.parametrize("disturbance", DISTURBANCES, ids=lambda one: one.name)
def test_a_disturbance_is_the_same_each_time_and_spoils_the_cameras_it_names(
    disturbance: Disturbance,
) -> None:
    left, right = (disturbance.seen(PICTURE, 5, side) for side in (0, 1))
    assert (right == disturbance.seen(PICTURE, 5, 1)).all()
    assert (right != PICTURE).any()
    both = bool(disturbance.noise or disturbance.flicker)
    assert bool((left != PICTURE).any()) == both


def test_a_camera_that_is_lower_shows_the_same_in_another_row() -> None:
    seen = Disturbance("lower", lower_px=2.0).seen(PICTURE, 0, 1)
    assert (seen[2:] == PICTURE[:-2]).all()


def test_a_disturbed_recording_has_the_truth_and_the_length_of_the_sound_one(
    tmp_path: Path,
) -> None:
    sound = render_recording(tmp_path / "clip", "lobby", 0.3, 1, 6001, size=(64, 48))
    made = disturbed(sound, Disturbance("dim, and noisy", noise=20.0))
    assert (made / "truth.txt").read_bytes() == (sound / "truth.txt").read_bytes()
    assert disturbed(sound, Disturbance("dim, and noisy", noise=20.0)) == made
    with open_recording(sound) as a, open_recording(made) as b:
        assert b.frame_count == a.frame_count
        assert np.abs(a.read(3).left.astype(int) - b.read(3).left).mean() > 3


@pytest.mark.parametrize("done", [Disturbance("dim", noise=2.0), Trouble("late", lag=2)])
def test_a_clip_is_made_anew_when_what_is_done_to_it_changes(
    tmp_path: Path, done: Disturbance | Trouble
) -> None:
    source, clip = tmp_path / "doing.py", tmp_path / "clip"
    source.write_text("one = 1")
    kept = beside(clip, done, source)
    assert beside(clip, done, source) == kept
    changed = {"noise": 3.0} if isinstance(done, Disturbance) else {"lag": 3}
    assert beside(clip, replace(done, **changed), source) != kept
    source.write_text("one = 2")
    assert beside(clip, done, source) != kept


def test_disturbances_of_one_name_are_clips_of_their_own(tmp_path: Path) -> None:
    sound = render_recording(tmp_path / "clip", "lobby", 0.2, 1, 6001, size=(64, 48))
    little, much = (disturbed(sound, Disturbance("noise", noise=n)) for n in (2.0, 20.0))
    assert little != much
    assert troubled(sound, Trouble("late", lag=1)) != troubled(sound, Trouble("late", lag=2))
