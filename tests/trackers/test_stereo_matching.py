from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from people_on_a_floor import BINS

from tracking.trackers.stereo.association import associate_people
from tracking.trackers.stereo.cues import Costs, costs_of, gate_people
from tracking.trackers.stereo.direction import MiddleUpdated, StereoDirectionSettings
from tracking.trackers.stereo.population import Population, empty_population

PLAIN = StereoDirectionSettings(colour_weight=0.0, association_margin=0.0)


def two_people(came_from: list[list[float]], at: list[list[float]], missed_s: float) -> Population:
    """Two people in the same clothes who walked from one place to another."""
    start, end = np.array(came_from), np.array(at)
    anchors = np.stack((start, (start + end) / 2), axis=1)
    empty = empty_population(10, 1, BINS)
    names = [field.name for field in dataclasses.fields(empty)]
    zeros = {name: np.zeros((2, *getattr(empty, name).shape[1:])) for name in names}
    return Population(**zeros).replace(
        track=np.array([1, 2], np.int32),
        position=end,
        anchors=anchors,
        missed_s=np.full(2, missed_s),
        colour=np.full((2, 1, BINS), 1.0 / BINS, np.float32),
    )


def costs_at(
    people: Population, measured: np.ndarray, settings: StereoDirectionSettings, shown: np.ndarray
) -> Costs:
    """The costs of people and of detections in one colour."""
    colours = np.full((len(measured), 1, BINS), 1.0 / BINS, np.float32)
    gated, cues = gate_people(people, measured, settings), MiddleUpdated(settings)
    return costs_of(people, gated, measured, colours, cues, settings, shown)


def matched(
    people: Population, measured: np.ndarray, settings: StereoDirectionSettings
) -> list[int]:
    costs = costs_at(people, measured, settings, np.ones(len(people)))
    pairs = associate_people(people, costs, np.ones(len(measured), bool), settings)
    found = np.full(len(people), -1)
    found[pairs.track] = pairs.detection
    return found.tolist()


CROSSED = two_people([[-1.0, 5.0], [-1.0, 6.0]], [[0.0, 5.5], [0.0, 5.5]], missed_s=0.3)
"""One walked away from the camera, the other towards it; both are expected where they meet."""
AFTER = np.array([[0.22, 5.40], [0.22, 5.62]])
"""Then the first comes out on the far side, the second on the near one."""


def test_people_in_one_colour_who_cross_keep_their_ids_with_the_walking_direction():
    assert matched(CROSSED, AFTER, PLAIN) == [1, 0]


def test_with_distance_only_they_are_taken_for_each_other():
    a_little_off = CROSSED.replace(position=np.array([[0.0, 5.48], [0.0, 5.54]]))
    blind = dataclasses.replace(PLAIN, direction_weight=0.0)
    assert matched(a_little_off, AFTER, blind) == [0, 1]
    assert matched(a_little_off, AFTER, PLAIN) == [1, 0]


def test_a_detection_that_suits_two_people_alike_is_nobodys():
    between = np.array([[0.1, 5.5]])
    careful = dataclasses.replace(PLAIN, association_margin=0.2)
    assert matched(CROSSED, between, careful) == [-1, -1]


def test_a_merged_region_is_nobodys():
    costs = costs_at(CROSSED, AFTER, PLAIN, np.ones(2))
    pairs = associate_people(CROSSED, costs, np.array([False, False]), PLAIN)
    assert len(pairs.track) == 0


@pytest.mark.parametrize(("missed_s", "found"), [(0.0, [-1, -1]), (2.0, [-1, 0])])
def test_somebody_missed_for_long_is_looked_for_in_a_wider_circle(missed_s, found):
    apart = two_people([[-4.0, 6.0], [0.0, 6.0]], [[-4.0, 5.0], [0.0, 5.0]], missed_s)
    assert matched(apart, np.array([[0.5, 3.7]]), PLAIN) == found


def test_who_is_expected_to_be_hidden_leaves_a_detection_to_who_stands_in_front():
    seen = np.array([[0.0, 5.5]])
    people = CROSSED.replace(position=np.array([[0.1, 5.5], [0.0, 5.52]]))
    costs = costs_at(people, seen, PLAIN, np.array([1.0, 0.1]))
    assert associate_people(people, costs, np.ones(1, bool), PLAIN).track.tolist() == [0]


BEHIND = CROSSED.replace(
    position=np.array([[0.0, 5.0], [0.0, 5.6]]), missed_s=np.array([0.05, 1.0])
)
"""The first was seen a moment ago, the second is missed for long."""


def test_a_present_person_leaves_what_suits_somebody_missed_better():
    assert matched(BEHIND, np.array([[0.0, 5.5]]), PLAIN) == [-1, 0]


def test_somebody_seen_a_moment_ago_takes_what_suits_them_better_than_somebody_missed():
    assert matched(BEHIND, np.array([[0.0, 5.05]]), PLAIN) == [0, -1]
