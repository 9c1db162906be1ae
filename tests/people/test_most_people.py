"""However many heads are told apart, no more people come out than labels can tell."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.people import Detections, PeopleSettings, finder
from tracking.people.finder import PeopleFinder
from tracking.stereo import STEP, SightLines

Floats = NDArray[np.float32]
SIZE, FOCAL_PX, AWAY_M = (320, 240), 300.0, 4.0


def found(monkeypatch: pytest.MonkeyPatch, heads: int) -> Detections:
    """One person before the camera, over whom so many heads are told."""
    matrix = np.array([[FOCAL_PX, 0, 160], [0, FOCAL_PX, 120], [0, 0, 1.0]])
    camera = Camera(matrix, np.zeros(5), *SIZE)
    rig = StereoCalibration(camera, camera, np.eye(3), np.array([-0.2, 0, 0]))
    ground = Ground(1.5, 0.0)
    rectification = Rectification(rig, ground)
    people = PeopleFinder(rectification, ground, SightLines(rectification, 1), PeopleSettings())
    disparity = np.full((SIZE[1] // STEP, SIZE[0] // STEP), np.nan, np.float32)
    body = np.zeros(SIZE[::-1], np.uint8)
    body[102:230, 140:180] = 255
    disparity[102 // STEP : 230 // STEP, 140 // STEP : 180 // STEP] = FOCAL_PX * 0.2 / AWAY_M

    def told(places: Floats, *_: object) -> Floats:
        across = np.linspace(-0.2, 0.2, heads, dtype=np.float32)
        return np.stack((across, np.full(heads, AWAY_M, np.float32)), axis=1)

    monkeypatch.setattr(finder, "split_by_heads", told)
    picture = np.full((*SIZE[::-1], 3), 90, np.uint8)
    return people.find(people.points(disparity), body[::STEP, ::STEP], picture)


def test_more_heads_than_labels_are_not_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    one, two, many = (found(monkeypatch, heads) for heads in (1, 2, 256))
    assert (len(one), len(two), len(many)) == (1, 2, 1)
    np.testing.assert_array_equal(many.position, one.position)
