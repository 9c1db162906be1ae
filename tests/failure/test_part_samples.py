"""What labels teach: the state their tracker was in, and twice where somebody put a part right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from made_up_parts import FPS, as_parts, box_of, made_up_samples, walk

from tracking.failure import (
    BESIDES,
    SAMPLE_COLUMNS,
    joined,
    no_samples,
    part_features,
    part_states,
    samples_of,
)
from tracking.tracks import PartLabel

FRAME, TRACK = 30, 4


@pytest.fixture(scope="module")
def parts() -> dict[str, np.ndarray]:
    return as_parts(walk(np.random.default_rng(5), 60, loses=False)[0], TRACK)


def tracked(parts, part: int, on: bool | None = True, **more) -> PartLabel:
    state = part_states(parts, FPS).states[FRAME, part]
    return PartLabel(FRAME, TRACK, part, box_of(state), on, "tracker", **more)


def said(samples) -> list[tuple[int, int, str]]:
    columns = (samples.columns[name].tolist() for name in ("part", "label", "source"))
    return list(zip(*columns, strict=True))


def test_a_judged_rectangle_is_a_sample_of_the_trackers_state(parts) -> None:
    label = tracked(parts, 1, False, author="Ann", reason="unsure")
    samples = samples_of([label], parts, FPS, "yard")
    states = part_states(parts, FPS).states
    assert np.allclose(
        samples.features[0], part_features(states[FRAME], states[FRAME - 10]), equal_nan=True
    )
    row = tuple(samples.columns[name][0] for name in SAMPLE_COLUMNS)
    assert row == ("yard", TRACK, FRAME, 1, 0, "Ann", "unsure", "label")


def test_unsure_ones_are_dropped(parts) -> None:
    assert len(samples_of([tracked(parts, 1, None)], parts, FPS, "yard")) == 0


def test_a_rectangle_put_right_teaches_where_it_was_and_where_it_is(parts) -> None:
    before = tracked(parts, 0)
    left, top, width, height = before.box
    drawn = replace(before, box=(left + 3 * width, top, width, height), source="person")
    samples = samples_of([drawn], parts, FPS, "yard")
    assert said(samples) == [(0, 0, "correction"), (0, 1, "correction")]
    states = part_states(parts, FPS).states
    assert np.allclose(
        samples.features[0], part_features(states[FRAME], states[FRAME - 10]), equal_nan=True
    )
    assert samples.features[1][0] == pytest.approx(samples.features[0][0] + 2 * width)


def test_a_rectangle_moved_a_little_was_right_before(parts) -> None:
    before = tracked(parts, 0)
    left, top, width, height = before.box
    drawn = replace(before, box=(left + 0.3 * width, top, width, height), source="person")
    assert said(samples_of([drawn], parts, FPS, "yard")) == [(0, 1, "correction")]


def test_a_part_put_right_goes_with_the_other_two(parts) -> None:
    before = tracked(parts, 0)
    left, top, width, height = before.box
    drawn = replace(before, box=(left + 3 * width, top, width, height), source="person")
    mended = samples_of([drawn], parts, FPS, "yard").features[1]
    others = part_states(parts, FPS).states[FRAME, 1:, 4:].mean(axis=0)
    mean = others  # of all three, as the mended one moves with the mean of the others
    assert np.allclose(mended[4:6], others - mean)


def test_the_past_of_a_part_put_right_is_put_right_too(parts) -> None:
    labels = []
    for frame in (FRAME - 10, FRAME):
        state = part_states(parts, FPS).states[frame, 0]
        left, top, width, height = box_of(state)
        box = (left + 3 * width, top, width, height)
        labels.append(PartLabel(frame, TRACK, 0, box, True, "person"))
    samples = samples_of(labels, parts, FPS, "yard")
    now = samples[(samples.columns["frame"] == FRAME)]
    lost, mended = now.features
    assert abs(mended[18]) < 15  # head_x_change: it moved no more than people do in half a second
    assert lost[18] == pytest.approx(mended[18], abs=15)


def test_labels_of_people_without_tracked_parts_give_no_sample(parts) -> None:
    elsewhere = replace(tracked(parts, 1), frame=700)
    other = replace(tracked(parts, 1), track=9)
    assert len(samples_of([elsewhere, other], parts, FPS, "yard")) == 0


def test_truth_is_named_as_the_source(parts) -> None:
    samples = samples_of([replace(tracked(parts, 2), source="truth")], parts, FPS, "yard")
    assert said(samples) == [(2, 1, "truth")]


def test_samples_join_and_keep_their_types() -> None:
    one, other = made_up_samples(1, 1), made_up_samples(2, 1, recording="hall")
    both = joined([one, no_samples(), other])
    assert len(both) == len(one) + len(other)
    types = {name: column.dtype for name, column in both.columns.items()}
    assert types == {**SAMPLE_COLUMNS, **{name: one.dtype for name, one in BESIDES.items()}}
    assert both.people().tolist() == [1] * len(one) + [0] * len(other)
    assert both.counts().sum() == len(both)
