"""Scores of cases small enough to be worked out by hand."""

from __future__ import annotations

import json
import math
import tracemalloc
from typing import Any

import numpy as np
import pytest
from scenes_of_rows import standing, table

from tracking.errors import FormatError, SettingsError
from tracking.scoring import BoxMatch, FloorMatch, Match, ScoringTable, score

KEYS = [
    *("frames", "truth_people", "MOTA", "MOTP", "IDF1", "IDP", "IDR"),
    *("HOTA", "DetA", "AssA", "LocA", "id_switches", "fragmentations"),
    *("false_positives", "misses", "mostly_tracked", "mostly_lost"),
    *("people_detected", "people_kept", "tracking_accuracy", "position_error_m"),
]


def numbers(truth: ScoringTable, result: ScoringTable, match: Match | None = None) -> Any:
    return score(truth, result, match).as_json()


def test_truth_against_itself_is_perfect() -> None:
    truth = table([*standing(1, range(20)), *standing(2, range(5, 30), x=5)])
    found = numbers(truth, truth)
    assert set(KEYS) <= set(found)
    for name in ("MOTA", "MOTP", "IDF1", "IDP", "IDR", "HOTA", "DetA", "AssA", "LocA"):
        assert found[name] == pytest.approx(1, abs=1e-12), name
    for name in ("id_switches", "fragmentations", "false_positives", "misses", "mostly_lost"):
        assert found[name] == 0, name
    assert (found["frames"], found["truth_people"], found["mostly_tracked"]) == (30, 2, 2)
    assert (found["people_detected"], found["people_kept"], found["tracking_accuracy"]) == (2, 2, 1)
    assert found["position_error_m"] == {"mean": 0, "std": 0, "median": 0, "p95": 0}


def test_a_switch_a_miss_and_a_false_positive_are_counted() -> None:
    truth = table(standing(1, range(10)))
    result = table(
        [*standing(7, range(4)), *standing(8, range(5, 10)), *standing(9, [2], x=50)],
    )
    found = numbers(truth, result)
    assert found["id_switches"] == 1
    assert found["fragmentations"] == 0  # frame 4 has no rows in the result
    assert (found["misses"], found["false_positives"]) == (1, 1)
    assert found["MOTA"] == pytest.approx(1 - 3 / 10)
    assert found["IDF1"] == pytest.approx(5 / (5 + 0.5 * 5 + 0.5 * 5))


def test_a_gap_while_others_are_tracked_is_a_fragmentation() -> None:
    truth = table([*standing(1, range(10)), *standing(2, range(10), x=50)])
    result = table(
        [*standing(1, range(4)), *standing(1, range(6, 10)), *standing(2, range(10), x=50)]
    )
    found = numbers(truth, result)
    assert (found["fragmentations"], found["id_switches"], found["misses"]) == (1, 0, 2)


def test_partners_stay_together_while_they_match() -> None:
    truth = table(standing(1, range(2)))
    late_comer = (1, 8, 0.0, 0.0)
    result = table([(0, 7, 0.2, 0.0), (1, 7, 0.2, 0.0), late_comer])
    found = numbers(truth, result)
    assert (found["id_switches"], found["false_positives"]) == (0, 1)
    assert found["MOTP"] == pytest.approx(8 / 12)


def test_an_overlap_of_exactly_one_half_matches() -> None:
    shift = 1 / 3  # of a box 10 pixels wide: 6.667 shared of 13.333 covered
    assert numbers(table([(0, 1, 0, 0)]), table([(0, 1, shift, 0)]))["misses"] == 0
    assert numbers(table([(0, 1, 0, 0)]), table([(0, 1, 1.02 * shift, 0)]))["misses"] == 1


def test_a_stricter_overlap_can_be_asked_for() -> None:
    pair = table([(0, 1, 0, 0)]), table([(0, 1, 0.2, 0)])
    assert numbers(*pair, BoxMatch(0.66))["misses"] == 0
    assert numbers(*pair, BoxMatch(0.67))["misses"] == 1


def test_a_row_on_a_dont_care_is_dropped_and_the_dont_care_is_no_miss() -> None:
    truth = table([*standing(1, range(4)), *standing(2, range(4), x=50)], [(2, 2), (3, 2)])
    result = table([*standing(1, range(4)), *standing(2, range(3), x=50), (3, 9, 90.0, 0.0)])
    found = numbers(truth, result)
    assert (found["misses"], found["false_positives"]) == (0, 1)
    assert found["truth_people"] == 2


def test_a_dont_care_does_not_swallow_the_row_of_a_person_who_counts() -> None:
    truth = table([(0, 1, 0, 0), (0, 2, 0.2, 0)], dont_cares=[(0, 2)])
    found = numbers(truth, table([(0, 5, 0, 0)]))
    assert (found["misses"], found["false_positives"]) == (0, 0)


@pytest.mark.parametrize(
    ("truth", "result", "misses", "false", "lost"),
    [([], [], 0, 0, 0), (standing(1, range(3)), [], 3, 0, 1), ([], standing(1, [4]), 0, 1, 0)],
    ids=["nothing", "no result", "no truth"],
)
def test_an_empty_side_scores_zero(
    truth: Any, result: Any, misses: int, false: int, lost: int
) -> None:
    found = numbers(table(truth), table(result))
    for name in ("MOTA", "MOTP", "IDF1", "IDP", "IDR", "HOTA", "DetA", "AssA"):
        assert found[name] == 0, name
    assert found["LocA"] == 1
    assert (found["misses"], found["false_positives"], found["mostly_lost"]) == (
        misses,
        false,
        lost,
    )
    assert found["tracking_accuracy"] is None
    assert set(found["position_error_m"].values()) == {None}


def test_undefined_numbers_are_null_in_json() -> None:
    text = json.dumps(numbers(table([]), table([])), allow_nan=False)
    assert '"tracking_accuracy": null' in text


def test_tracks_that_never_meet_the_truth_score_zero() -> None:
    found = numbers(table(standing(1, range(3))), table(standing(1, range(3), x=99)))
    assert (found["MOTA"], found["HOTA"], found["IDF1"], found["LocA"]) == (-1, 0, 0, 1)


def test_the_recording_may_be_longer_than_its_tracks() -> None:
    pair = table(standing(1, range(3))), table([])
    assert score(*pair).frames == 3
    assert score(*pair, frames=100).frames == 100


def test_floor_matching_takes_the_radius_and_not_more() -> None:
    truth = table([(0, 1, 0, 0), (1, 1, 0, 0)])
    result = table([(0, 1, 0.5, 0), (1, 1, 0.51, 0)])
    found = numbers(truth, result, FloorMatch(0.5))
    assert (found["misses"], found["false_positives"]) == (1, 1)
    assert numbers(truth, result, FloorMatch(0.6))["misses"] == 0


def test_position_errors_are_taken_over_matched_pairs() -> None:
    truth = table(standing(1, range(4)))
    result = table([(n, 1, error, 0.0) for n, error in enumerate((0.0, 0.1, 0.2, 0.3))])
    error = numbers(truth, result, FloorMatch(0.5))["position_error_m"]
    assert error["mean"] == pytest.approx(0.15)
    assert error["std"] == pytest.approx(math.sqrt(0.0125))
    assert error["median"] == pytest.approx(0.15)
    assert error["p95"] == pytest.approx(0.285)


def test_rows_without_a_position_match_nobody_on_the_floor() -> None:
    truth = table([(0, 1, 0, 0), (0, 2, math.nan, math.nan)])
    result = table([(0, 1, 0, 0), (0, 2, math.nan, math.nan)])
    found = numbers(truth, result, FloorMatch())
    assert (found["misses"], found["false_positives"]) == (1, 1)


@pytest.mark.parametrize("match", [FloorMatch(), BoxMatch()], ids=["floor", "box"])
def test_a_side_without_what_is_matched_is_refused(match: Match) -> None:
    nowhere, somewhere = table([(0, 1, math.nan, math.nan)]), table([(0, 1, 0, 0)])
    with pytest.raises(FormatError, match="the ground truth has no"):
        score(nowhere, somewhere, match)
    with pytest.raises(FormatError, match="the result has no"):
        score(somewhere, nowhere, match)


@pytest.mark.parametrize("wrong", [0.0, -1.0, math.nan, math.inf])
def test_impossible_limits_are_refused(wrong: float) -> None:
    with pytest.raises(SettingsError):
        FloorMatch(wrong)
    with pytest.raises(SettingsError):
        BoxMatch(wrong)


def test_an_id_twice_in_a_frame_is_refused() -> None:
    with pytest.raises(FormatError, match="track 4 stands twice in frame 2"):
        table([(2, 4, 0, 0), (2, 4, 9, 9)])


def test_people_read_a_table() -> None:
    text = score(table(standing(1, range(20))), table([])).as_text()
    assert "MOTA" in text
    assert "tracking_accuracy" in text
    assert len({line.split("  ")[0] for line in text.splitlines()}) == len(text.splitlines())


def test_many_ids_of_one_frame_each_take_little_memory() -> None:
    """A matrix of all people by all tracks would be of 8 MB, several times."""
    frames = np.arange(1_000)
    columns = {"frame": frames, "track": frames + 1, "confidence": np.full(len(frames), 0.5)}
    columns |= dict.fromkeys(("left", "top", "width", "height"), np.full(len(frames), 9.0))
    table = ScoringTable.from_columns(columns)
    tracemalloc.start()
    try:
        found = score(table, table)
        assert tracemalloc.get_traced_memory()[1] < 7e6
    finally:
        tracemalloc.stop()
    assert found.identity.true_positives == 1_000
    assert found.track_map is not None
    assert found.track_map.ap == 1.0


def test_a_frame_with_more_rows_than_can_be_compared_is_refused() -> None:
    rows = np.arange(5000)
    columns = {"frame": np.full(len(rows), 3), "track": rows + 1}
    columns |= dict.fromkeys(("left", "top", "width", "height"), np.full(len(rows), 9.0))
    table = ScoringTable.from_columns(columns)
    with pytest.raises(FormatError, match=r"frame 3 \(from 0\) has 5,000 rows in the ground truth"):
        score(table, table)
