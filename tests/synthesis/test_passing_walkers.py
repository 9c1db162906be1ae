"""Crowds that walk through a passage."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.synthesis import SCENES, Scene
from tracking.synthesis.crowd import walk
from tracking.synthesis.passages import plan_passage


def _places(name: str, people: int, seconds: float, seed: int) -> np.ndarray:
    spec = SCENES[name]
    assert spec.passage is not None
    plans = plan_passage(spec.passage, people, seconds, np.random.default_rng(seed))
    frames = round(seconds * spec.fps)
    table = np.full((frames, people, 2), np.nan)
    for column, way in enumerate(walk(spec, plans, frames, spec.fps)):
        if way is not None:
            table[way.frames.start : way.frames.stop, column] = way.position
    return table


@pytest.mark.parametrize("name", ["lane", "two-way"])
def test_nobody_walks_through_the_walls_of_a_passage(name: str) -> None:
    passage = SCENES[name].passage
    assert passage is not None
    table = _places(name, 24, 40.0, 3)
    inside = (table[..., 1] > passage.near_m + 0.3) & (table[..., 1] < passage.far_m - 0.3)
    assert inside.any()
    assert np.abs(table[inside][:, 0]).max() < passage.half_width_m - 0.2


def _directions(table: np.ndarray) -> np.ndarray:
    """Metres that each person walked away from the camera, of those who came far."""
    way = [column[np.isfinite(column)] for column in table[..., 1].T]
    gone = np.array([y[-1] - y[0] for y in way if len(y)])
    return gone[np.abs(gone) > 5]


def test_people_walk_one_way_in_the_lane_and_both_in_the_passage() -> None:
    assert (_directions(_places("lane", 24, 40.0, 3)) < 0).all()
    both = _directions(_places("two-way", 24, 40.0, 3))
    assert (both < 0).sum() > 5
    assert (both > 0).sum() > 5


@pytest.mark.parametrize(("name", "most"), [("lane", 8), ("two-way", 8)])
def test_it_gets_crowded(name: str, most: int) -> None:
    spec = SCENES[name]
    table = _places(name, spec.people // 2, spec.seconds / 2, 4)
    passage = spec.passage
    assert passage is not None
    inside = (table[..., 1] > passage.near_m) & (table[..., 1] < passage.far_m)
    assert inside.sum(axis=1).max() >= most


def test_walls_hide_who_walks_behind_them() -> None:
    scene = Scene(SCENES["two-way"], people=6, seed=2, seconds=12.0, size=(160, 120))
    hidden = seen = 0
    for number in range(20, 120, 4):
        places = scene.places(number)
        _, truth = scene.frame(number)
        people = scene.on_floor(number)
        behind = (np.abs(places[:, 0]) > 3.4) & (places[:, 1] > 11.2)
        hidden += int(behind.sum())
        assert not set((people[behind] + 1).tolist()) & set(truth.track.tolist())
        seen += len(truth)
    assert hidden
    assert seen
