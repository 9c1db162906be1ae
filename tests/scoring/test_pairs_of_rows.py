"""Rows are put in pairs, numbered and assigned the same way however large the blocks are."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scenes_of_rows import pseudo_random, standing, table
from scipy.optimize import linear_sum_assignment

from tracking.scoring import BoxMatch, EitherMatch, FloorMatch, Match, ScoringTable, score
from tracking.scoring import candidates as blocks
from tracking.scoring.assignment import assign, best_of_few
from tracking.scoring.candidates import candidates
from tracking.scoring.id_index import grouped, numbered
from tracking.scoring.pairs import Candidates, Frames, Rows


def all_pairs(truth: ScoringTable, result: ScoringTable, match: Match) -> list[tuple[int, int]]:
    """Row numbers of the alike pairs, every row against every row of its frame."""
    rows = [
        (a, b)
        for a in range(len(truth))
        for b in range(len(result))
        if truth.frame[a] == result.frame[b]
    ]
    pairs = Rows(np.array([a for a, _ in rows]), np.array([b for _, b in rows]))
    alike = match.similarity(match.measured(truth), match.measured(result), pairs) > 0
    return [row for row, kept in zip(rows, alike.tolist(), strict=True) if kept]


@pytest.mark.parametrize("at_once", [1, 7, 100, 1 << 17])
@pytest.mark.parametrize("match", [BoxMatch(), FloorMatch(0.5), EitherMatch()], ids=repr)
def test_no_pair_is_overlooked_whatever_the_blocks(
    match: Match, at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(blocks, "_PAIRS_AT_ONCE", at_once)
    crowd = [(3, 10 + n, 0.2 * n, 0.1 * n) for n in range(25)]
    truth = table([*standing(1, range(9)), *standing(2, [2, 3, 8], x=1.2), *crowd])
    result = table([*standing(1, [0, 1, 3, 8], x=0.3), *standing(4, [3, 5, 8], x=-0.9), *crowd[:9]])
    found = candidates(truth, result, Frames.shared(truth, result), match)
    rows = list(zip(found.rows.truth.tolist(), found.rows.result.tolist(), strict=True))
    assert rows == all_pairs(truth, result, match)
    shared = np.array([0, 1, 3, 5, 8])
    assert (shared[found.frame] == truth.frame[found.rows.truth]).all()


def test_the_order_of_the_rows_does_not_change_the_score() -> None:
    truth, result = pseudo_random(2, 9, 80)
    order = np.random.default_rng(0).permutation(len(result))
    names = ("left", "top", "width", "height")
    columns = {"frame": result.frame, "track": result.track} | dict(
        zip(names, result.box.T, strict=True)
    )
    mixed = ScoringTable.from_columns({name: column[order] for name, column in columns.items()})
    assert (np.diff(mixed.frame) >= 0).all()
    assert score(truth, mixed).identity == score(truth, result).identity


@pytest.mark.parametrize("far", [0, 10**12], ids=["ids near each other", "ids far apart"])
def test_ids_are_numbered_in_their_order(far: int) -> None:
    ids = np.array([7, 3, 7, 5 + far, 3])
    different, number = numbered(ids)
    assert different.tolist() == [3, 7, 5 + far] if far else [3, 5, 7]
    assert (different[number] == ids).all()


@pytest.mark.parametrize("groups", [4, 70_000])
def test_rows_of_a_group_stay_in_order(groups: int) -> None:
    assert grouped(np.array([2, 0, 2, 1, 0]), groups).tolist() == [1, 4, 3, 0, 2]


square = st.lists(
    st.lists(st.sampled_from([0.0, 0.5, 0.51, 0.9, 1.0]), min_size=4, max_size=4),
    min_size=3,
    max_size=3,
)


@settings(max_examples=80)
@given(square, square)
def test_an_assignment_is_scipys(first: list[list[float]], second: list[list[float]]) -> None:
    """Where several are best, too: the same one."""
    both = np.array([first, second])
    frame, truth, result = np.nonzero(both)
    pairs = Candidates(Rows(truth + 3 * frame, result + 4 * frame), both[both > 0], frame)
    begin = np.array([0, 1])
    frames = Frames(3 * begin, 3 * begin + 3, 4 * begin, 4 * begin + 4)
    chosen = assign(pairs, pairs.similarity, frames)
    for number in (0, 1):
        rows, columns = linear_sum_assignment(both[number], maximize=True)
        wanted = {
            (r, c) for r, c in zip(rows.tolist(), columns.tolist(), strict=True)
            if both[number, r, c]
        }  # fmt: skip
        own = chosen & (frame == number)
        assert set(zip(truth[own].tolist(), result[own].tolist(), strict=True)) == wanted


@settings(max_examples=80)
@given(square)
def test_what_is_evident_is_the_only_best(weights: list[list[float]]) -> None:
    matrix = np.array(weights)
    truth, result = np.nonzero(matrix)
    weight = matrix[matrix > 0].tolist()
    best = best_of_few(truth.tolist(), result.tolist(), weight)
    if best is None:
        return
    total = sum(weight[each] for each in best)
    rows, columns = linear_sum_assignment(matrix, maximize=True)
    assert total == pytest.approx(matrix[rows, columns].sum())
    for each in best:
        without = matrix.copy()
        without[truth[each], result[each]] = 0
        rows, columns = linear_sum_assignment(without, maximize=True)
        assert without[rows, columns].sum() < total


def test_track_map_needs_confidences_and_boxes() -> None:
    truth = table(standing(1, range(5)))
    told = table(standing(1, range(5)))
    untold = ScoringTable(told.frame, told.track, told.box, told.position, told.counted)
    unknown = ScoringTable(
        told.frame, told.track, told.box, told.position, told.counted, np.full(5, -1.0)
    )
    assert score(truth, untold).track_map is None
    assert score(truth, unknown).track_map is None
    assert score(truth, told, FloorMatch()).track_map is None
    assert score(truth, untold).as_json()["track_map"] is None
    found = score(truth, told).track_map
    assert found is not None
    assert (found.ap, found.ar) == (pytest.approx(1.0), pytest.approx(1.0))


def test_the_surer_track_takes_the_person() -> None:
    truth = table(standing(1, range(6)))
    rows = table([*standing(1, range(6)), *standing(2, range(6), y=0.2)])
    sure = np.where(rows.track == 2, 0.9, 0.4)
    result = ScoringTable(rows.frame, rows.track, rows.box, rows.position, rows.counted, sure)
    found = score(truth, result).track_map
    assert found is not None
    assert found.found[0, 0].tolist() == [True, False]
    assert found.found[0, -1].tolist() == [False, True]
    assert found.average_precision().tolist()[-1] == pytest.approx(0.5)


def test_floor_distances_round_as_in_trackeval() -> None:
    """Else pairs that are equally far apart there would not be here, and others be matched."""
    places = np.random.default_rng(5).integers(0, 80, (400, 2)) / 40.0
    truth = table([(0, n, x, y) for n, (x, y) in enumerate(places[:200].tolist())])
    result = table([(0, n, x, y) for n, (x, y) in enumerate(places[200:].tolist())])
    pairs = Rows(np.arange(200), np.arange(200))
    match = FloorMatch(0.5)
    found = match.similarity(match.measured(truth), match.measured(result), pairs)
    apart_m = np.linalg.norm(places[:200, None] - places[None, 200:], axis=2).diagonal()
    assert (found == np.maximum(0, 1 - apart_m / 1.0)).all()
