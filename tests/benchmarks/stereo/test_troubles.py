"""Sound recordings become those of poorer cameras, the same each time, and nothing else changes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.stereo.troubles import TROUBLES, Trouble, beside, troubled
from tracking.recording import Recording, open_recording
from tracking.synthesis import render_recording

PICTURE = np.random.default_rng(3).integers(60, 180, (48, 64, 3)).astype(np.uint8)


@pytest.mark.parametrize("trouble", [t for t in TROUBLES if t.is_optical], ids=lambda one: one.name)
def test_a_disturbance_is_the_same_each_time_and_spoils_the_cameras_it_names(
    trouble: Trouble,
) -> None:
    left, right = (trouble.seen(PICTURE, 5, side) for side in (0, 1))
    assert (right == trouble.seen(PICTURE, 5, 1)).all()
    assert (right != PICTURE).any()
    both = bool(trouble.noise or trouble.flicker)
    assert bool((left != PICTURE).any()) == both


def test_a_camera_that_is_lower_shows_the_same_in_another_row() -> None:
    seen = Trouble("lower", lower_px=2.0).seen(PICTURE, 0, 1)
    assert (seen[2:] == PICTURE[:-2]).all()


def test_a_disturbed_recording_has_the_truth_and_the_length_of_the_sound_one(
    tmp_path: Path,
) -> None:
    sound = render_recording(tmp_path / "clip", "lobby", 0.3, 1, 6001, size=(64, 48))
    made = troubled(sound, Trouble("dim, and noisy", noise=20.0))
    assert (made / "truth.txt").read_bytes() == (sound / "truth.txt").read_bytes()
    assert troubled(sound, Trouble("dim, and noisy", noise=20.0)) == made
    with open_recording(sound) as a, open_recording(made) as b:
        assert b.frame_count == a.frame_count
        assert np.abs(a.read(3).left.astype(int) - b.read(3).left).mean() > 3


def test_a_clip_is_made_anew_when_what_is_done_to_it_changes(tmp_path: Path) -> None:
    source, clip, trouble = tmp_path / "doing.py", tmp_path / "clip", Trouble("dim", noise=2.0)
    source.write_text("one = 1")
    kept = beside(clip, trouble, source)
    assert beside(clip, trouble, source) == kept
    assert beside(clip, replace(trouble, noise=3.0), source) != kept
    source.write_text("one = 2")
    assert beside(clip, trouble, source) != kept


def test_a_troubled_right_camera_shows_other_pictures_and_the_left_its_own(tmp_path: Path) -> None:
    sound = render_recording(tmp_path / "clip", "lobby", 0.5, 1, 6001, size=(64, 48))
    late = troubled(sound, Trouble("late", lag=2))
    dark = troubled(sound, Trouble("dark", dark=True, start_s=0.2, end_s=0.4))
    assert (late / "truth.txt").read_bytes() == (sound / "truth.txt").read_bytes()
    with open_recording(sound) as a, open_recording(late) as b, open_recording(dark) as c:
        assert b.frame_count == c.frame_count == a.frame_count
        assert (a.read(7).left == b.read(7).left).all()
        assert [_brightest(c, n) > 40 for n in (3, 4, 7, 8)] == [True, False, False, True]


def _brightest(recording: Recording, frame: int) -> int:
    right = recording.read(frame).right
    assert right is not None
    return int(right.max())


def test_a_late_camera_is_late_by_its_lag_and_a_still_one_keeps_its_last_picture() -> None:
    assert [Trouble("late", lag=2).shown(n, 20.0) for n in (0, 1, 2, 9)] == [0, 0, 0, 7]
    still = Trouble("still", still=True, start_s=1.0, end_s=2.0)
    assert [still.shown(n, 20.0) for n in (19, 20, 39, 40)] == [19, 19, 19, 40]
