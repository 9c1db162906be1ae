from __future__ import annotations

import dataclasses
import sys
from collections.abc import Sequence

import numpy as np
import pytest
from people_on_a_floor import Errors, Walker, observations, straight, view

from tracking.trackers import Observation, StepResult
from tracking.trackers.stereo.colour import HalvesOfFirstFrames, StereoColourSettings
from tracking.trackers.stereo.direction import MiddleUpdated, StereoDirectionSettings
from tracking.trackers.stereo.tracker import StereoTracker


def direction_tracker(seed: int = 0, **settings: object) -> StereoTracker:
    chosen = StereoDirectionSettings(**{"particles": 200, **settings})
    return StereoTracker(view(), chosen, MiddleUpdated(chosen), seed)


def colour_tracker(seed: int = 0, **settings: object) -> StereoTracker:
    chosen = StereoColourSettings(**{"particles": 200, **settings})
    return StereoTracker(view(), chosen, HalvesOfFirstFrames(chosen), seed)


both_trackers = pytest.mark.parametrize("tracker", [direction_tracker, colour_tracker])


def follow(
    tracker: StereoTracker, walkers: Sequence[Walker], errors: Errors | None = None, seed: int = 0
) -> list[StepResult]:
    return [tracker.step(each) for each in observations(walkers, seed, errors)]


def ids(results: Sequence[StepResult]) -> set[int]:
    return {int(track) for result in results for track in result.tracks["track"]}


def id_near(result: StepResult, xy: np.ndarray) -> int:
    away = np.hypot(result.tracks["x"] - xy[0], result.tracks["y"] - xy[1])
    assert away.min() < 0.6
    return int(result.tracks["track"][away.argmin()])


def keeps_id(results: Sequence[StepResult], walker: Walker) -> bool:
    return id_near(results[15], walker.path[15]) == id_near(
        results[-1], walker.path[len(results) - 1]
    )


@both_trackers
def test_a_walker_is_followed_under_one_id_and_close_to_the_truth(tracker):
    walker = Walker(straight((-2, 5), (1.2, 0.3), 60))
    results = follow(tracker(), [walker], Errors(noise_m=0.05))
    assert ids(results) == {1}
    error = [
        np.hypot(r.tracks["x"][0] - x, r.tracks["y"][0] - y)
        for r, (x, y) in zip(results[10:], walker.path[10:], strict=True)
    ]
    assert np.mean(error) < 0.08
    assert abs(results[-1].tracks["vx"][0] - 1.2) < 0.25


@both_trackers
def test_the_same_seed_gives_the_same_bytes_and_another_seed_other_particles(tracker):
    walkers = [Walker(straight((-2, 5), (1, 0), 20)), Walker(straight((1, 6), (0, -1), 20))]
    one, two, other = (follow(tracker(seed), walkers)[-1] for seed in (4, 4, 5))
    for columns in ("tracks", "detections", "particles", "associations"):
        for name, column in getattr(one, columns).items():
            assert column.tobytes() == getattr(two, columns)[name].tobytes()
    assert one.particles["x"].tobytes() != other.particles["x"].tobytes()


@both_trackers
def test_crossing_people_whose_regions_merge_are_carried_by_prediction_and_keep_their_ids(tracker):
    walkers = [
        Walker(straight((-2, 5), (1, 0), 80), hue=3),
        Walker(straight((2, 5.2), (-1, 0), 80), hue=3),
    ]
    results = follow(tracker(), walkers, Errors(noise_m=0.05, merged_below_m=0.6))
    assert ids(results) == {1, 2}
    assert all(keeps_id(results, walker) for walker in walkers)
    assert results[40].tracks["predicted"].all()
    assert len(results[40].associations["track"]) == 0
    assert not results[60].tracks["predicted"].any()


def test_a_tentative_track_is_not_reported_before_it_was_seen_often_enough():
    results = follow(direction_tracker(confirm_matches=4), [Walker(straight((0, 5), (0, 0), 10))])
    assert [len(r.tracks["track"]) for r in results] == [0, 0, 0, *[1] * 7]


@both_trackers
def test_false_alarms_that_do_not_stay_become_no_tracks(tracker):
    nobody = Walker(np.full((60, 2), np.nan))
    results = follow(tracker(), [nobody], Errors(false_alarms=0.5))
    assert ids(results) == set()


def test_ids_have_no_gaps():
    walkers = [Walker(straight((x, 5), (0, 0.2), 40), hue=x + 2) for x in (-2, 0, 2)]
    results = follow(direction_tracker(), walkers, Errors(false_alarms=0.3))
    assert ids(results) == {1, 2, 3}


def test_a_person_not_seen_is_predicted_and_found_again():
    path = straight((-2, 5), (1, 0), 70)
    path[30:50] = np.nan
    results = follow(direction_tracker(), [Walker(path)])
    assert ids(results) == {1}
    assert results[45].tracks["predicted"].all()
    assert results[45].tracks["x"][0] == pytest.approx(-2 + 45 / 20, abs=0.3)
    assert not results[60].tracks["predicted"].any()


def test_particles_spread_and_confidence_falls_while_a_person_is_missed():
    path = straight((-1, 5), (0.5, 0), 60)
    path[30:] = np.nan
    results = follow(direction_tracker(), [Walker(path)])
    spread = [results[frame].particles["x"].std() for frame in (29, 40, 55)]
    assert spread == sorted(spread)
    assert results[55].tracks["confidence"][0] < results[29].tracks["confidence"][0]


def test_a_person_missed_too_long_ends_and_counts_as_a_new_one_on_return():
    path = straight((0, 5), (0.1, 0), 140)
    path[30:100] = np.nan
    results = follow(direction_tracker(delete_after_s=2.0), [Walker(path)])
    assert len(results[68].tracks["track"]) == 1
    assert len(results[75].tracks["track"]) == 0
    assert ids(results) == {1, 2}


def test_a_person_who_walks_out_of_the_picture_ends_at_once():
    path = straight((2.0, 5), (2.0, 0), 60)
    outside = np.flatnonzero(view().pixel_from_world(np.c_[path, np.zeros(60)])[:, 0] > 640)[0]
    path[outside:] = np.nan
    results = follow(direction_tracker(delete_after_s=10.0), [Walker(path)])
    assert len(results[outside - 1].tracks["track"]) == 1
    assert len(results[outside + 12].tracks["track"]) == 0


def test_a_standing_person_gives_no_direction_and_a_walking_one_does():
    standing = follow(direction_tracker(), [Walker(straight((0, 5), (0, 0), 60))])
    walking = follow(direction_tracker(), [Walker(straight((-2, 5), (1, 0), 60))])
    assert np.isnan(standing[-1].associations["direction"]).all()
    assert (walking[-1].associations["direction"] < 0.2).all()


def test_the_first_paper_knows_no_direction():
    walking = follow(colour_tracker(), [Walker(straight((-2, 5), (1, 0), 60))])
    assert np.isnan(walking[-1].associations["direction"]).all()


def test_the_total_cost_is_the_sum_of_the_cues():
    plain = {"distance_weight": 1.0, "occlusion_weight": 0.0, "measurement_noise_growth": 0.0}
    walkers = [Walker(straight((-2, 5), (1, 0), 40)), Walker(straight((2, 6), (-1, 0), 40))]
    for result in follow(direction_tracker(**plain), walkers)[10:]:
        cues = result.associations
        parts = cues["distance"] + cues["colour"] + np.nan_to_num(cues["direction"])
        np.testing.assert_allclose(cues["total"], parts, rtol=1e-5)


def test_the_margin_shrinks_as_people_in_one_colour_meet():
    walkers = [
        Walker(straight((-1, 5), (0.8, 0), 50), hue=3),
        Walker(straight((1, 5.3), (-0.8, 0), 50), hue=3),
    ]
    results = follow(direction_tracker(), walkers, Errors(noise_m=0.02))
    apart, met = (np.nanmin(results[f].associations["margin"]) for f in (18, 25))
    assert met < apart


def test_colour_of_the_first_paper_is_the_mean_of_the_first_five_looks():
    cues = HalvesOfFirstFrames(StereoColourSettings())
    looks = np.random.default_rng(0).random((9, 1, 2, 16)).astype(np.float32)
    model = looks[0]
    for count in range(1, 9):
        model = cues.update_colours(model, looks[count], np.array([count], np.int32))
    np.testing.assert_allclose(model, looks[:5].mean(axis=0), rtol=1e-5)


def test_particles_are_grouped_by_track_and_weigh_one_each():
    walkers = [Walker(straight((x, 5), (0, 0.3), 20), hue=x + 3) for x in (-2, 0, 2)]
    result = follow(direction_tracker(particles=50), walkers)[-1]
    assert result.particles["track"].tolist() == [1] * 50 + [2] * 50 + [3] * 50
    np.testing.assert_allclose(
        np.add.reduceat(result.particles["weight"], [0, 50, 100]), 1.0, rtol=1e-4
    )


def test_people_do_not_change_when_others_are_listed_in_another_order():
    walkers = [Walker(straight((x, 5), (0.2, 0.3), 30), hue=x + 3) for x in (-2, 0, 2)]
    steps = list(observations(walkers))
    turned = [reversed_people(each) for each in steps]
    straight_, other = direction_tracker(), direction_tracker()
    one = [straight_.step(each) for each in steps][-1].tracks
    two = [other.step(each) for each in turned][-1].tracks
    np.testing.assert_allclose(np.sort(one["x"]), np.sort(two["x"]), atol=0.03)
    np.testing.assert_allclose(np.sort(one["y"]), np.sort(two["y"]), atol=0.03)


def reversed_people(observation: Observation) -> Observation:
    people = observation.people
    turned = {
        field.name: getattr(people, field.name)[::-1]
        for field in dataclasses.fields(people)
        if field.name != "regions"
    }
    return dataclasses.replace(observation, people=dataclasses.replace(people, **turned))


def python_calls(people: int, particles: int) -> int:
    """Calls of Python functions that one step takes."""
    places = np.stack(np.meshgrid(np.arange(-4.0, 5.0, 1.2), np.arange(4.0, 12.0, 1.2)), axis=-1)
    walkers = [Walker(straight(at, (0, 0.1), 8)) for at in places.reshape(-1, 2)[:people]]
    tracker = direction_tracker(particles=particles)
    *before, last = observations(walkers, errors=Errors(noise_m=0.01, noise_range=0.0))
    for each in before:
        tracker.step(each)
    calls = 0

    def count(frame: object, event: str, argument: object) -> None:
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        result = tracker.step(last)
    finally:
        sys.setprofile(None)
    assert len(result.tracks["track"]) == people
    return calls


def test_a_step_runs_no_python_loop_over_people_or_particles():
    assert python_calls(5, 20) == python_calls(40, 20) == python_calls(5, 2000)
