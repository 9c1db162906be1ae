"""Sides of boxes that show their own person and nobody else."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.trackers.shared import clear_sides as module
from tracking.trackers.shared.clear_sides import clear_sides
from tracking.tracks.columns import SIDES


def rows(
    *boxes: tuple[int, float, float, float, float], predicted: tuple[int, ...] = ()
) -> dict[str, NDArray]:
    """Rows of tracks: frame, left, top, width, height; numbers of those only predicted."""
    values = np.array(boxes, float).T
    found = {"frame": values[0].astype(np.int32), **dict(zip(SIDES, values[1:], strict=True))}
    return {**found, "predicted": np.isin(np.arange(len(boxes)), predicted)}


def test_a_side_in_the_box_of_somebody_nearer_is_not_clear() -> None:
    found = clear_sides(rows((0, 10, 0, 20, 50), (0, 25, 5, 20, 50), (0, 80, 0, 20, 50)))
    assert found.tolist() == [[True, False], [True, True], [True, True]]


def test_a_side_in_the_box_of_somebody_farther_who_is_not_told_apart_is_not_clear() -> None:
    nearer, farther = (0, 25, 5, 20, 50), (0, 10, 0, 20, 50)
    assert clear_sides(rows(nearer, farther))[0].all()
    assert clear_sides(rows(nearer, farther, predicted=(1,)))[0].tolist() == [False, True]


def test_of_two_who_stand_as_near_neither_is_clear_towards_the_other() -> None:
    found = clear_sides(rows((0, 10, 0, 20, 50), (0, 25, 0, 20, 50)))
    assert found.tolist() == [[True, False], [False, True]]


def test_boxes_of_other_frames_and_above_each_other_leave_sides_clear() -> None:
    assert clear_sides(rows((0, 10, 0, 20, 50), (1, 25, 5, 20, 50), (1, 25, 60, 20, 50))).all()


def test_rows_may_come_in_any_order_and_in_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(3)
    place = random.uniform(0, 200, (300, 2))
    several = rows(
        *(
            (int(frame), *at, 30, 60)
            for frame, at in zip(random.integers(0, 30, 300), place, strict=True)
        )
    )
    whole = clear_sides(several)
    monkeypatch.setattr(module, "_CHUNK_ROWS", 7)
    order = random.permutation(300)
    mixed = clear_sides({name: column[order] for name, column in several.items()})
    np.testing.assert_array_equal(mixed, whole[order])
    assert 0.1 < whole.mean() < 0.9


def test_a_run_without_rows_has_no_sides() -> None:
    kinds = {"frame": np.int32, "predicted": np.bool_, **dict.fromkeys(SIDES, np.float64)}
    none = {name: np.zeros(0, kind) for name, kind in kinds.items()}
    assert clear_sides(none).shape == (0, 2)
