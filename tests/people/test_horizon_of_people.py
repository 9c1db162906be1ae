"""The horizon of people's heights in a camera that is not calibrated."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.people.horizon import fit_horizon

FOCAL_PX, MIDDLE = 700.0, (320.0, 240.0)


def boxes_of(tilt_deg: float, count: int, seed: int = 0, camera_m: float = 3.0) -> np.ndarray:
    """People of 1.7 m +- 6 cm who stand about before a camera with this tilt."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-4, 4, count), rng.uniform(7, 20, count)
    tall = rng.normal(1.7, 0.06, count)
    rows = []
    for z in (np.zeros(count), tall):
        tilt, down = np.radians(tilt_deg), camera_m - z
        depth = y * np.cos(tilt) + down * np.sin(tilt)
        below = down * np.cos(tilt) - y * np.sin(tilt)
        rows.append(MIDDLE[1] + FOCAL_PX * below / depth)
        u = MIDDLE[0] + FOCAL_PX * x / depth
    foot, head = rows
    wide = 0.3 * (foot - head)
    return np.column_stack((u - wide / 2, head, wide, foot - head))


def horizon_row(tilt_deg: float) -> float:
    """Where it is."""
    return MIDDLE[1] - FOCAL_PX * float(np.tan(np.radians(tilt_deg)))


@pytest.mark.parametrize("tilt_deg", [2.0, 10.0, 20.0])
def test_the_horizon_is_found_within_its_uncertainty(tilt_deg: float) -> None:
    horizon = fit_horizon(boxes_of(tilt_deg, 150))
    assert horizon is not None
    off = horizon.row(MIDDLE[0]) - horizon_row(tilt_deg)
    assert abs(off) < 4.0 * horizon.row_sd(MIDDLE[0])
    assert abs(off) < 30.0


def test_halves_of_bodies_groups_and_specks_do_not_move_it() -> None:
    boxes = boxes_of(10.0, 150)
    rng = np.random.default_rng(1)
    wrong = boxes[:50].copy()
    wrong[:, 3] *= rng.uniform(0.1, 0.6, 50)
    horizon = fit_horizon(np.concatenate((boxes, wrong)))
    assert horizon is not None
    assert horizon.row(MIDDLE[0]) == pytest.approx(horizon_row(10.0), abs=25.0)
    assert horizon.spread < 0.1


def test_people_are_allowed_and_giants_specks_and_what_flies_are_not() -> None:
    boxes = boxes_of(10.0, 150)
    horizon = fit_horizon(boxes)
    assert horizon is not None
    assert horizon.allows(boxes).all()
    assert horizon.allows(boxes * (1, 1, 1, 0.5) + boxes[:, 3:] * (0, 0.5, 0, 0)).all()
    giants = boxes * (1, 1, 1, 2.5) - boxes[:, 3:] * (0, 1.5, 0, 0)
    specks = boxes * (1, 1, 1, 0.1) + boxes[:, 3:] * (0, 0.9, 0, 0)
    assert not horizon.allows(giants).any()
    assert not horizon.allows(specks).any()
    sky = np.array([[300.0, 5.0, 20.0, 40.0]])
    assert horizon.row(310.0) > 60
    assert not horizon.allows(sky).any()


def test_few_boxes_and_people_who_do_not_grow_downwards_tell_no_horizon() -> None:
    boxes = boxes_of(10.0, 40)
    assert fit_horizon(boxes[:8]) is None
    foot = boxes[:, 1] + boxes[:, 3]
    smaller_below = boxes.copy()
    smaller_below[:, 3] = 300.0 - 0.5 * foot
    smaller_below[:, 1] = foot - smaller_below[:, 3]
    assert fit_horizon(smaller_below) is None


def test_where_nobody_was_seen_all_are_allowed() -> None:
    boxes = boxes_of(10.0, 14)
    boxes[:, 1] += 400.0 - (boxes[:, 1] + boxes[:, 3])  # all in one row: nothing is known of others
    horizon = fit_horizon(boxes)
    assert horizon is None or horizon.allows(np.array([[300.0, 460.0, 10.0, 12.0]])).all()
