"""What boxes say to the trackers: whose they are, and where people stand."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.trackers.people_on_a_floor import view
from tracking.geometry import (
    Camera,
    FlatView,
    Ground,
    Rectification,
    StereoCalibration,
    standing_ellipses,
)
from tracking.people import Detections
from tracking.people.stereo_boxes import rectified_boxes, right_search_boxes
from tracking.trackers.spheroid.box_cues import box_log_weights, flat_boxes
from tracking.trackers.three_part.claims import Claims, associate_detections

BOX = np.array(((10.0, 10.0, 20.0, 60.0), (100.0, 10.0, 20.0, 60.0)))


def _seen(from_detector: list[bool]) -> Detections:
    none = Detections.none((100, 200))
    return replace(none, box=BOX, from_detector=np.array(from_detector), merged=np.zeros(2, bool))


def _claims(share: list[list[float]], region: list[int]) -> Claims:
    people = len(region)
    return Claims(np.array(share), np.ones((people, 3)), np.array(region), np.ones(people, bool))


def test_a_box_is_one_person_s_whoever_else_has_parts_in_it() -> None:
    expected = np.array(((12.0, 10.0, 20.0, 60.0), (14.0, 30.0, 20.0, 60.0)))
    claims = associate_detections(
        _claims([[0.9, 0], [0.8, 0]], [0, 0]), expected, _seen([True, True])
    )
    assert claims.region.tolist() == [0, -1]
    assert claims.alone.tolist() == [True, False]
    assert claims.is_taken.tolist() == [True, False]
    assert claims.support.max(axis=1).tolist() == [1.0, 0.0]


def test_regions_of_the_foreground_are_claimed_as_ever() -> None:
    expected = np.array(((12.0, 10.0, 20.0, 60.0), (101.0, 10.0, 20.0, 60.0)))
    before = _claims([[0.9, 0], [0, 0.8]], [0, 1])
    claims = associate_detections(before, expected, _seen([True, False]))
    assert claims.region.tolist() == [0, 1]
    assert claims.share[1].tolist() == [0.0, 0.8]
    assert claims.support.min() == 1.0


def test_a_hypothesis_that_fills_its_box_is_the_likeliest() -> None:
    flat = FlatView(view())
    places = np.array([[0.0, 5.0], [0.0, 6.0], [0.0, 7.0], [0.8, 6.0]])
    seen = standing_ellipses(flat.projection, places[None], np.full((1, 4), 1.7), 0.25)
    own = standing_ellipses(flat.projection, places[1:2], np.array([1.7]), 0.25)
    (left, right), (top, bottom) = own.columns(), own.rows()
    box = np.column_stack((left, top, right - left, bottom - top))
    gains = box_log_weights(seen, own, flat_boxes(box, flat))
    assert gains[0].argmax() == 1
    assert gains[0, 1] > -0.1
    assert (gains[0, [0, 2, 3]] < -1.0).all()
    assert not box_log_weights(seen, own, box + np.array((500.0, 0, 0, 0))).any()
    assert not box_log_weights(seen, own, np.zeros((0, 4))).any()


def test_a_box_of_the_left_camera_holds_its_person_in_the_right_one() -> None:
    rectification = _rectification()
    ends = np.array(((0.2, 5.0, 0.0), (0.2, 5.0, 1.7)))
    left, right = rectification.rectified_from_world(ends), _right_of(rectification, ends)
    box = np.array([[left[1, 0] - 9.0, left[1, 1], 18.0, left[0, 1] - left[1, 1]]])
    wide = right_search_boxes(box, rectification)[0]
    assert wide[0] < right[:, 0].min() < right[:, 0].max() < wide[0] + wide[2]


def test_boxes_are_rectified_in_the_camera_they_are_of() -> None:
    rectification = _rectification()
    level = np.array([[100.0, 80.0, 40.0, 100.0]])
    corners = np.array([[100.0, 130.0], [140.0, 130.0], [120.0, 80.0], [120.0, 180.0]])
    for right, back in (
        (False, rectification.recorded_from_rectified),
        (True, rectification.right_recorded_from_rectified),
    ):
        sides = back(corners)
        low = np.array((sides[0, 0], sides[2, 1]))
        size = np.array((sides[1, 0], sides[3, 1])) - low
        found = rectified_boxes(np.concatenate((low, size))[None], rectification, right=right)
        assert np.abs(found - level).max() < 1.0


def _rectification() -> Rectification:
    lens = np.array([[400.0, 0.0, 160.0], [0.0, 400.0, 120.0], [0.0, 0.0, 1.0]])
    left, right = (
        Camera(lens, np.array((bent, 0.02, 0.0, 0.0)), 320, 240) for bent in (-0.1, -0.08)
    )
    turned = cv2.Rodrigues(np.array([0.01, -0.02, 0.015]))[0]
    rig = StereoCalibration(left, right, turned, np.array([-0.3, 0.01, 0.0]))
    return Rectification(rig, Ground(2.4, 25.0))


def _right_of(rectification: Rectification, points: NDArray[np.float64]) -> NDArray[np.float64]:
    shift = rectification.disparity_from_world(points)
    return rectification.rectified_from_world(points) - np.column_stack((shift, np.zeros(2)))
