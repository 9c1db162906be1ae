"""The ramp of the background difference, and what shadows weigh in it."""

from __future__ import annotations

import numpy as np

from tracking.foreground import BackgroundModel, RampSettings, ShadowWeights, ramp

FPS = 20.0
SHAPE = (120, 160)


def _floor() -> np.ndarray:
    random = np.random.default_rng(4)
    return random.integers(120, 150, (*SHAPE, 1)).repeat(3, axis=2).astype(np.uint8)


def _model(floor: np.ndarray) -> BackgroundModel:
    model = BackgroundModel(FPS)
    model.learn([floor, floor])
    return model


def test_the_ramp_rises_from_a_part_of_the_limit_to_a_multiple_of_it() -> None:
    floor = np.full((*SHAPE, 3), 100, np.uint8)
    model = _model(floor)
    limit = int(model.limit[60, 80])
    steps = np.array([0.25, 0.5, 1.0, 1.5, 2.0, 4.0])
    seen = floor.copy()
    for k, share in enumerate(steps):
        seen[20:100, 10 + 24 * k : 28 + 24 * k, 2] = 100 + round(share * limit)
    found = ramp(model.subtract(seen), model, RampSettings(low=0.5, high=2.0))
    levels = [int(found[60, 19 + 24 * k]) for k in range(len(steps))]
    assert np.allclose(levels, 255 * np.clip((steps - 0.5) / 1.5, 0, 1), atol=9)
    assert found[5, 5] == 0


def test_a_change_of_the_whole_scene_shows_nobody() -> None:
    floor = _floor()
    model = _model(floor)
    other = np.random.default_rng(5).integers(0, 80, floor.shape).astype(np.uint8)
    subtraction = model.subtract(other)
    assert subtraction.scene_changed
    assert not ramp(subtraction, model, RampSettings()).any()


def test_shadows_are_learnt_from_what_lies_beside_people() -> None:
    floor = _floor()
    model, weights = _model(floor), ShadowWeights()
    seen = floor.copy()
    seen[30:90, 30:60] = (floor[30:90, 30:60] * 0.72).astype(np.uint8)
    jacket = np.clip(floor[30:90, 90:120].mean() * 0.55, 0, 255)
    seen[30:90, 90:120] = jacket.astype(np.uint8)
    on, off = np.zeros(SHAPE, np.uint8), np.zeros(SHAPE, np.uint8)
    off[25:95, 25:65] = 1
    on[25:95, 85:125] = 1
    subtraction = model.subtract(seen)
    for _ in range(25):
        weights.weigh(subtraction)
        weights.learn(subtraction.mask, on, off)
    found = weights.weigh(subtraction)
    assert found[40:80, 40:50].mean() < 40
    assert found[40:80, 95:115].mean() > 200


def test_what_is_brighter_than_the_background_is_no_shadow() -> None:
    floor = _floor()
    model, weights = _model(floor), ShadowWeights()
    seen = floor.copy()
    seen[30:90, 30:60] = 230
    subtraction = model.subtract(seen)
    found = weights.weigh(subtraction)
    assert (found[35:85, 35:55] == 255).all()
    assert (found[100:, 100:] == 255).all()


def test_a_frame_without_foreground_teaches_nothing() -> None:
    floor = _floor()
    model, weights = _model(floor), ShadowWeights()
    before = weights._on.copy()
    subtraction = model.subtract(floor)
    everywhere = np.ones(SHAPE, np.uint8)
    weights.weigh(subtraction)
    weights.learn(subtraction.mask, everywhere, everywhere)
    assert np.array_equal(weights._on, before)
