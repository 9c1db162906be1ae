"""Recordings that begin late, in changing light, or with a camera that is knocked."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracking.errors import SettingsError
from tracking.synthesis import SCENES, Disturbances, Scene, render_recording

SIZE = (160, 120)


NO_DISTURBANCES = Disturbances()


def _scene(disturbances: Disturbances = NO_DISTURBANCES, seconds: float = 4.0) -> Scene:
    return Scene(SCENES["ceiling"], 8, 3, seconds=seconds, size=SIZE, disturbances=disturbances)


def test_a_recording_can_begin_with_people_in_it() -> None:
    late = _scene(Disturbances(begin_s=9.0))
    whole = _scene(seconds=13.0)
    assert late.frames == 80
    _, truth = late.frame(0)
    _, same = whole.frame(180)
    assert len(truth) > 0
    assert np.array_equal(truth.track, same.track)
    assert np.array_equal(truth.position, same.position)
    assert np.array_equal(late.places(0), whole.places(180))


def test_a_scene_that_begins_late_is_shorter() -> None:
    scene = Scene(SCENES["ceiling"], 1, 3, size=SIZE, disturbances=Disturbances(begin_s=28.0))
    assert scene.frames == 40


def test_the_light_goes_down_at_once_and_stays_down() -> None:
    dimmed, ordinary = _scene(Disturbances(dimmed_s=1.0)), _scene()
    shares = [
        dimmed.frame(n)[0].left.astype(float).mean() / ordinary.frame(n)[0].left.mean()
        for n in (0, 19, 30, 45, 79)
    ]
    assert shares[:2] == [1.0, 1.0]
    assert shares[1] > shares[2] > shares[3]
    assert shares[3] == pytest.approx(shares[4], abs=0.01)
    assert 0.7 < shares[4] < 0.95


def test_a_knock_moves_the_picture_and_the_boxes_but_not_the_people() -> None:
    bumped, ordinary = (
        Scene(SCENES["plaza"], 6, 3, seconds=8.0, size=SIZE, disturbances=disturbances)
        for disturbances in (Disturbances(bumped_s=5.0), NO_DISTURBANCES)
    )
    before, after = 99, 140
    (frame, _), (same, _) = bumped.frame(before), ordinary.frame(before)
    assert np.array_equal(frame.left, same.left)
    (frame, truth), (other, still) = bumped.frame(after), ordinary.frame(after)
    assert np.abs(frame.left.astype(float) - other.left).mean() > 2.0
    shared = np.isin(truth.track, still.track)
    rows = np.searchsorted(still.track, truth.track[shared])
    assert shared.any()
    assert np.array_equal(truth.position[shared], still.position[rows])
    assert np.abs(truth.box[shared, 1] - still.box[rows, 1]).min() > 1.0


def test_times_out_of_range_and_a_begin_after_the_end_are_told(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="dimmed is -1"):
        Disturbances(dimmed_s=-1.0)
    with pytest.raises(SettingsError, match="lasts 30 seconds"):
        render_recording(tmp_path / "out", "lobby", disturbances=Disturbances(begin_s=30.0))
    assert list(tmp_path.iterdir()) == []
