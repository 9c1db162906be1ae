"""People who merge seen from above, told apart by their heads."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people import PeopleSettings
from tracking.people.heads_above import split_by_heads
from tracking.people.plan_view import SurfacePoints

EYE = np.zeros(2, np.float32)
Floats = NDArray[np.float32]


def disc(x: float, y: float, radius_m: float, heights_m: tuple[float, float], n: int) -> Floats:
    random = np.random.default_rng(n)
    away, angle = radius_m * np.sqrt(random.random(n)), random.uniform(0, 2 * np.pi, n)
    place = np.array((x, y)) + away[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))
    return np.column_stack((place, random.uniform(*heights_m, n))).astype(np.float32)


def person(x: float, y: float, tall_m: float = 1.75) -> Floats:
    head = disc(x, y, 0.09, (tall_m - 0.22, tall_m), 120)
    return np.concatenate((head, disc(x, y, 0.25, (0.5, tall_m - 0.3), 500)))


def heads(*bodies: Floats) -> Floats:
    """Places over bodies that were taken for one person in their middle."""
    world = np.concatenate(bodies)
    count = len(world)
    area = np.full(count, 0.0012, np.float32)
    noise = np.full(count, 0.03, np.float32)
    points = SurfacePoints(np.arange(count), world, area, noise, mass=area)
    middle = world[:, :2].mean(axis=0, keepdims=True)
    owner = np.zeros(count, np.intp)
    return split_by_heads(middle, owner, points, EYE, PeopleSettings())


def test_two_people_arm_in_arm_are_two() -> None:
    found = heads(person(-0.21, 4), person(0.21, 4, 1.62))
    assert len(found) == 2
    np.testing.assert_allclose(sorted(found[:, 0]), (-0.21, 0.21), atol=0.06)


def test_one_person_with_an_arm_stretched_out_is_one() -> None:
    arm = disc(0.4, 4, 0.08, (1.2, 1.4), 60)
    assert len(heads(person(0, 4), arm)) == 1


def test_one_person_who_spreads_like_one_stays_where_they_are() -> None:
    alone = person(0.3, 5)
    np.testing.assert_array_equal(heads(alone), alone[:, :2].mean(axis=0, keepdims=True))
