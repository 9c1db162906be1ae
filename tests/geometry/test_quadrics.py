"""Ellipsoids on the floor, against a dense sampling of their surfaces."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.geometry import Camera, FlatView, Ground, View, standing_ellipses

TILTS = st.floats(3.0, 90.0)


def _view(height_m: float, tilt: float, roll: float = 0.0, distortion: tuple = ()) -> View:
    matrix = np.array([[520.0, 0.0, 319.5], [0.0, 510.0, 239.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.array(distortion), 640, 480), Ground(height_m, tilt, roll))


def _surface(xy: np.ndarray, height_m: float, radius_m: float) -> np.ndarray:
    """(n, 3) points all over a spheroid."""
    around = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    up = np.linspace(0, np.pi, 721)
    sin, cos = np.sin(up)[:, None], np.cos(up)[:, None]
    x = xy[0] + radius_m * sin * np.cos(around)
    y = xy[1] + radius_m * sin * np.sin(around)
    z = np.broadcast_to(height_m / 2 * (1 - cos), x.shape)
    return np.stack((x, y, z), axis=-1).reshape(-1, 3)


@settings(max_examples=60, deadline=None)
@given(
    tilt=TILTS,
    roll=st.floats(-20, 20),
    camera_m=st.floats(1.9, 8.0),
    body_m=st.floats(1.0, 1.85),
    ahead_m=st.floats(0.0, 25.0),
    aside_m=st.floats(-6.0, 6.0),
)
def test_the_outline_is_that_of_a_dense_sampling_within_half_a_pixel(
    tilt: float, roll: float, camera_m: float, body_m: float, ahead_m: float, aside_m: float
) -> None:
    flat = FlatView(_view(camera_m, tilt, roll))
    xy = np.array([aside_m, ahead_m])
    found = standing_ellipses(flat.projection, xy[None], np.array([body_m]), 0.25)
    points = _surface(xy, body_m, 0.25)
    depth = points @ flat.projection[2, :3] + flat.projection[2, 3]
    if depth.min() < 0.6:
        assert np.isnan(found.u[0]) or depth.min() > 0
        return
    pixels = flat.flat_from_world(points)
    top, bottom = found.rows()
    left, right = found.columns()
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    assert np.allclose((left[0], top[0]), low, atol=0.5)
    assert np.allclose((right[0], bottom[0]), high, atol=0.5)
    _assert_lines_agree(found, pixels)


def _assert_lines_agree(found, pixels: np.ndarray) -> None:  # type: ignore[no-untyped-def]
    """No sampled point lies outside of its line's ends, and the support in all directions fits."""
    start, stop = found.ends(pixels[None, :, 1])
    known = np.isfinite(start[0])
    assert (pixels[known, 0] >= start[0][known] - 0.5).all()
    assert (pixels[known, 0] <= stop[0][known] + 0.5).all()
    outline = found.polygons(720)[0]
    for angle in np.linspace(0, np.pi, 16, endpoint=False):
        along = np.array((np.cos(angle), np.sin(angle)))
        assert abs((pixels @ along).max() - (outline @ along).max()) < 0.5
        assert abs((pixels @ along).min() - (outline @ along).min()) < 0.5


def test_who_is_behind_or_around_the_camera_has_no_outline() -> None:
    flat = FlatView(_view(2.5, 20.0))
    places = np.array([[0.0, -3.0], [0.0, -0.2], [0.0, 5.0]])
    found = standing_ellipses(flat.projection, places, np.full(3, 1.8), 0.25)
    assert np.isnan(found.u[:2]).all()
    assert np.isfinite(found.u[2])
    inside = standing_ellipses(FlatView(_view(1.0, 0.0)).projection, places[1:2], [1.8], 0.25)
    assert np.isnan(inside.vv).all()


def test_ends_of_a_line_lie_on_the_outline() -> None:
    flat = FlatView(_view(3.0, 35.0, 10.0))
    found = standing_ellipses(flat.projection, np.array([[0.4, 4.0]]), np.array([1.7]), 0.25)
    top, bottom = found.rows()
    lines = np.linspace(top + 1e-6, bottom - 1e-6, 9).T
    start, stop = found.ends(lines)
    for u in (start, stop):
        du, dv = u - found.u[:, None], lines - found.v[:, None]
        det = found.uu * found.vv - found.uv**2
        measure = (found.vv * du**2 - 2 * found.uv * du * dv + found.uu * dv**2) / det
        assert np.allclose(measure, 1.0)
    assert np.isnan(found.ends(bottom[:, None] + 1.0)[0]).all()


def test_a_batch_gives_what_each_gives_alone() -> None:
    flat = FlatView(_view(3.0, 90.0))
    xy = np.random.default_rng(5101).uniform(-1.5, 1.5, (4, 3, 2))
    tall = np.array([1.6, 1.7, 1.8, 1.9])[:, None] + np.zeros((1, 3))
    many = standing_ellipses(flat.projection, xy, tall, 0.25)
    one = standing_ellipses(flat.projection, xy[2, 1:2], tall[2, 1:2], 0.25)
    assert many.shape == (4, 3)
    assert np.allclose(many.uv[2, 1], one.uv[0])
    assert np.allclose(many[2].v[1], one.v[0])


def test_the_area_is_that_of_the_lines_added_up() -> None:
    flat = FlatView(_view(2.4, 30.0))
    found = standing_ellipses(flat.projection, np.array([[0.3, 4.0]]), np.array([1.8]), 0.25)
    lines = np.arange(-200.0, 900.0, 0.05)[None]
    start, stop = found.ends(lines)
    assert np.isclose(np.nansum(stop - start) * 0.05, found.areas()[0], rtol=1e-3)
