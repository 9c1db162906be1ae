"""What to label next: least sure first, spread over people and time."""

from __future__ import annotations

import numpy as np
import pytest
from made_up_parts import FPS, as_parts, made_up_samples, walk

from tracking.failure import Detector, TrainingPlan, part_states, suggest, train
from tracking.failure.label_suggestions import scores_of
from tracking.failure.training import Candidate


@pytest.fixture(scope="module")
def detector() -> Detector:
    plan = TrainingPlan(grid=(Candidate(1.0, 1.0),), folds=2, searched=200)
    return train(made_up_samples(3, people=6), plan, random=np.random.default_rng(1)).detector


@pytest.fixture(scope="module")
def parts() -> dict[str, np.ndarray]:
    random = np.random.default_rng(8)
    each = [as_parts(walk(random, 100)[0], track) for track in (1, 2, 5)]
    return {name: np.concatenate([one[name] for one in each]) for name in each[0]}


def test_the_least_sure_of_each_part_come_first(detector: Detector, parts) -> None:
    first = suggest(parts, FPS, detector, ())[:3]
    seen = part_states(parts, FPS)
    rows = np.abs(scores_of(seen, FPS, detector)).argmin(axis=0)
    assert [one.key for one in first] == [
        (seen.frame[row], seen.track[row], part) for part, row in enumerate(rows)
    ]
    held = scores_of(seen, FPS, detector)
    assert [one.score for one in first] == [held[row, part] for part, row in enumerate(rows)]


def test_parts_take_turns_however_much_surer_one_of_them_is(detector: Detector, parts) -> None:
    found = suggest(parts, FPS, detector, (), most=12)
    assert [one.part for one in found] == [0, 1, 2] * 4


def test_no_two_of_a_part_are_neighbours_and_everybody_has_a_turn(
    detector: Detector, parts
) -> None:
    found = suggest(parts, FPS, detector, (), most=18)
    assert len(found) == 18
    for one in found:
        alike = [o for o in found if (o.track, o.part) == (one.track, one.part)]
        assert [o for o in alike if abs(o.frame - one.frame) < FPS / 2] == [one]
    assert {one.track for one in found[:9]} == {1, 2, 5}


def test_what_is_labelled_is_left_out(detector: Detector, parts) -> None:
    before = suggest(parts, FPS, detector, ())
    after = suggest(parts, FPS, detector, {before[0].key})
    assert before[0].key not in {one.key for one in after}


def test_occluded_people_are_left_out(detector: Detector, parts) -> None:
    hidden = {**parts, "occluded": parts["track"] == 2}
    assert {one.track for one in suggest(hidden, FPS, detector, ())} == {1, 5}


def test_nobody_gives_no_suggestions(detector: Detector, parts) -> None:
    nobody = {name: column[:0] for name, column in parts.items()}
    assert suggest(nobody, FPS, detector, ()) == []
