import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scenes_of_rows import pseudo_random, standing, table

from tracking.errors import FormatError
from tracking.scoring import (
    Disagreement,
    EitherMatch,
    ScoringTable,
    agreement,
    cohen_kappa,
    score,
)

FRAMES = range(100)


def _renamed(a: ScoringTable, names) -> ScoringTable:
    track = np.array([names(f, t) for f, t in zip(a.frame.tolist(), a.track.tolist(), strict=True)])
    return ScoringTable(a.frame, track.astype(np.int64), a.box, a.position, a.counted)


@pytest.fixture
def three():
    """Three people who stand far from each other."""
    return table([row for x in (1, 2, 3) for row in standing(x, FRAMES, x=3.0 * x)])


def test_a_table_agrees_with_itself_in_everything(three):
    found = agreement(three, three)
    assert (found.idf1, found.kappa, found.disagreements) == (1.0, 1.0, ())
    assert (found.frames, found.rows) == (100, 300)
    assert found.same == ((1, 1), (2, 2), (3, 3))


def test_other_ids_for_the_same_people_are_no_disagreement(three):
    found = agreement(three, _renamed(three, lambda _, track: 40 - track))
    assert (found.idf1, found.kappa, found.disagreements) == (1.0, 1.0, ())
    assert found.same == ((1, 39), (2, 38), (3, 37))


def test_a_swap_that_only_one_side_sees_is_a_stretch_of_each_of_both(three):
    swapped = _renamed(three, lambda f, track: {1: 2, 2: 1}.get(track, track) if f >= 80 else track)
    found = agreement(three, swapped)
    assert found.disagreements == (
        Disagreement(1, 2, 80, 100, "identity"),
        Disagreement(2, 1, 80, 100, "identity"),
    )
    assert found.idf1 == pytest.approx(260 / 300)
    assert found.kappa == pytest.approx((260 / 300 - 1 / 3) / (1 - 1 / 3))


def test_somebody_only_one_side_sees_disagrees_as_nobody():
    a = table(standing(1, FRAMES) + standing(2, range(10, 20), x=5))
    b = table(standing(7, FRAMES) + standing(8, range(30, 35), x=9))
    found = agreement(a, b)
    assert found.disagreements == (
        Disagreement(2, 0, 10, 20, "only a"),
        Disagreement(0, 8, 30, 35, "only b"),
    )
    assert found.rows == 115


def test_short_gaps_in_a_disagreement_are_bridged_where_that_is_asked_for():
    a = table(standing(1, FRAMES) + standing(2, [3, 4, 6, 7, 20], x=5))
    b = table(standing(1, FRAMES))
    assert [(one.start, one.end) for one in agreement(a, b).disagreements] == [
        (3, 5),
        (6, 8),
        (20, 21),
    ]
    assert [(one.start, one.end) for one in agreement(a, b, gap=1).disagreements] == [
        (3, 8),
        (20, 21),
    ]


def test_rows_match_by_the_floor_where_boxes_are_far_apart_and_by_boxes_without_a_floor():
    a, b = table(standing(1, FRAMES)), table(standing(1, FRAMES, x=0.4, y=0.2))
    elsewhere = ScoringTable(
        b.frame, b.track, b.box + np.array([900.0, 0, 0, 0]), b.position, b.counted
    )
    homeless = ScoringTable(b.frame, b.track, b.box, np.full_like(b.position, np.nan), b.counted)
    assert agreement(a, elsewhere).kappa == 1.0
    assert agreement(a, homeless).idf1 == score(a, homeless).identity.idf1


def test_what_cannot_be_placed_at_all_is_refused(three):
    unknown = ScoringTable(
        three.frame,
        three.track,
        np.full_like(three.box, np.nan),
        np.full_like(three.position, np.nan),
        three.counted,
    )
    with pytest.raises(FormatError, match="neither boxes nor floor positions"):
        agreement(three, unknown)


def test_nothing_against_nothing_is_undefined_and_against_something_no_agreement(three):
    nothing = table([])
    assert math.isnan(agreement(nothing, nothing).idf1)
    assert math.isnan(agreement(nothing, nothing).kappa)
    assert agreement(nothing, nothing).as_json()["kappa"] is None
    found = agreement(three, nothing)
    assert (found.idf1, found.kappa) == (0.0, 0.0)
    assert [one.kind for one in found.disagreements] == ["only a"] * 3


def test_ids_by_lot_agree_no_more_than_chance(three):
    lots = np.random.default_rng(3101)
    drawn = {frame: lots.permutation(3) + 1 for frame in range(3000)}
    people = table([row for x in (1, 2, 3) for row in standing(x, range(3000), x=3.0 * x)])
    found = agreement(people, _renamed(people, lambda f, track: drawn[f][track - 1]))
    assert abs(found.kappa) < 0.05


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**20), st.integers(1, 4), st.integers(1, 12))
def test_both_ways_say_the_same(seed, people, frames):
    a, b = pseudo_random(seed, people, frames)
    a, b = a.rows(a.counted), b.rows(b.counted)
    one, other = agreement(a, b), agreement(b, a)
    assert one.idf1 == pytest.approx(other.idf1, nan_ok=True)
    assert (one.frames, one.rows) == (other.frames, other.rows)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**20), st.integers(1, 4), st.integers(1, 12))
def test_every_row_is_compared_and_each_that_differs_lies_in_a_stretch(seed, people, frames):
    a, b = pseudo_random(seed, people, frames)
    a, b = a.rows(a.counted), b.rows(b.counted)
    found = agreement(a, b, EitherMatch())
    matched = len(a) + len(b) - found.rows
    assert 0 <= matched <= min(len(a), len(b))
    assert found.kappa <= 1.0 or math.isnan(found.kappa)
    alone = {"only a": 0, "only b": 0, "identity": 0}
    for one in found.disagreements:
        assert (one.track_a == 0, one.track_b == 0) == (one.kind == "only b", one.kind == "only a")
        alone[one.kind] += one.end - one.start
    assert (alone["only a"], alone["only b"]) == (len(a) - matched, len(b) - matched)


@settings(max_examples=100, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=1, max_size=60))
def test_kappa_is_what_the_table_of_both_ratings_says(pairs):
    first, second = np.array(pairs, np.int64).T
    counts = np.zeros((4, 4))
    for row, column in pairs:
        counts[row, column] += 1
    expected = np.outer(counts.sum(axis=1), counts.sum(axis=0)) / len(pairs)
    if np.trace(expected) == len(pairs):
        assert cohen_kappa(first, second) == 1.0
    else:
        apart = 1 - np.eye(4)
        weighed = 1 - (apart * counts).sum() / (apart * expected).sum()
        assert cohen_kappa(first, second) == pytest.approx(weighed, abs=1e-12)
        assert cohen_kappa(second, first) == pytest.approx(weighed, abs=1e-12)


@pytest.mark.parametrize(
    ("seed", "items", "classes", "said"),
    [
        (3101, 50, 3, 0.24969987995198084),
        (3102, 400, 6, 0.31869170799786906),
        (3103, 7, 2, 1.0),
    ],
)
def test_kappa_equals_what_scikit_learn_says(seed, items, classes, said):
    """`sklearn.metrics.cohen_kappa_score` of scikit-learn 1.9.1 on the same ratings."""
    drawn, state = [], seed
    for _ in range(2 * items):
        state = (1103515245 * state + 12345) % 2**31
        drawn.append((state >> 16) % classes)
    first, second = np.array(drawn[:items]), np.array(drawn[items:])
    second = np.where(np.arange(items) % 3 == 0, first, second)
    assert cohen_kappa(first, second) == pytest.approx(said, abs=1e-12)
