"""People in dull clothes at the edges of the picture, where nothing can be ranged."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.people import Detections, PeopleSettings
from tracking.people.finder import PeopleFinder
from tracking.stereo import STEP, SightLines

SIZE, FOCAL_PX, BASELINE_M, AWAY_M, EYE_M = (320, 240), 300.0, 0.2, 2.5, 0.6
LIKE_SHADOW = 254
UNRANGED_PX = 8
"""So near to the edges the window of block matching ends outside the picture."""


def found(rows: slice, columns: slice) -> Detections:
    """Those seen where all that moves looks a little like shadow."""
    matrix = np.array([[FOCAL_PX, 0, SIZE[0] / 2], [0, FOCAL_PX, SIZE[1] / 2], [0, 0, 1.0]])
    camera = Camera(matrix, np.zeros(5), *SIZE)
    rig = StereoCalibration(camera, camera, np.eye(3), np.array([-BASELINE_M, 0, 0]))
    ground = Ground(EYE_M, 0.0)
    rectification = Rectification(rig, ground)
    people = PeopleFinder(rectification, ground, SightLines(rectification, 1), PeopleSettings())
    body = np.zeros(SIZE[::-1], np.uint8)
    body[rows, columns] = LIKE_SHADOW
    ranged = np.zeros(body.shape, bool)
    ranged[UNRANGED_PX:-UNRANGED_PX, UNRANGED_PX:-UNRANGED_PX] = True
    away = np.where(ranged & (body > 0), FOCAL_PX * BASELINE_M / AWAY_M, np.nan)
    disparity = away[::STEP, ::STEP].astype(np.float32)
    picture = np.full((*SIZE[::-1], 3), 90, np.uint8)
    return people.find(people.points(disparity), body[::STEP, ::STEP], picture)


def test_somebody_whose_head_is_above_the_picture_goes_on_there() -> None:
    people = found(np.s_[:192], np.s_[130:190])
    assert len(people) == 1
    left, top, width, height = people.box[0]
    assert people.truncated[0]
    # The camera is 0.6 m over the floor, and 120 px are a metre here.
    assert top == pytest.approx(120 - (1.75 - EYE_M) * 120, abs=8)
    assert top + height == pytest.approx(192, abs=8)
    assert (left, width) == pytest.approx((130, 60), abs=8)


@pytest.mark.parametrize(("columns", "middle_px"), [(np.s_[:35], 5), (np.s_[-35:], 315)])
def test_somebody_half_beside_the_picture_goes_on_there(columns: slice, middle_px: float) -> None:
    people = found(np.s_[40:192], columns)
    assert len(people) == 1
    assert people.truncated[0]
    left, _, width, _ = people.box[0]
    assert left + width / 2 == pytest.approx(middle_px, abs=10)
    assert width == pytest.approx(60, abs=12)


def test_somebody_close_to_the_edge_and_whole_stays_whole() -> None:
    people = found(np.s_[20:192], np.s_[130:190])
    assert len(people) == 1
    assert not people.truncated[0]
    assert people.box[0, 1] == pytest.approx(20, abs=2)
