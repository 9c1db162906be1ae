"""The page of spheroids, made of figures."""

from __future__ import annotations

from typing import Any

from tests.benchmarks.spheroid import report
from tracking.synthesis.marks import MARKS_M


def _spots(mean_cm: float | None, *names: str) -> dict[str, Any]:
    told = {"mean_cm": mean_cm, "std_cm": 1.0, "followed": 0.98, "frames": 78, "across_cm": 3.0}
    return dict.fromkeys((*names, "all"), told)


def _marks(alone_cm: float) -> dict[str, Any]:
    return {
        "clips": 2,
        "standing": _spots(alone_cm, *MARKS_M),
        "pairs": _spots(9.0, *MARKS_M),
        "walking": _spots(4.0, "A1-B1", "B1-C1"),
    }


def test_goals_on_the_marks_are_told_as_met_or_by_how_much_they_are_missed() -> None:
    page = report.writers()["marks"](_marks(4.2))
    assert "| standing | 5 | 4.2 | 98 % | met |" in page
    assert "| pairs | 8 | 9.0 | 98 % | missed by 1.0 |" in page
    assert "| A1 | 5 | 4.2 ± 1.0 | 98 % | 8 | 9.0 ± 1.0 | 98 % |" in page


def test_a_small_error_of_few_frames_meets_no_goal() -> None:
    figures = _marks(4.2)
    figures["standing"]["all"] = {"mean_cm": 3.0, "std_cm": 1.0, "followed": 0.6, "frames": 9}
    page = report.writers()["marks"](figures)
    assert "| standing | 5 | 3.0 | 60 % | missed: people are lost |" in page


def test_a_mark_where_nobody_is_followed_has_no_error() -> None:
    figures = _marks(4.2)
    figures["standing"]["D1"] = {"mean_cm": None, "std_cm": None, "followed": 0.0, "frames": 9}
    assert "| D1 | 13 | - | 0 % |" in report.writers()["marks"](figures)


def _situation(difficulty: int, swapped: int, seed: int) -> dict[str, Any]:
    row = {"scene": f"situation-{difficulty}", "seed": seed, "title": "cross", "people": 2}
    return {**row, "difficulty": difficulty, "swapped": swapped, "renamed": 0, "missed": 0}


def test_situations_of_several_seeds_are_added_and_easy_swaps_are_told() -> None:
    rows = [_situation(2, 0, 1), _situation(2, 2, 2), _situation(5, 1, 1)]
    page = report.writers()["situations"](rows)
    assert "| cross | 2 | 4 | 2 | 0 | 0 |" in page
    assert "rated up to 3: 2 tracks swapped there" in page
    assert "nobody swapped there" in report.writers()["situations"]([_situation(4, 2, 1)])


def test_scores_of_real_footage_stand_beside_their_goals() -> None:
    row = {"recording": "pets", "tracker": "spheroid", "MOTA": 0.8, "IDF1": 0.81, "HOTA": 0.5}
    more = {"id_switches": 3, "error_cm": 21.0, "kept": 9, "detected": 10}
    page = report.writers()["real"]([{**row, **more}, {"recording": "pets", "tracker": "other"}])
    assert "| MOTA | 0.85 | 0.800 | missed by 0.050 |" in page
    assert "| IDF1 | 0.80 | 0.810 | met |" in page
    assert "says no floor positions" in page


def test_ghosts_and_what_users_are_told_stand_by_disturbance() -> None:
    row = {"recording": "plaza", "MOTA": 0.9, "IDF1": 0.91, "ghosts": 1, "longest_s": 6.24}
    figures = {"camera knocked": [{**row, "notes": ["the camera moved"]}]}
    page = report.writers()["robustness"](figures)
    assert "| camera knocked | plaza | 0.900 | 0.910 | 1 | 6.2 |" in page
    assert "- plaza: the camera moved" in page
