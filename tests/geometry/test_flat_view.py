"""Pictures without the lens's distortion."""

import cv2
import numpy as np
import pytest

from tracking.geometry import Camera, FlatView, Ground, View

BARREL = (-0.25, 0.06, 0.001, -0.0005, 0.0)


def _view(distortion: tuple[float, ...], tilt: float = 40.0) -> View:
    matrix = np.array([[500.0, 0.0, 319.5], [0.0, 505.0, 239.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.array(distortion), 640, 480), Ground(3.0, tilt, 5.0))


@pytest.mark.parametrize("distortion", [(), BARREL])
@pytest.mark.parametrize("shrink", [1, 2])
def test_flat_and_recorded_pixels_are_carried_into_each_other(
    distortion: tuple[float, ...], shrink: int
) -> None:
    flat = FlatView(_view(distortion), shrink)
    recorded = np.random.default_rng(1).uniform((0, 0), (639, 479), (200, 2))
    there = flat.flat_from_recorded(recorded)
    assert np.allclose(flat.recorded_from_flat(there), recorded, atol=1e-6)


@pytest.mark.parametrize("distortion", [(), BARREL])
@pytest.mark.parametrize("shrink", [1, 2])
def test_world_points_are_projected_as_the_view_does(
    distortion: tuple[float, ...], shrink: int
) -> None:
    view = _view(distortion)
    flat = FlatView(view, shrink)
    points = np.random.default_rng(2).uniform((-1, 2, 0), (1, 5, 1.8), (50, 3))
    by_flat = flat.recorded_from_flat(flat.flat_from_world(points))
    assert np.allclose(by_flat, view.pixel_from_world(points), atol=1e-6)


def test_a_straight_edge_of_the_world_is_straight_in_the_flat_picture() -> None:
    view = _view(BARREL)
    flat = FlatView(view)
    recorded = np.zeros((480, 640), np.uint8)
    ends = np.array([[-1.6, 3.0, 0.0], [1.6, 3.4, 0.0]])
    along = np.linspace(0, 1, 200)[:, None]
    line = view.pixel_from_world(ends[0] + along * (ends[1] - ends[0]))
    cv2.polylines(recorded, [np.rint(line).astype(np.int32)], False, 255, 1)
    seen = flat.flatten(recorded)
    v, u = np.nonzero(seen > 120)
    slope, start = np.polyfit(u, v, 1)
    assert np.abs(v - slope * u - start).max() < 1.6
    assert seen.shape == flat.size[::-1]


def test_a_plain_lens_leaves_pictures_as_they_are() -> None:
    flat = FlatView(_view(()))
    picture = np.arange(480 * 640, dtype=np.uint8).reshape(480, 640)
    assert flat.flatten(picture) is picture
    assert flat.covered.all()


def test_the_flat_picture_holds_the_recorded_one_and_says_what_it_does_not_cover() -> None:
    flat = FlatView(_view(BARREL))
    corners = np.array([[0, 0], [639, 0], [639, 479], [0, 479]], float)
    there = flat.flat_from_recorded(corners)
    assert (there > -1).all()
    assert (there < np.array(flat.size)).all()
    assert 0.85 < flat.covered.mean() < 1.0
