"""People, distances and recordings of a score add up to the whole."""

from __future__ import annotations

import math

import pytest
from golden_scores import golden_sequences
from scenes_of_rows import pseudo_random, standing, table

from tests.peers.figures import differences, trackeval_figures
from tracking.errors import SettingsError
from tracking.scoring import (
    Conventions,
    FloorMatch,
    combined,
    examine,
    per_distance_of,
    per_person,
    per_person_of,
    score,
    score_of,
)

PAIRS = golden_sequences() | {"a crowd": pseudo_random(2, 9, 80)}


@pytest.mark.parametrize("conventions", Conventions)
@pytest.mark.parametrize("name", PAIRS)
def test_people_add_up_to_the_score(name: str, conventions: Conventions) -> None:
    examined = examine(*PAIRS[name], conventions=conventions)
    people, whole = per_person_of(examined), score_of(examined)
    assert len(people) == whole.truth_people
    assert sum(one.matches for one in people) == whole.clear.matches
    assert sum(one.misses for one in people) == whole.clear.misses
    assert sum(one.followed.id_switches for one in people) == whole.clear.id_switches
    assert sum(one.followed.fragmentations for one in people) == whole.clear.fragmentations
    assert sum(one.followed.identity_matches for one in people) == whole.identity.true_positives
    assert sum(one.followed.detected for one in people) == whole.people.detected
    assert sum(one.followed.kept for one in people) == whole.people.kept


def test_a_person_is_told_with_its_tracks() -> None:
    truth = table([*standing(1, range(2, 12)), *standing(2, [5], x=50)])
    result = table([*standing(7, range(2, 5)), *standing(9, range(6, 12), x=0.2)])
    first, second = per_person(truth, result, FloorMatch(0.5))
    assert (first.person, first.start, first.end, first.frames, first.matches) == (1, 2, 12, 10, 9)
    assert (first.tracks, first.followed.named, first.followed.identity_matches) == ((7, 9), 9, 6)
    assert (first.misses, first.share_matched) == (1, 0.9)
    assert first.position_error.median == pytest.approx(0.2)
    assert (second.matches, second.tracks, second.followed.named) == (0, (), None)
    assert math.isnan(second.similarity)


@pytest.mark.parametrize("name", [name for name in PAIRS if name != "a crowd"])
def test_distances_add_up_to_the_score(name: str) -> None:
    examined = examine(*PAIRS[name], FloorMatch(0.5))
    ranges, whole = per_distance_of(examined, (0.0, 0.0), [0.0, 1.0, 2.5]), score_of(examined)
    assert sum(one.matches for one in ranges) == whole.clear.matches
    assert sum(one.misses for one in ranges) == whole.clear.misses
    assert sum(one.false_positives for one in ranges) == whole.clear.false_positives
    assert sum(one.id_switches for one in ranges) == whole.clear.id_switches
    assert sum(one.fragmentations for one in ranges) == whole.clear.fragmentations
    assert sum(one.identity_matches for one in ranges) == whole.identity.true_positives


def test_who_is_far_counts_far() -> None:
    truth = table([*standing(1, range(4), x=3.0), *standing(2, range(4), x=10.0)])
    result = table(
        [*standing(1, range(4), x=3.1), *standing(2, range(2), x=10.4), (3, 8, 10.0, 8.0)]
    )
    near, far = per_distance_of(examine(truth, result, FloorMatch(0.5)), (0.0, 0.0), [0.0, 5.0])
    assert (near.mota, near.recall, near.precision, near.idf1) == (1.0, 1.0, 1.0, 1.0)
    assert near.position_error.mean == pytest.approx(0.1)
    assert (far.from_m, far.to_m) == (5.0, math.inf)
    assert (far.matches, far.misses, far.false_positives) == (2, 2, 1)
    assert far.mota == pytest.approx(1 / 4)
    assert far.position_error.mean == pytest.approx(0.4)


def test_rows_without_a_place_have_a_range_of_their_own() -> None:
    truth = table([(0, 1, 1.0, 0.0), (0, 2, math.nan, math.nan)])
    *known, unknown = per_distance_of(examine(truth, table([]), FloorMatch()), (0.0, 0.0), [0.0])
    assert [one.misses for one in known] == [1]
    assert math.isnan(unknown.from_m)
    assert (unknown.misses, unknown.recall) == (1, 0.0)
    assert math.isnan(unknown.precision)


@pytest.mark.parametrize("edges", [[], [1.0, 2.0], [0.0, 3.0, 3.0], [0.0, math.nan]])
def test_distances_that_are_none_are_refused(edges: list[float]) -> None:
    with pytest.raises(SettingsError, match="must grow from 0"):
        per_distance_of(examine(table([]), table([])), (0.0, 0.0), edges)


def test_counts_of_recordings_add_up_when_they_are_combined() -> None:
    one = score(table(standing(1, range(4))), table(standing(1, range(4))), frames=9)
    other = score(table(standing(1, range(4))), table(standing(1, range(2), x=0.1)))
    both = combined([one, other])
    assert both.frames == 13
    assert both.clear.misses == 2
    assert both.position_error.mean == pytest.approx(0.2 / 6)


def test_nothing_cannot_be_combined() -> None:
    with pytest.raises(SettingsError, match="no score to combine"):
        combined([])


def test_scores_of_different_conventions_cannot_be_combined() -> None:
    pair = PAIRS["a crowd"]
    scores = [score(*pair, conventions=conventions) for conventions in Conventions]
    with pytest.raises(SettingsError, match="different conventions"):
        combined(scores)


def test_a_combined_score_of_one_is_that_score() -> None:
    one = score(*PAIRS["a crowd"])
    apart = differences(trackeval_figures(combined([one])), trackeval_figures(one))
    assert max(apart.values()) < 1e-12
