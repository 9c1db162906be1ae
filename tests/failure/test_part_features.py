"""The features: the paper's order, by time and not by frame."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from made_up_parts import as_parts, walk

from tracking.failure import (
    FEATURE_NAMES,
    FEATURE_SPAN_S,
    PastStates,
    part_features,
    part_states,
    states_before,
)


def test_relative_states_come_first_and_then_their_differences() -> None:
    now, before = np.zeros((3, 6)), np.zeros((3, 6))
    now[0] = (3, 0, 0, 0, 0, 0)
    before[2] = (0, 0, 0, 6, 0, 0)
    features = dict(zip(FEATURE_NAMES, part_features(now, before), strict=True))
    assert len(features) == 60
    assert list(features)[:36:6] == [
        *("head_x", "torso_x", "hip_leg_x"),
        *("head_x_change", "torso_x_change", "hip_leg_x_change"),
    ]
    assert (features["head_x"], features["torso_x"], features["hip_leg_x"]) == (2, -1, -1)
    assert (features["head_height"], features["head_height_change"]) == (0, 2)
    assert features["hip_leg_height_change"] == -4


@given(st.integers(0, 2**32), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))
def test_where_the_person_stands_makes_no_difference(seed: int, x: float, y: float) -> None:
    now, before = np.random.default_rng(seed).normal(0, 100, (2, 5, 3, 6))
    there = np.array([x, y, 0, 0, 0, 0])
    assert np.allclose(
        part_features(now, before),
        part_features(now + there, before + there),
        atol=1e-9,
        equal_nan=True,
    )


def test_a_state_that_is_not_known_leaves_no_feature_that_seems_to_be() -> None:
    now, before = np.zeros((1, 3, 6)), np.zeros((1, 3, 6))
    now[0, 1, 2] = np.nan
    features = dict(zip(FEATURE_NAMES, part_features(now, before)[0], strict=True))
    assert all(np.isnan(features[f"{part}_width"]) for part in ("head", "torso", "hip_leg"))


def _line(rates: np.ndarray, seconds: np.ndarray) -> np.ndarray:
    """States that grow steadily by time."""
    return seconds[:, None, None] * rates


@given(st.sampled_from([5.0, 10.0, 12.5, 25.0, 29.97, 60.0]))
def test_steady_motion_has_the_same_features_at_any_frame_rate(fps: float) -> None:
    rates = np.random.default_rng(3).normal(0, 20, (3, 6))
    seconds = np.arange(round(2 * fps)) / fps
    states, past = _line(rates, seconds), PastStates()
    for time_s, state in zip(seconds.tolist(), states, strict=True):
        before = past.before(time_s, np.array([7]), state[None])
        if time_s >= FEATURE_SPAN_S:
            assert np.allclose(before[0], state - FEATURE_SPAN_S * rates, atol=1e-9)
        past.remember(time_s, np.array([7]), state[None])


def test_a_younger_person_was_before_as_in_the_first_frame() -> None:
    past = PastStates()
    first = np.ones((1, 3, 6))
    past.remember(1.0, np.array([2]), first)
    assert np.array_equal(past.before(1.2, np.array([2]), first * 3), first)
    assert np.array_equal(past.before(1.0, np.array([2]), first * 3), first * 3)


def test_a_gap_is_bridged_straight_and_a_long_one_forgotten() -> None:
    past, track = PastStates(), np.array([2])
    past.remember(0.0, track, np.zeros((1, 3, 6)))
    now = np.ones((1, 3, 6))
    assert np.allclose(past.before(1.0, track, now), 0.5)
    assert np.allclose(past.before(2.5, track, now), 1.0)


def test_the_last_word_on_a_frame_counts() -> None:
    past, track = PastStates(), np.array([2])
    past.remember(0.0, track, np.zeros((1, 3, 6)))
    past.remember(0.0, track, np.ones((1, 3, 6)))
    assert np.allclose(past.before(0.5, track, np.ones((1, 3, 6))), 1.0)


@given(st.data())
def test_frame_by_frame_and_a_whole_run_at_once_agree(data: st.DataObject) -> None:
    random = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    fps = data.draw(st.sampled_from([4.0, 7.5, 20.0, 29.97]))
    frames = np.arange(data.draw(st.integers(1, 80)))
    there = random.random((len(frames), 3)) < data.draw(st.sampled_from([0.1, 0.5, 0.95]))
    row, track = np.nonzero(there)
    states = random.normal(0, 50, (len(row), 3, 6))
    times = frames[row] / fps
    past, step_by_step = PastStates(), np.zeros_like(states)
    for frame in frames:
        of_frame = row == frame
        step_by_step[of_frame] = past.before(frame / fps, track[of_frame], states[of_frame])
        past.remember(frame / fps, track[of_frame], states[of_frame])
    shuffled = random.permutation(len(row))
    at_once = states_before(
        times[shuffled], track[shuffled], states[shuffled], np.argsort(shuffled)
    )
    assert np.allclose(at_once, step_by_step, atol=1e-9)


def test_states_of_a_run_are_by_person_and_frame_and_whole() -> None:
    states, _ = walk(np.random.default_rng(0), 10)
    parts = as_parts(states, 4, first=5)
    order = np.random.default_rng(1).permutation(30)
    parts = {name: column[order] for name, column in parts.items()}
    parts["cy"][(parts["frame"] == 8) & (parts["part"] == 1)] = np.nan
    seen = part_states(parts, 20.0)
    assert seen.frame.tolist() == [5, 6, 7, 9, 10, 11, 12, 13, 14]
    tracks, frames = np.array([4, 3, 4]), np.array([8, 7, 9])
    rows = seen.rows_of(tracks, frames)
    assert rows.tolist() == [-1, -1, 3]
    at = int(rows[2])
    assert np.array_equal(seen.states[at, :, :4], states[4, :, :4])
    assert np.allclose(seen.states[at, :, 4:], states[4, :, 4:] * 20)


def test_evidence_comes_last_and_is_not_known_where_none_is_given() -> None:
    now, before = np.zeros((2, 2, 3, 6))
    evidence = np.arange(48.0).reshape(2, 3, 8)
    features = part_features(now, before, evidence)
    assert np.array_equal(features[:, 36:], evidence.reshape(2, 24))
    assert FEATURE_NAMES[36:38] == ("head_support", "head_above")
    assert np.isnan(part_features(now, before)[:, 36:]).all()
