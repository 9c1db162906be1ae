"""What to label next: least sure first, spread over people and time."""

from __future__ import annotations

import numpy as np
import pytest
from made_up_parts import FPS, as_parts, made_up_samples, walk

from tracking.failure import Detector, TrainingPlan, part_states, suggest, train
from tracking.failure.suggesting import scores_of
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


def test_the_least_sure_of_all_comes_first(detector: Detector, parts) -> None:
    first = suggest(parts, FPS, detector, ())[0]
    seen = part_states(parts, FPS)
    spreads = [np.concatenate((c.on, c.off)).std() for c in detector.curves[:3]]
    unsure = np.abs(scores_of(seen, FPS, detector)) / spreads
    row, part = np.unravel_index(unsure.argmin(), unsure.shape)
    assert first.key == (seen.frame[row], seen.track[row], part)
    assert f"{first.score:+.2f}" in first.reason


def test_no_two_of_a_person_are_neighbours_and_everybody_has_a_turn(
    detector: Detector, parts
) -> None:
    found = suggest(parts, FPS, detector, (), most=12)
    assert len(found) == 12
    for one in found:
        near = [o for o in found if o.track == one.track and abs(o.frame - one.frame) < FPS / 2]
        assert near == [one]
    assert {one.track for one in found[:6]} == {1, 2, 5}


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
