"""Body parts: clips for one purpose each, what is counted, the diagrams."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks.clips import Clip
from tests.benchmarks.parts.__main__ import PAGE, rates_picture
from tests.benchmarks.parts.clips import (
    CHECKED,
    REPORTED,
    REPORTED_CROUCHING,
    REPORTED_ELSEWHERE,
    TRAINED,
    TRAINED_PAPER,
    TUNED,
    TUNED_CROUCHING,
)
from tests.benchmarks.parts.detector import resized
from tests.benchmarks.parts.loop import parts_of_boxes
from tests.benchmarks.parts.measures import cast_of, stoops_in
from tracking.failure import SAMPLE_COLUMNS, Samples
from tracking.scoring.parts import Judged


def _variant(share: float, people: int = 40) -> dict[str, Any]:
    return {
        "people": [people] * 151,
        "right": [[share] * 4] * 151,
        "unbroken": [[share / 2] * 4] * 151,
        "foreign": [0.1, 0.2, 0.3],
    }


def _rates(**variants: dict[str, Any]) -> dict[str, Any]:
    named = {name.replace("_", " "): variant for name, variant in variants.items()}
    return {"clips": ["walkway 1", "walkway 2"], "variants": named}


def _judged(parts: np.ndarray, first_frame: int = 0, person: int = 1) -> Judged:
    return Judged(person, 5, first_frame, parts, parts.any(axis=1), np.zeros(parts.shape))


def test_no_clip_is_used_for_two_purposes() -> None:
    reported = (REPORTED, REPORTED_CROUCHING, REPORTED_ELSEWHERE)
    assert set(TRAINED) <= set(TRAINED_PAPER)
    groups = (*reported, TRAINED_PAPER, CHECKED, TUNED, TUNED_CROUCHING)
    clips = [clip for group in groups for clip in group]
    assert len(set(clips)) == len(clips)
    assert all(4300 <= clip.seed < 4400 for group in reported for clip in group)
    assert all(4100 <= clip.seed < 4200 for clip in (*TRAINED_PAPER, *CHECKED, *TUNED))
    assert {clip.fps for clip in clips} == {20.0}


def test_the_picture_of_rates_leaves_out_what_too_few_people_say() -> None:
    assert 'd=""' in rates_picture(_rates(with_adjustment=_variant(0.5, people=3)))
    assert 'd=""' not in rates_picture(_rates(with_adjustment=_variant(0.5)))


def test_goals_are_said_to_be_met_or_by_how_much_they_are_missed() -> None:
    rates = _rates(with_adjustment=_variant(0.98), without_adjustment=_variant(0.9))
    page = PAGE.text({"rates": rates})
    assert "| head | 97 | 98.0 | met | +8.0 | short by 7.0 |" in page
    assert "| with adjustment, paper | 95 | 83 | 91 | 95 | 72 at the start |" in page
    assert "crouch" not in page


def test_the_loop_s_figures_are_told_with_their_intervals() -> None:
    areas = dict.fromkeys(("paper", "built in", "taught"), (0.8, 0.7, 0.9))
    labels = {"all": [[9, 90]] * 3, "areas": [areas | {"gain": (0.0, -0.01, 0.02)}] * 2 + [None]}
    rates = {"before": [(0.5, 0.0, 0.0)] * 4, "taught": [(0.6, -0.01, 0.2)] * 4}
    one = {"recording": "yard", "labels": {"as tracked": labels}, "judged": 7, "rates": rates}
    page = PAGE.text({"taught": {"recordings": [one]}})
    assert "| yard | as tracked | head | 9 | 0.80 (0.70 to 0.90) |" in page
    assert "| +0.000 (-0.010 to +0.020) | missed |" in page
    assert "| hip-leg | 9 | - | - | - | - | - |" in page
    assert "| yard | 7 | before | 50.0 | 50.0 | 50.0 | 50.0 |" in page
    assert "|  |  | taught | 60.0 (-1.0 to +20.0) |" in page


def test_a_stoop_counts_for_people_judged_before_and_after_it() -> None:
    clip = Clip("crouching", 4102)
    cast = cast_of(clip)
    person, walk, stoops = next(
        (i, walk, stoops)
        for i, (walk, stoops) in enumerate(zip(cast.walks, cast.stoops, strict=True))
        if walk is not None and stoops is not None and stoops.crouch.any()
    )
    up = walk.first_frame + int(np.flatnonzero(stoops.crouch > 0.05)[-1]) + 1
    parts = np.ones((walk.first_frame + len(walk.position), 3), bool)
    parts[up - 5 : up + 8, 1] = False
    found = [s for s in stoops_in(clip, [_judged(parts, 0, person + 1)]) if not s.bent]
    assert found[-1].kept
    assert found[-1].recovered_s == pytest.approx(8 / 20)
    parts[up:] = False
    lost = [s for s in stoops_in(clip, [_judged(parts, 0, person + 1)]) if not s.bent]
    assert not lost[-1].kept
    assert lost[-1].recovered_s == np.inf


def test_one_person_s_samples_are_resized_alike() -> None:
    columns = {name: np.zeros(6, dtype) for name, dtype in SAMPLE_COLUMNS.items()}
    columns["recording"] = np.array(["a"] * 3 + ["b"] * 3, object)
    all_sizes = resized(Samples(columns, np.ones((6, 60))), np.random.default_rng(1)).features
    sizes = all_sizes[:, :36]
    assert (all_sizes[:, 36:] == 1.0).all()  # evidence is no length in pixels
    assert len(np.unique(sizes[:3])) == len(np.unique(sizes[3:])) == 1
    assert sizes[0, 0] != sizes[3, 0]
    assert 0.4 <= sizes.min() <= sizes.max() <= 2.5


def test_parts_of_boxes_are_shares_of_them(tmp_path: Path) -> None:
    truth = tmp_path / "truth.txt"
    truth.write_text("1,4,11,21,40,200,1,1,1\n2,4,11,21,40,200,0,1,1\n", encoding="utf-8")
    parts = parts_of_boxes(truth)
    assert parts.frame.tolist() == [0, 0, 0, 1, 1, 1]
    assert parts.part.tolist() == [0, 1, 2, 0, 1, 2]
    head, torso, legs = parts.box[:3]
    assert head == pytest.approx((10.0, 20.0, 40.0, 34.0))
    assert torso[1] < head[1] + head[3] < legs[1] + legs[3] == 220.0
    assert (parts.seen > 0).tolist() == [True] * 3 + [False] * 3
