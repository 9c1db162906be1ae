"""Areas under the curve of people nobody labelled, with their intervals."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.parts.loop import right_change
from tests.benchmarks.parts.loop_areas import DETECTORS, areas_held_out
from tracking.failure import Samples
from tracking.failure.core.features import PAPER_FEATURES

sys.path.insert(0, str(Path(__file__).parents[2] / "failure"))

from made_up_parts import made_up_samples


@pytest.fixture(scope="module")
def samples() -> Samples:
    """Ten people, with evidence that says clearly where a part is lost."""
    made = made_up_samples(3, people=10, every=6)
    features = made.features.copy()
    random = np.random.default_rng(4)
    evidence = random.normal(0.9, 0.05, (len(made), 3, 8))
    lost = made.columns["label"] == 0
    evidence[lost, made.columns["part"][lost], :4] = random.normal(0.1, 0.05, (lost.sum(), 4))
    features[:, PAPER_FEATURES:] = evidence.reshape(len(made), -1)
    return Samples(made.columns, features)


def test_a_group_teaches_a_detector_that_all_others_judge(samples: Samples) -> None:
    each = areas_held_out(samples, 5, 0)
    for areas in each:
        assert areas is not None
        assert set(areas) == {*DETECTORS, "gain"}
        assert all(low <= mean <= high for mean, low, high in areas.values())
        assert areas["gain"][0] == pytest.approx(
            areas["taught"][0] - areas["built in"][0], abs=2e-3
        )
        assert areas["taught"][0] > 0.9


def test_a_part_that_is_never_lost_has_no_area(samples: Samples) -> None:
    on = samples[samples.columns["label"] == 1]
    assert areas_held_out(on, 5, 0) == [None, None, None]


def test_moments_without_evidence_are_not_asked_about(samples: Samples) -> None:
    unknown = samples.features.copy()
    unknown[:, PAPER_FEATURES:] = np.nan
    assert areas_held_out(Samples(samples.columns, unknown), 5, 0) == [None, None, None]


def test_a_change_of_rates_is_of_all_frames_and_its_interval_of_people() -> None:
    before = np.array([[5.0, 5, 5, 5, 10]] * 4)
    better = before + np.array([5.0, 0.0, 0.0, 0.0, 0.0])
    same, other = right_change(before, before), right_change(better, before)
    assert same == [[0.5, 0.0, 0.0]] * 4
    assert other == [[1.0, 0.5, 0.5], *[[0.5, 0.0, 0.0]] * 3]
