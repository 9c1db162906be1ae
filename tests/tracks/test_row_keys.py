"""One number for a track and a frame."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.tracks import LARGEST_NUMBER, pairs_of, row_keys

numbers = st.integers(0, LARGEST_NUMBER)
pairs = st.lists(st.tuples(numbers, numbers), min_size=1, max_size=20)


@given(pairs)
def test_keys_sort_as_their_pairs_do_and_give_them_back(given_pairs: list[tuple[int, int]]) -> None:
    first, then = np.array(given_pairs, np.int32).T
    keys = row_keys(first, then)
    order = np.argsort(keys, kind="stable").tolist()
    assert [given_pairs[row] for row in order] == sorted(given_pairs)
    back = pairs_of(keys)
    assert list(zip(back[0].tolist(), back[1].tolist(), strict=True)) == given_pairs


def test_a_frame_before_the_first_stands_after_the_track_before() -> None:
    keys = row_keys(np.array([4, 5, 5]), np.array([900, -3, 0]))
    assert (np.diff(keys) > 0).all()
