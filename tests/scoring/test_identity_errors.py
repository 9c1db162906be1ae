"""Identity errors are told one by one."""

from __future__ import annotations

import numpy as np

from tracking.scoring import FloorMatch, ScoringTable, identity_errors


def table(rows: list[tuple[int, int, float]]) -> ScoringTable:
    """Frame, track and x of people far from each other."""
    frame, track, x = (np.array(column) for column in zip(*sorted(rows), strict=True))
    unknown = np.full((len(rows), 4), np.nan)
    place = np.stack((x.astype(float), np.zeros(len(rows))), axis=1)
    return ScoringTable(frame, track, unknown, place, np.ones(len(rows), bool))


def two(names: list[tuple[int, int]]) -> ScoringTable:
    """Two people, five metres apart, under these names frame by frame; 0: not there."""
    return table(
        [
            (frame, name, 5.0 * side)
            for frame, both in enumerate(names)
            for side, name in enumerate(both)
            if name
        ]
    )


def errors(truth: ScoringTable, result: ScoringTable) -> list[tuple[int, tuple, tuple]]:
    found = identity_errors(truth, result, FloorMatch(0.5))
    return [(one.frame, one.tracks, one.people) for one in found]


def test_a_swap_is_four_errors_of_one_frame() -> None:
    truth, result = two([(1, 2)] * 4), two([(7, 8), (7, 8), (8, 7), (8, 7)])
    assert errors(truth, result) == [
        (2, (7,), (1, 2)),
        (2, (7, 8), (1,)),
        (2, (8,), (2, 1)),
        (2, (8, 7), (2,)),
    ]


def test_a_person_found_again_under_another_name_is_one_error() -> None:
    truth, result = two([(1, 2)] * 4), two([(7, 8), (0, 8), (9, 8), (9, 8)])
    assert errors(truth, result) == [(2, (7, 9), (1,))]


def test_a_track_handed_on_after_its_person_left_is_one_error() -> None:
    truth, result = two([(1, 0), (1, 0), (0, 2)]), two([(7, 0), (7, 0), (0, 7)])
    assert errors(truth, result) == [(2, (7,), (1, 2))]


def test_what_is_right_has_no_errors() -> None:
    truth = two([(1, 2)] * 4)
    assert errors(truth, two([(7, 8), (7, 0), (0, 8), (7, 8)])) == []
