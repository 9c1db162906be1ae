"""Parts of a picture are boxes that hold all of a mask and little else."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray

from tracking.stereo.subtraction import areas

MARGIN = (12, 30)


def covered(mask: NDArray[np.uint8]) -> NDArray[np.bool_]:
    inside = np.zeros(mask.shape, np.bool_)
    for box in areas(mask, MARGIN):
        inside[box] = True
    return inside


@settings(max_examples=60, deadline=None)
@given(
    seeds=arrays(np.bool_, st.tuples(st.integers(1, 13), st.integers(1, 13)), fill=st.just(False)),
    rows=st.integers(1, 130),
    columns=st.integers(1, 130),
)
def test_nothing_of_a_mask_is_left_out(seeds: NDArray[np.bool_], rows: int, columns: int) -> None:
    mask = np.zeros((rows, columns), np.uint8)
    spots = np.argwhere(seeds) * 10
    spots = spots[(spots < mask.shape).all(axis=1)]
    mask[spots[:, 0], spots[:, 1]] = 255
    assert covered(mask)[mask > 0].all()


def test_people_far_apart_are_parts_of_their_own() -> None:
    mask = np.zeros((240, 640), np.uint8)
    mask[20:70, 30:60] = mask[150:210, 500:540] = 255
    assert len(areas(mask, MARGIN)) == 2
    assert covered(mask).mean() < 0.05


def test_many_specks_are_one_part() -> None:
    mask = np.zeros((240, 640), np.uint8)
    mask[::16, ::32] = 255
    assert len(areas(mask, MARGIN)) == 1


def test_without_anything_there_is_no_part() -> None:
    assert areas(np.zeros((50, 60), np.uint8), MARGIN) == []
