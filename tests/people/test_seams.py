"""Strips along people's outlines that were given to somebody else."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.plan_view import SurfacePoints
from tracking.people.runs import Runs
from tracking.people.seams import without_seams

SHAPE = (40, 60)
Labels = NDArray[np.uint8]


def mended(labels: Labels) -> Labels:
    """The labels after strips went back to whom they are."""
    pixel = np.flatnonzero(labels)
    none = np.zeros(len(pixel), np.float32)
    points = SurfacePoints(pixel, np.zeros((len(pixel), 3), np.float32), none, none, none)
    found = np.zeros_like(labels)
    owner = labels.ravel()[pixel].astype(np.intp) - 1
    found.ravel()[pixel] = without_seams(owner, points, SHAPE) + 1
    return found


def two_beside_each_other() -> Labels:
    """Two people with the background between them."""
    labels = np.zeros(SHAPE, np.uint8)
    labels[5:35, 10:20] = 1
    labels[5:35, 24:34] = 2
    return labels


def test_a_strip_of_ones_outline_given_to_who_stands_beyond_goes_back() -> None:
    truth = two_beside_each_other()
    seen = truth.copy()
    seen[8:30, 18:20] = 2
    np.testing.assert_array_equal(mended(seen), truth)


def test_a_wide_part_cut_off_from_the_rest_goes_back_too() -> None:
    truth = two_beside_each_other()
    seen = truth.copy()
    seen[8:14, 15:20] = 2
    np.testing.assert_array_equal(mended(seen), truth)


def test_people_apart_and_people_behind_each_other_stay_as_they_are() -> None:
    apart = two_beside_each_other()
    np.testing.assert_array_equal(mended(apart), apart)
    behind = np.zeros(SHAPE, np.uint8)
    behind[5:30, 10:30] = 2
    behind[8:38, 14:24] = 1
    np.testing.assert_array_equal(mended(behind), behind)


def test_an_arm_in_the_open_is_no_strip() -> None:
    labels = two_beside_each_other()
    labels[10:12, 34:45] = 2
    labels[2:5, 28] = 2
    np.testing.assert_array_equal(mended(labels), labels)


def test_a_grid_without_points_has_no_strips() -> None:
    assert not mended(np.zeros(SHAPE, np.uint8)).any()


def test_runs_end_with_their_row_and_know_who_is_beside_them() -> None:
    runs = Runs.along(np.array([[1, 1, 0, 2], [2, 2, 2, 2]], np.uint8))
    assert runs.label.tolist() == [1, 0, 2, 2]
    assert runs.length.tolist() == [2, 1, 1, 4]
    assert runs.row.tolist() == [0, 0, 0, 1]
    left, right = runs.beside()
    assert left.tolist() == [0, 0, 1, 3]
    assert right.tolist() == [1, 2, 2, 3]
