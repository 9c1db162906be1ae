"""The fast measures equal a slow restatement of their definitions, on anything."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from plain_score import PlainScore

from tracking.scoring import People, ScoringTable, score

key = st.tuples(st.integers(0, 14), st.integers(1, 4))
box = st.tuples(st.integers(0, 8), st.integers(0, 3), st.integers(3, 9), st.integers(3, 9))
rows = st.dictionaries(key, st.tuples(box, st.sampled_from([1, 1, 1, 0])), min_size=1, max_size=50)


def as_table(rows: dict[Any, Any]) -> ScoringTable:
    keys = sorted(rows)
    boxes = np.array([rows[k][0] for k in keys], np.float64).T
    names = ("left", "top", "width", "height")
    columns: dict[str, NDArray[Any]] = dict(zip(names, boxes, strict=True))
    columns["frame"], columns["track"] = np.array(keys).T
    columns["confidence"] = np.array([rows[k][1] for k in keys])
    return ScoringTable.from_columns(columns, dont_cares=True)


@settings(max_examples=50)
@given(rows, rows)
def test_the_fast_measures_equal_the_plain_ones(first: Any, second: Any) -> None:
    truth, result = as_table(first), as_table(second)
    plain = PlainScore(truth, result)
    found = score(truth, result)
    if not plain.truth_rows or not plain.result_rows:
        return
    numbers = found.as_json()
    for name, value in {**plain.clear(), **plain.identity(), **plain.hota()}.items():
        assert numbers[name] == pytest.approx(value, rel=0, abs=1e-9), name


@settings(max_examples=50)
@given(
    st.lists(st.tuples(st.integers(1, 3), st.integers(0, 3)), min_size=20, max_size=60),
    st.integers(1, 3),
)
def test_people_kept_equal_the_plain_count(story: list[tuple[int, int]], people: int) -> None:
    """Each entry: which track the first person bears in a frame (0: none), and its neighbour."""
    truth, result = {}, {}
    for frame, (own, other) in enumerate(story):
        for person in range(1, people + 1):
            truth[frame, person] = ((person * 30, 0, 9, 9), 1)
        if own:
            result[frame, own] = ((30, 0, 9, 9), 1)
        if other and other != own and people > 1:
            result[frame, other] = ((60, 0, 9, 9), 1)
    result[len(story), 9] = ((500, 0, 9, 9), 1)
    tables = as_table(truth), as_table(result)
    assert score(*tables).people == People(*PlainScore(*tables).papers())
