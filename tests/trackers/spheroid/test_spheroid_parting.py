"""Two people who are followed as one, seen from above."""

from __future__ import annotations

import numpy as np
import pytest
from people_of_one_colour import Body, followed, frames_of, places, standing, view

from tracking.geometry import FlatView, standing_ellipses
from tracking.trackers.spheroid import SpheroidSettings
from tracking.trackers.spheroid.hypotheses import begin_people
from tracking.trackers.spheroid.hypothesis_scores import JudgedFrame, count_covering
from tracking.trackers.spheroid.split_merged import split_merged, two_places
from tracking.trackers.spheroid.weights import silhouettes

FLAT = FlatView(view())
SETTINGS = SpheroidSettings()
ONE, OTHER = np.array([0.3, 0.5]), np.array([0.9, 0.9])
BETWEEN = (ONE + OTHER) / 2


def _ramp(*xy: np.ndarray) -> np.ndarray:
    outlines = standing_ellipses(FLAT.projection, np.array(xy), np.full(len(xy), 1.72), 0.22)
    return np.where(count_covering(FLAT.size[::-1], outlines) > 0, np.uint8(255), np.uint8(0))


def _seen(ramp: np.ndarray, *xy: np.ndarray):
    mean = np.array([(*place, 0.4, 0.2) for place in xy])
    people = begin_people(
        np.arange(1, len(xy) + 1, dtype=np.int32),
        mean,
        np.full(len(xy), 1.72),
        0.0,
        50,
        (0.05, 0.0),
        np.random.default_rng(2),
    )
    cover = count_covering(ramp.shape, silhouettes(people, FLAT, SETTINGS))
    return people, JudgedFrame(ramp, np.ones(ramp.shape, bool), cover)


def test_two_places_are_found_about_who_stands_between_two() -> None:
    free = np.ones(FLAT.size[::-1], bool)
    found = two_places(_ramp(ONE, OTHER), free, FLAT, BETWEEN, 1.72, 0.25)
    assert found is not None
    by_x = found[np.argsort(found[:, 0])]
    assert np.abs(by_x - (ONE, OTHER)).max() < 0.2
    assert np.diff(np.hypot(*(found - BETWEEN).T))[0] >= 0.0


@pytest.mark.parametrize("off_m", [0.0, 0.15])
def test_one_person_is_not_taken_for_two(off_m: float) -> None:
    free = np.ones(FLAT.size[::-1], bool)
    assert two_places(_ramp(ONE), free, FLAT, ONE + off_m, 1.72, 0.25) is None


def test_who_is_between_two_is_put_to_one_of_them_and_the_other_is_told() -> None:
    people, judged = _seen(_ramp(ONE, OTHER), BETWEEN)
    moved, others = split_merged(people, np.array([0]), judged, FLAT, 1.77, SETTINGS)
    stands = np.array([moved.xy[0], others[0, :2]])
    assert np.abs(stands[np.argsort(stands[:, 0])] - (ONE, OTHER)).max() < 0.2
    assert np.allclose(others[0, 2:], (0.4, 0.2))
    assert np.allclose(moved.state - people.state, moved.mean - people.mean, atol=1e-6)


def test_nobody_is_parted_from_somebody_who_is_followed_already() -> None:
    people, judged = _seen(_ramp(ONE, OTHER), ONE, OTHER)
    moved, others = split_merged(people, np.array([0, 1]), judged, FLAT, 1.77, SETTINGS)
    assert np.array_equal(moved.mean, people.mean)
    assert others.shape == (0, 4)


def test_two_who_stand_close_together_from_the_start_are_two_tracks() -> None:
    seen_by = view()
    pair = [Body(standing((0.35, 0.55), 25)), Body(standing((0.8, 0.85), 25))]
    last = followed(seen_by, frames_of(seen_by, pair))[-1]
    found = places(last)
    assert len(found) == 2
    assert np.abs(np.sort(found[:, 0]) - (0.35, 0.8)).max() < 0.12
