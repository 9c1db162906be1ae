"""Every error is told, and as many as are counted."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from golden_scores import golden_sequences
from scenes_of_rows import pseudo_random, standing, table

from tracking.scoring import (
    NOBODY,
    Conventions,
    ErrorKind,
    ErrorTable,
    FloorMatch,
    errors,
    errors_of,
    examine,
    score,
    score_of,
)

PAIRS = golden_sequences() | {"a crowd": pseudo_random(2, 9, 80)}


def of(found: ErrorTable, kind: ErrorKind) -> list[tuple[Any, ...]]:
    only = found.of_kind(kind)
    columns = (only.frame, only.truth, only.result, only.earlier, only.earlier_frame)
    return list(zip(*(column.tolist() for column in columns), strict=True))


@pytest.mark.parametrize("conventions", Conventions)
@pytest.mark.parametrize("name", PAIRS)
def test_there_are_as_many_errors_as_the_score_counts(name: str, conventions: Conventions) -> None:
    examined = examine(*PAIRS[name], conventions=conventions)
    found, counted = errors_of(examined), score_of(examined).clear
    assert found.count(ErrorKind.SWITCH) == counted.id_switches
    assert found.count(ErrorKind.MISS) == counted.misses
    assert found.count(ErrorKind.FALSE_ALARM) == counted.false_positives
    assert found.count(ErrorKind.FRAGMENTATION) == counted.fragmentations
    assert len(found) == sum(found.count(kind) for kind in ErrorKind)


def test_errors_stand_in_the_order_of_frames() -> None:
    found = errors(*PAIRS["a crowd"])
    assert len(found) > 100
    assert (np.diff(found.frame) >= 0).all()


def test_each_error_says_who_is_concerned_and_where() -> None:
    truth = table([*standing(1, range(6), x=2.0), *standing(2, range(6), x=9.0)])
    result = table(
        [
            *standing(7, range(3), x=2.0),
            *standing(8, range(4, 6), x=2.1),
            *standing(5, range(6), x=9.0),
            (2, 6, 4.0, 1.0),
        ]
    )
    found = errors(truth, result, FloorMatch(0.5))
    assert of(found, ErrorKind.MISS) == [(3, 1, NOBODY, NOBODY, 3)]
    assert of(found, ErrorKind.FALSE_ALARM) == [(2, NOBODY, 6, NOBODY, 2)]
    assert of(found, ErrorKind.SWITCH) == [(4, 1, 8, 7, 2)]
    assert of(found, ErrorKind.FRAGMENTATION) == [(4, 1, 8, 7, 2)]
    assert found.of_kind(ErrorKind.SWITCH).position.tolist() == [[2.0, 0.0]]
    assert found.of_kind(ErrorKind.FALSE_ALARM).position.tolist() == [[4.0, 1.0]]
    assert found.of_kind(ErrorKind.FALSE_ALARM).box.tolist() == [[40.0, 10.0, 10.0, 20.0]]


def test_a_switch_stands_where_the_track_is_if_the_truth_has_no_place() -> None:
    nowhere = float("nan")
    truth = table(standing(1, range(4)))
    truth = type(truth)(
        truth.frame, truth.track, truth.box, truth.position * nowhere, truth.counted
    )
    result = table([*standing(7, range(2)), *standing(8, range(2, 4))])
    switch = errors(truth, result).of_kind(ErrorKind.SWITCH)
    assert switch.position.tolist() == [[0.0, 0.0]]


def test_nothing_has_no_errors() -> None:
    assert len(errors(table([]), table([]))) == 0


def test_a_row_on_a_dont_care_is_no_error() -> None:
    truth = table(standing(1, range(3)), dont_cares=[(1, 1)])
    assert len(errors(truth, table(standing(4, range(3))))) == 0
    assert score(truth, table(standing(4, range(3)))).clear.misses == 0
