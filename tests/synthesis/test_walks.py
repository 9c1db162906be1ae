"""Ways over the floor and the steps on them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.synthesis import SCENES
from tracking.synthesis.crowd import CLOSEST_M, PlannedWalk, walk
from tracking.synthesis.gait import steps_of
from tracking.synthesis.itineraries import EMPTY_S, plan_itineraries
from tracking.synthesis.rig import Rig

FPS = 20.0


def _walks(name: str, people: int, seconds: float, seed: int) -> list[PlannedWalk]:
    spec = SCENES[name]
    rig = Rig.of_scene(spec, (640, 480))
    plans = plan_itineraries(spec, rig, people, seconds, np.random.default_rng(seed))
    ways = walk(spec, plans, round(seconds * FPS), FPS)
    return [way for way in ways if way is not None]


def _table(walks: list[PlannedWalk], frames: int) -> np.ndarray:
    table = np.full((frames, len(walks), 2), np.nan)
    for column, way in enumerate(walks):
        table[way.frames.start : way.frames.stop, column] = way.position
    return table


@pytest.mark.parametrize("name", ["plaza", "corridor", "lobby"])
@settings(max_examples=2, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_nobody_walks_through_anybody(name: str, seed: int) -> None:
    table = _table(_walks(name, 14, 20.0, seed), 400)
    gap = np.linalg.norm(table[:, :, None] - table[:, None], axis=-1)
    others = ~np.eye(table.shape[1], dtype=bool)
    assert np.nanmin(gap[:, others]) >= CLOSEST_M


def test_people_cross_close_to_each_other() -> None:
    table = _table(_walks("plaza", 12, 30.0, 1), 600)
    gap = np.linalg.norm(table[:, :, None] - table[:, None], axis=-1)
    gap[:, np.eye(12, dtype=bool)] = np.nan
    assert (np.nanmin(gap, axis=(0, 2)) < 1.0).sum() >= 6


def test_people_walk_at_people_s_speeds_and_some_stop() -> None:
    walks = _walks("plaza", 12, 30.0, 1)
    speeds = [np.linalg.norm(np.diff(way.position, axis=0), axis=1) * FPS for way in walks]
    assert max(speed.max() for speed in speeds) < 2.5
    assert all(0.4 < np.median(speed[speed > 0.3]) < 1.7 for speed in speeds)
    assert sum((speed < 0.1).sum() > 10 for speed in speeds) >= 2


def test_walks_neither_jump_nor_turn_on_a_penny() -> None:
    for way in _walks("corridor", 14, 20.0, 2):
        pace = np.diff(way.position, axis=0) * FPS
        assert np.abs(np.diff(pace, axis=0)).max() < 0.5
        assert np.abs(np.diff(way.heading)).max() * FPS < 3.0


def test_nobody_sets_off_before_the_background_can_be_learned() -> None:
    assert min(way.first_frame for way in _walks("square", 20, 20.0, 3)) >= EMPTY_S * FPS


def test_people_keep_out_of_pillars_and_walls() -> None:
    for way in _walks("pillars", 12, 20.0, 4):
        for x, y, radius in SCENES["pillars"].pillars_m:
            assert np.hypot(*(way.position - (x, y)).T).min() > radius + 0.2
        assert way.position[:, 1].max() < 12.5 - 0.3


def test_standing_feet_do_not_skate() -> None:
    for way in _walks("plaza", 6, 20.0, 5):
        steps = steps_of(way, 1.75, FPS, 0.3)
        moved = np.linalg.norm(np.diff(steps.foot, axis=0), axis=-1)
        share = (steps.phase[:, None] + np.array([0.0, 0.5])) % 1.0
        stands = (share[1:] < 0.6) & (share[:-1] < share[1:])
        assert moved[stands].max() < 1e-9
        assert steps.lift_m[1:][stands].max() < 1e-9


def test_feet_stay_under_the_body() -> None:
    for way in _walks("plaza", 6, 20.0, 5):
        steps = steps_of(way, 1.75, FPS, 0.3)
        away = np.linalg.norm(steps.foot - way.position[:, None], axis=-1)
        assert away.max() < 0.75
        assert np.linalg.norm(steps.foot.mean(axis=1) - way.position, axis=1).mean() < 0.15
