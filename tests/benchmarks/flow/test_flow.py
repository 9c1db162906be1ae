"""What the benchmark of flow says of counts that are known."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.benchmarks.clips import Columns
from tests.benchmarks.flow.__main__ import PAGE, REPORTED, SCENES, TUNED, counts_picture
from tests.benchmarks.flow.counts import (
    hits_of,
    people_inside,
    where_counted,
)

FPS = 10.0


def _walks(starts: dict[int, int], step_m: float = 0.2) -> Columns:
    """People who walk away through the passage, from 4 m on, setting off in these frames."""
    rows = [
        (start + k, person, 0.0, 4.1 + step_m * k)
        for person, start in starts.items()
        for k in range(40)
    ]
    table = np.array(sorted(rows))
    return {
        "frame": table[:, 0].astype(np.int64),
        "track": table[:, 1].astype(np.int64),
        "x": table[:, 2],
        "y": table[:, 3],
    }


@pytest.mark.parametrize("scene", SCENES)
def test_lines_lie_across_the_region_and_forward_is_away_from_the_camera(
    scene: str,
) -> None:
    walks, (lines, region) = _walks({1: 0}), where_counted(scene)
    hits = hits_of(walks, walks, FPS, lines)
    assert (hits.happened, hits.hit) == (3, 3)
    inside = people_inside(walks, FPS, 40, region)
    assert inside.tolist() == [0, 1, 1, 1, 1, 0, 0, 0][: len(inside)]


def test_tuning_and_reporting_look_at_different_clips() -> None:
    assert {clip.seed for clip in TUNED} == {5101}
    assert {clip.seed // 100 for clip in REPORTED} == {52}


def test_a_passage_counted_too_late_is_no_hit() -> None:
    lines, _ = where_counted(SCENES[0])
    hits = hits_of(_walks({1: 15}), _walks({1: 0}), FPS, lines)
    assert (hits.happened, hits.found, hits.hit) == (3, 3, 0)


def _row(counted: int, hit: int) -> dict[str, Any]:
    return {
        "scene": "lane",
        "seed": 1,
        "tracker": "flow",
        "true_sum": 200,
        "seen_sum": 190,
        "sum": counted,
        "most": 9,
        "mean_difference": 0.4,
        "stretches": [(120, 118), (80, 88)],
        "true_steps": [1, 2, 3],
        "steps": [1, 2, 2],
        "happened": 100,
        "found": 99,
        "hit": hit,
    }


def test_the_page_says_whether_sums_and_passages_meet_their_goals() -> None:
    page = PAGE.sections({"scenes": [_row(206, 94)]})["scenes"]
    assert "| lane: sum off, % | 5 | 3.0 | met |" in page
    assert "| lane: passages hit, % | 95 | 94.0 | missed by 1.0 |" in page
    assert "| lane: paper |  |  | 963 | 1057 | +9.8 % |" in page
    assert "| lane 1, 20 to 40 s | 80 | 88 | +10.0 % |" in page


def test_the_picture_has_a_panel_for_each_clip() -> None:
    drawn = counts_picture([_row(206, 94), {**_row(1, 1), "tracker": "spheroid"}])
    assert drawn.count(">lane 1<") == 1
