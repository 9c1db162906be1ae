"""What trackers notice of each row beside where it is."""

from __future__ import annotations

import numpy as np
from people_on_a_floor import Walker, observations, straight, view

from tracking.trackers import StepResult
from tracking.trackers.stereo.colour import HalvesOfFirstFrames, StereoColourSettings
from tracking.trackers.stereo.tracker import StereoTracker
from tracking.tracks import CLOTHES, SIGNAL_COLUMNS


def steps(walkers: list[Walker], seed: int = 0) -> list[StepResult]:
    settings = StereoColourSettings()
    tracker = StereoTracker(view(), settings, HalvesOfFirstFrames(settings), seed)
    return [tracker.step(observation) for observation in observations(walkers, seed)]


def walkers() -> list[Walker]:
    return [
        Walker(straight((-1, 5), (0.8, 0), 60), hue=0),
        Walker(straight((1, 8), (-0.5, 0), 60), hue=8),
    ]


def test_every_row_has_its_signals() -> None:
    for step in steps(walkers()):
        assert list(step.signals) == list(SIGNAL_COLUMNS)
        np.testing.assert_array_equal(step.signals["frame"], step.tracks["frame"])
        np.testing.assert_array_equal(step.signals["track"], step.tracks["track"])


def test_clothes_and_height_are_those_of_the_detection_matched() -> None:
    last = steps(walkers())[-1].signals
    assert len(last["track"]) == 2
    colours = np.stack([last[name] for name in CLOTHES], axis=1)
    assert np.linalg.norm(colours[0] - colours[1]) > 50
    np.testing.assert_allclose(last["height_m"], 1.7)


def test_of_somebody_not_seen_only_the_particles_are_told() -> None:
    path = straight((-1, 5), (0.5, 0), 60)
    path[40:] = np.nan
    both = [Walker(path, hue=0), Walker(straight((1.5, 8), (0, 0), 60), hue=8)]
    result = steps(both)[45]
    lost = result.tracks["predicted"]
    assert lost.any()
    assert np.isnan(result.signals["upper_l"][lost]).all()
    assert np.isnan(result.signals["height_m"][lost]).all()
    spread = result.signals["spread_m"]
    assert (spread[lost] > spread[~lost]).all()


def test_the_same_seed_notices_the_same() -> None:
    for one, other in zip(steps(walkers(), 3), steps(walkers(), 3), strict=True):
        for name in SIGNAL_COLUMNS:
            assert one.signals[name].tobytes() == other.signals[name].tobytes()
