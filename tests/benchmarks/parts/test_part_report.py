"""The report on body parts: pictures, tables, and what is counted for them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from defusedxml import ElementTree

from tests.benchmarks.parts import report
from tests.benchmarks.parts.clips import (
    CHECKED,
    REPORTED,
    REPORTED_CROUCHING,
    REPORTED_ELSEWHERE,
    TRAINED,
    TUNED,
    TUNED_CROUCHING,
    Clip,
)
from tests.benchmarks.parts.detector import resized
from tests.benchmarks.parts.postures import stoops_in
from tests.benchmarks.parts.real import kept_parts, truth_of_boxes
from tracking.failure import SAMPLE_COLUMNS, Samples
from tracking.pages import Panel, svg
from tracking.scoring.parts import Judged

NAMESPACE = "{http://www.w3.org/2000/svg}"


def _variant(share: float, frames: int = 151, people: int = 40) -> dict[str, Any]:
    return {
        "judged": people,
        "never_tracked": 0,
        "people": [people] * frames,
        "right": [[share] * 4] * frames,
        "unbroken": [[share / 2] * 4] * frames,
        "foreign": [0.1, 0.2, 0.3],
    }


FIGURES = {
    "clips": ["walkway 1", "walkway 2"],
    "variants": {
        "with adjustment": _variant(0.98),
        "without adjustment": _variant(0.9),
        "joint": _variant(0.95),
        "whole body": _variant(0.8),
    },
}


def _judged(parts: np.ndarray, first_frame: int = 0, person: int = 1) -> Judged:
    return Judged(person, 5, first_frame, parts, parts.any(axis=1), np.zeros(parts.shape))


def test_no_clip_is_used_for_two_purposes() -> None:
    reported = (REPORTED, REPORTED_CROUCHING, REPORTED_ELSEWHERE)
    groups = (*reported, TRAINED, CHECKED, TUNED, TUNED_CROUCHING)
    clips = [clip for group in groups for clip in group]
    assert len(set(clips)) == len(clips)
    assert all(4300 <= clip.seed < 4400 for group in reported for clip in group)
    assert all(4100 <= clip.seed < 4200 for clip in (*TRAINED, *CHECKED, *TUNED))


def test_a_picture_is_well_formed_and_has_a_line_for_each_curve() -> None:
    x = np.arange(4.0)
    curves = {"one": np.array([1.0, 0.5, np.nan, 0.2]), "two": np.ones(4)}
    panel = Panel("Heads", curves, x, ("frames", "share"), (0.0, 3.0), (0.0, 1.0))
    root = ElementTree.fromstring(svg([panel, panel]))
    paths = root.findall(f".//{NAMESPACE}path")
    assert len(paths) == 4
    assert paths[0].get("d", "").count("M") == 2  # the gap lifts the pen
    texts = [text.text for text in root.iter(f"{NAMESPACE}text")]
    assert {"one", "two", "Heads", "frames", "share"} <= set(texts)


def test_the_picture_of_rates_leaves_out_what_too_few_people_say() -> None:
    few = {"clips": [], "variants": {"with adjustment": _variant(0.5, people=3)}}
    assert 'd=""' in report.rates_picture(few)
    assert 'd=""' not in report.rates_picture(FIGURES)


def test_goals_are_said_to_be_met_or_by_how_much_they_are_missed() -> None:
    page = report.results({"rates": FIGURES})
    assert "| head | 97 | 98.0 | met | +8.0 | short by 7.0 |" in page
    assert "| with adjustment, paper | 95 | 83 | 91 | 95 | 72 at the start |" in page
    assert "Real footage" not in page


def test_zones_of_a_true_box_stand_for_its_parts() -> None:
    columns = {
        "frame": np.array([3]),
        "track": np.array([8]),
        "left": np.array([10.0]),
        "top": np.array([20.0]),
        "width": np.array([30.0]),
        "height": np.array([100.0]),
    }
    truth = truth_of_boxes(columns, (200, 200))
    assert truth.parts.tolist() == [
        [[10.0, 20.0, 40.0, 45.0], [10.0, 30.0, 40.0, 80.0], [10.0, 60.0, 40.0, 120.0]]
    ]
    assert truth.people.tolist() == [[10.0, 20.0, 40.0, 120.0]]
    assert (truth.frame.tolist(), truth.visibility.tolist()) == ([3], [1.0])


def test_parts_are_kept_by_who_has_all_three_at_the_end_and_nearly_always() -> None:
    good = np.ones((120, 3), bool)
    late = good.copy()
    late[:30, 0] = False
    lost = good.copy()
    lost[90:, 2] = False
    kept = kept_parts([_judged(good), _judged(late), _judged(lost), _judged(good[:50])])
    assert (kept["people"], kept["in_view"]) == (4, 3)
    assert (kept["at_end"], kept["throughout"]) == (3, 2)
    assert kept["parts"] == [4, 4, 3]


def test_a_stoop_counts_for_people_judged_before_and_after_it() -> None:
    clip = Clip("crouching", 4102)
    cast = clip.cast()
    person, walk, stoops = next(
        (i, walk, stoops)
        for i, (walk, stoops) in enumerate(zip(cast.walks, cast.stoops, strict=True))
        if walk is not None and stoops is not None and stoops.crouch.any()
    )
    down = np.flatnonzero(stoops.crouch > 0.05)
    up = walk.first_frame + int(down[-1]) + 1
    frames = walk.first_frame + len(walk.position)
    parts = np.ones((frames, 3), bool)
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
    sizes = resized(Samples(columns, np.ones((6, 36))), np.random.default_rng(1)).features
    assert len(np.unique(sizes[:3])) == len(np.unique(sizes[3:])) == 1
    assert sizes[0, 0] != sizes[3, 0]
    assert 0.4 <= sizes.min() <= sizes.max() <= 2.5
