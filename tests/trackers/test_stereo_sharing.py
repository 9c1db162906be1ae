from __future__ import annotations

import dataclasses

import numpy as np
from people_on_a_floor import Errors, detections, view

from tracking.filtering import Association
from tracking.people import Detections
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.direction import StereoDirectionSettings
from tracking.trackers.stereo.initiation import initiate_tracks
from tracking.trackers.stereo.population import Population, empty_population
from tracking.trackers.stereo.shared_detections import SharedRegions, find_shared_regions
from tracking.trackers.stereo.stage_values import MeasuredFrame

SIDE_BY_SIDE = np.array([[-0.25, 6.0], [0.25, 6.0]])


def seen_at(xy: np.ndarray) -> Detections:
    random = np.random.default_rng(0)
    return detections(xy, np.zeros(len(xy), int), np.zeros(len(xy), bool), random, Errors())


def followed(xy: np.ndarray) -> Population:
    seen = seen_at(xy)
    frame, free = MeasuredFrame(seen, seen.middle[:, None], 0.05), np.arange(len(xy))
    settings, random = StereoDirectionSettings(particles=20), np.random.default_rng(0)
    people = initiate_tracks(empty_population(20, 1, 16), frame, free, settings, random, view())
    return people.replace(track=np.arange(1, len(xy) + 1, dtype=np.int32))


def around(seen: Detections) -> Detections:
    """One detection whose box holds those of all."""
    low = seen.box[:, :2].min(axis=0)
    high = (seen.box[:, :2] + seen.box[:, 2:]).max(axis=0)
    one = seen_at(seen.position[:, :2].mean(axis=0, keepdims=True))
    return dataclasses.replace(one, box=np.concatenate((low, high - low))[None])


def shared(people: Population, seen: Detections, owner: int) -> SharedRegions:
    pairs = Association(np.array([owner]), np.array([0]), np.array([np.nan]))
    return find_shared_regions(people, Bodies.at(people.position, view()), pairs, seen, view())


def test_two_people_in_one_region_stay_on_their_sides_of_it():
    moved = SIDE_BY_SIDE + np.array([[0.15, 0.0], [0.05, 0.0]])
    found = shared(followed(moved), around(seen_at(SIDE_BY_SIDE)), owner=0)
    assert (found.owner.tolist(), found.occluded.tolist()) == ([0], [1])
    np.testing.assert_allclose(found.owner_at, SIDE_BY_SIDE[:1], atol=0.06)
    np.testing.assert_allclose(found.occluded_at, SIDE_BY_SIDE[1:], atol=0.06)


def test_a_region_as_wide_as_one_person_is_nobody_elses():
    found = shared(followed(SIDE_BY_SIDE), seen_at(SIDE_BY_SIDE[:1]), owner=0)
    assert len(found.occluded) == 0


def test_somebody_expected_elsewhere_is_no_part_of_a_wide_region():
    people = followed(np.array([[-0.25, 6.0], [3.0, 6.0]]))
    found = shared(people, around(seen_at(SIDE_BY_SIDE)), owner=0)
    assert len(found.occluded) == 0


def test_somebody_matched_with_a_region_of_its_own_is_not_occluded():
    seen = around(seen_at(SIDE_BY_SIDE))
    both = seen_at(SIDE_BY_SIDE)
    two = dataclasses.replace(both, box=np.concatenate((seen.box, both.box[1:])))
    pairs = Association(np.array([0, 1]), np.array([0, 1]), np.full(2, np.nan))
    people = followed(SIDE_BY_SIDE)
    bodies = Bodies.at(people.position, view())
    assert len(find_shared_regions(people, bodies, pairs, two, view()).occluded) == 0
