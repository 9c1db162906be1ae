from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from people_on_a_floor import FPS, Errors, Walker, observations, straight, view

from tracking.trackers import StepResult
from tracking.trackers.joint import JointSettings
from tracking.trackers.joint.tracker import JointTracker

QUIET = Errors(noise_m=0.03, noise_range=0.0, colour=0.02)


def tracker(seed: int = 0, **settings: object) -> JointTracker:
    return JointTracker(view(), JointSettings(**{"particles": 200, **settings}), seed)


def follow(
    walkers: Sequence[Walker], errors: Errors = QUIET, seed: int = 0, **settings: object
) -> list[StepResult]:
    own = tracker(seed, **settings)
    return [own.step(each) for each in observations(walkers, seed, errors)]


def ids(results: Sequence[StepResult]) -> set[int]:
    return {int(track) for result in results for track in result.tracks["track"]}


def id_near(result: StepResult, xy: np.ndarray) -> int:
    away = np.hypot(result.tracks["x"] - xy[0], result.tracks["y"] - xy[1])
    assert away.min() < 0.5
    return int(result.tracks["track"][away.argmin()])


def error_m(results: Sequence[StepResult], walker: Walker) -> float:
    off = [
        np.hypot(
            r.tracks["x"][0] - walker.path[r.frame, 0], r.tracks["y"][0] - walker.path[r.frame, 1]
        )
        for r in results
    ]
    return float(np.mean(off))


def test_a_walker_is_placed_better_than_seen():
    walker = Walker(straight((-2, 5), (1.2, 0.3), 80))
    noise_m = 0.08
    results = follow([walker], Errors(noise_m=noise_m, noise_range=0.0))
    assert ids(results) == {1}
    seen_m = noise_m * np.sqrt(np.pi / 2)
    assert error_m(results[20:], walker) < 0.8 * seen_m


@pytest.mark.parametrize("odd_s", [0.001, 0.0, -0.02, 0.4], ids=["soon", "same", "back", "late"])
def test_a_frame_at_an_odd_time_makes_nobody_forgotten(odd_s: float):
    path = straight((-2, 5), (1, 0), 70)
    path[37:45] = np.nan
    own, tracked, moved_s = tracker(), [], 0.0
    for each in observations([Walker(path)], 0, QUIET):
        moved_s += odd_s - 1 / FPS if each.frame == 41 else 0.0
        tracked.append(own.step(replace(each, time_s=each.time_s + moved_s)))
    assert ids(tracked) == {1}
    assert ids(tracked[50:]) == {1}


def test_the_same_seed_gives_the_same_bytes():
    walkers = [Walker(straight((-2, 5), (1, 0), 20)), Walker(straight((1, 6), (0, -1), 20))]
    one, two = (follow(walkers, seed=4)[-1] for _ in range(2))
    for columns in ("tracks", "particles", "associations"):
        for name, column in getattr(one, columns).items():
            assert column.tobytes() == getattr(two, columns)[name].tobytes()


@pytest.mark.parametrize("hues", [(3, 9), (3, 3)], ids=["own colours", "one colour"])
def test_people_who_cross_and_come_out_as_one_region_keep_their_ids(hues):
    walkers = [
        Walker(straight((-2, 5), (1, 0), 80), hues[0]),
        Walker(straight((2, 5.3), (-1, 0), 80), hues[1]),
    ]
    results = follow(walkers, Errors(noise_m=0.03, merged_below_m=0.5))
    assert ids(results) == {1, 2}
    for walker in walkers:
        assert id_near(results[10], walker.path[10]) == id_near(results[-1], walker.path[-1])


def turning(hue: int, frames: int = 120) -> Walker:
    """Walks to the right, is hidden for two seconds and comes out walking back, a metre off."""
    path = straight((-2, 6), (1, 0), frames)
    path[40:80] = np.nan
    path[80:] = straight((0.8, 6.9), (-1, 0), frames - 80)
    return Walker(path, hue)


def test_who_turned_while_hidden_is_found_again_by_colours():
    results = follow([turning(3)])
    assert ids(results) == {1}


def test_somebody_in_other_clothes_who_comes_out_there_is_somebody_new():
    gone, new = turning(3).path.copy(), turning(3).path.copy()
    gone[80:], new[:80] = np.nan, np.nan
    other = Walker(np.full((120, 2), [3.0, 8.0]), 6)
    results = follow([Walker(gone, 3), Walker(new, 11), other])
    assert len(ids(results)) == 3


def test_who_should_be_seen_and_is_not_coasts_without_being_reported():
    path = straight((-1, 6), (0.2, 0), 120)
    path[40:80] = np.nan
    results = follow([Walker(path, 3)])
    assert len(results[45].tracks["track"]) == 1
    assert len(results[70].tracks["track"]) == 0
    assert results[110].tracks["track"].tolist() == [1]


def test_who_enters_where_somebody_left_is_somebody_new():
    frames = 130
    leaving = straight((1.0, 5), (1.5, 0), frames)
    outside = np.flatnonzero(view().pixel_from_world(np.c_[leaving, np.zeros(frames)])[:, 0] > 640)[
        0
    ]
    entering = np.full((frames, 2), np.nan)
    later = outside + round(0.7 * FPS)
    entering[later:] = straight(leaving[outside], (-1.5, 0), frames - later)
    leaving[outside:] = np.nan
    results = follow([Walker(leaving, 3), Walker(entering, 3)])
    assert ids(results) == {1, 2}


def test_a_second_detection_of_somebody_becomes_no_track():
    path = straight((-1, 6), (0.5, 0), 60)
    beside = path + np.array([0.3, 0.0])
    beside[:20] = np.nan
    assert ids(follow([Walker(path, 3), Walker(beside, 3)])) == {1}


def test_false_alarms_that_do_not_stay_become_no_tracks():
    nobody = Walker(np.full((60, 2), np.nan))
    assert ids(follow([nobody], Errors(false_alarms=0.5))) == set()


def test_a_tentative_track_is_confirmed_once_seen_for_long_enough():
    results = follow([Walker(straight((0, 5), (0, 0), 20))], confirm_s=0.4)
    assert [len(r.tracks["track"]) for r in results] == [0] * 7 + [1] * 13
