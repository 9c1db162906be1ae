"""People told apart from above."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.people import PeopleSettings
from tracking.people.plan_view import SurfacePoints, find_people, surface_points
from tracking.people.regions import assign_points, measure, paint
from tracking.stereo import SightLines

EYE = np.zeros(2, np.float32)
SETTINGS = PeopleSettings()
Floats = NDArray[np.float32]


def body(
    x: float, y: float, noise_m: float = 0.05, count: int = 300, seed: int = 0
) -> SurfacePoints:
    """The near half of a body's surface, its range noisy."""
    random = np.random.default_rng(seed)
    angle = random.uniform(-np.pi / 2, np.pi / 2, count)
    towards = -np.array((x, y)) / np.hypot(x, y)
    across = np.array((-towards[1], towards[0]))
    place = np.array((x, y)) + 0.2 * (
        np.cos(angle)[:, None] * towards * 0.6 + np.sin(angle)[:, None] * across
    )
    place += random.normal(0, noise_m, count)[:, None] * towards
    world = np.column_stack((place, random.uniform(0.35, 1.75, count))).astype(np.float32)
    area = np.full(count, 0.6 / count, np.float32)
    noise = np.full(count, max(noise_m, 0.02), np.float32)
    return SurfacePoints(np.arange(count), world, area, noise, mass=area)


def together(*bodies: SurfacePoints) -> SurfacePoints:
    count = sum(len(b.pixel) for b in bodies)
    return SurfacePoints(
        np.arange(count),
        np.concatenate([b.world for b in bodies]),
        np.concatenate([b.area for b in bodies]),
        np.concatenate([b.range_noise for b in bodies]),
        np.concatenate([b.mass for b in bodies]),
    )


def nearest(places: Floats, x: float, y: float) -> float:
    return float(np.hypot(places[:, 0] - x, places[:, 1] - y).min())


def test_nothing_seen_is_nobody() -> None:
    nothing = body(0, 4).chosen(np.arange(0))
    assert len(find_people(nothing, EYE, SETTINGS)) == 0


def test_a_little_surface_is_nobody() -> None:
    crumb = body(0, 4, count=300).chosen(np.arange(10))
    assert len(find_people(crumb, EYE, SETTINGS)) == 0


@settings(max_examples=40, deadline=None)
@given(x=st.floats(-3, 3), y=st.floats(2, 9), seed=st.integers(0, 99))
def test_one_body_is_one_person_where_it_stands(x: float, y: float, seed: int) -> None:
    places = find_people(body(x, y, 0.004 * y * y, seed=seed), EYE, SETTINGS)
    assert len(places) == 1
    assert nearest(places, x, y) < 0.25


@settings(max_examples=40, deadline=None)
@given(
    y=st.floats(3, 8),
    beside=st.floats(0.6, 1.5),
    behind=st.floats(-0.5, 0.5),
    seed=st.integers(0, 99),
)
def test_two_people_side_by_side_are_two(y: float, beside: float, behind: float, seed: int) -> None:
    seen = together(
        body(-beside / 2, y, 0.03, seed=seed), body(beside / 2, y + behind, 0.03, seed=seed + 100)
    )
    places = find_people(seen, EYE, SETTINGS)
    assert len(places) == 2
    assert nearest(places, -beside / 2, y) < 0.3
    assert nearest(places, beside / 2, y + behind) < 0.3


def test_people_behind_each_other_in_the_picture_are_told_apart_by_range() -> None:
    places = find_people(together(body(0, 3, 0.05), body(0, 4.2, 0.1, seed=1)), EYE, SETTINGS)
    assert len(places) == 2


def test_what_lies_between_a_nearer_and_a_farther_surface_counts_less() -> None:
    camera = Camera(np.array([[510.0, 0, 80], [0, 510, 60], [0, 0, 1]]), np.zeros(0), 160, 120)
    pair = StereoCalibration(camera, camera, np.eye(3), np.array([-0.12, 0, 0]))
    lines = SightLines(Rectification(pair, Ground(2.4, 30.0)))
    disparity = np.full((60, 80), np.nan, np.float32)
    disparity[20:40, 20:30], disparity[20:40, 30], disparity[20:40, 31:41] = 12.0, 10.5, 9.0
    rays = np.ascontiguousarray(lines.rays[::2, ::2])
    points = surface_points(disparity, lines, rays, 4, 0.2)
    share = points.mass / points.area
    between = disparity.ravel()[points.pixel] == 10.5
    assert (share[between] < 0.5).all()
    assert (share[~between] == 1.0).all()


def test_points_belong_to_whom_they_are_near() -> None:
    seen = together(body(-0.5, 4), body(0.5, 4, seed=1))
    owner = assign_points(np.array([[-0.5, 4], [0.5, 4]], np.float32), seen, EYE, SETTINGS)
    assert (owner[:300] == 0).mean() > 0.98
    assert (owner[300:] == 1).mean() > 0.98


def test_points_far_from_everybody_belong_to_nobody() -> None:
    owner = assign_points(np.array([[3.0, 4.0]], np.float32), body(-1, 4), EYE, SETTINGS)
    assert (owner == -1).all()


def test_a_region_is_measured_in_metres() -> None:
    seen = body(0, 4, 0.02, count=2000)
    extent = measure(1, np.zeros(2000, np.intp), seen, EYE, columns=80)
    assert abs(extent.high[0] - 1.72) < 0.04
    assert abs(extent.low[0] - 0.38) < 0.04
    assert abs(extent.width[0] - 0.4) < 0.05
    assert abs(extent.area[0] - 0.6) < 0.01


def test_foreground_without_range_goes_to_the_person_it_touches() -> None:
    certain = np.zeros((40, 40), np.uint8)
    certain[5:35, 10:20] = 255
    certain[5:10, 30:36] = 255
    known = np.zeros((40, 40), bool)
    known[5:35, 12:14] = True
    pixel = np.flatnonzero(known)
    points = SurfacePoints(
        pixel, np.zeros((len(pixel), 3), np.float32), *(np.ones(len(pixel), np.float32),) * 3
    )
    labels = paint(np.zeros(len(pixel), np.intp), points, certain)
    assert (labels[5:35, 10:20] == 1).all()
    assert not labels[:, 30:].any()
