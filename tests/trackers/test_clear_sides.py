"""Sides of boxes that nobody else is near."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.trackers import clear_sides as module
from tracking.trackers.clear_sides import SIDES, clear_sides


def rows(*boxes: tuple[int, float, float, float, float]) -> dict[str, NDArray]:
    """Rows of tracks: frame, left, top, width, height."""
    values = np.array(boxes, float).T
    return {"frame": values[0].astype(np.int32), **dict(zip(SIDES, values[1:], strict=True))}


def test_a_side_inside_somebody_elses_box_is_not_clear() -> None:
    found = clear_sides(rows((0, 10, 0, 20, 50), (0, 25, 5, 20, 50), (0, 80, 0, 20, 50)))
    assert found.tolist() == [[True, False], [False, True], [True, True]]


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
    none = {name: np.zeros(0, np.int32 if name == "frame" else float) for name in ("frame", *SIDES)}
    assert clear_sides(none).shape == (0, 2)
