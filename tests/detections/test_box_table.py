"""Which boxes of a detector are used: a threshold learnt from its scores, one box a person."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from tracking.detections import (
    BoxTable,
    DetectionSettings,
    DetectionsFile,
    RecordingDetections,
    learnt_threshold,
)
from tracking.detections.table import suppress_overlaps
from tracking.errors import SettingsError
from tracking.people.detection_source import MOST_BOXES, FrameDetections


def boxes(*rows: tuple[float, ...]) -> FrameDetections:
    """Left, top, width, height, score each."""
    table = np.array(rows, np.float64).reshape(-1, 5)
    return FrameDetections(table[:, :4], table[:, 4])


def table(frame: list[int], score: list[float]) -> BoxTable:
    box = np.array([[100.0 * k, 0.0, 20.0, 50.0] for k in range(len(frame))]).reshape(-1, 4)
    return BoxTable.sorted_by_frame(np.array(frame, np.int64), box, np.array(score))


def test_boxes_whose_middle_is_not_looked_at_are_not_used() -> None:
    looked_at = np.zeros((60, 400), np.uint8)
    looked_at[:, 100:200] = 255
    four = table([0, 0, 0, 0], [0.9] * 4)
    off = BoxTable(four.frame, four.box - (0.0, 300.0, 0.0, 0.0), four.score)
    assert four.in_region(looked_at).box[:, 0].tolist() == [100.0]
    assert len(off.in_region(looked_at)) == 0
    assert len(four.in_region(None)) == 4
    file = DetectionsFile(Path("left.txt"), "mot", "MOTChallenge text", "0" * 64, four, ())
    used = RecordingDetections(file, settings=DetectionSettings(), looked_at=looked_at)
    assert used.of(0).box[:, 0].tolist() == [100.0]
    nothing = np.zeros_like(looked_at)
    none = RecordingDetections(file, settings=DetectionSettings(), looked_at=nothing)
    assert none.unused
    assert none.notes[-1] == "warning: no box of left.txt is in the region"


def test_the_threshold_lies_between_two_kinds_of_scores_whatever_their_unit() -> None:
    rng = np.random.default_rng(1)
    sure, unsure = rng.normal(0.9, 0.03, 700), rng.normal(0.2, 0.03, 300)
    for unit, start in ((1.0, 0.0), (40.0, -25.0)):
        scores = start + unit * np.concatenate((sure, unsure))
        least = learnt_threshold(rng.permutation(scores))
        assert least == start + unit * sure.min()


@pytest.mark.parametrize(
    "scores",
    [
        [0.7] * 5,
        [0.3],
        list(np.random.default_rng(2).normal(0.8, 0.1, 500)),
        list(np.linspace(0.2, 0.9, 80)),
        list(np.random.default_rng(3).uniform(0.0, 1.0, 40)),
    ],
)
def test_scores_of_one_kind_are_all_used(scores: list[float]) -> None:
    assert learnt_threshold(np.array(scores)) == min(scores)


def test_no_scores_have_no_threshold() -> None:
    assert learnt_threshold(np.zeros(0)) == -np.inf


@given(arrays(np.float64, st.integers(1, 60), elements=st.floats(-1e6, 1e6)))
def test_at_least_half_of_the_boxes_are_used_and_one_always(scores: np.ndarray) -> None:
    kept = scores >= learnt_threshold(scores)
    assert kept.sum() * 2 >= len(scores)


def test_boxes_are_found_by_frame_in_the_order_of_the_file() -> None:
    held = table([3, 0, 3, 1], [0.1, 0.2, 0.3, 0.4])
    assert held.of(3).score.tolist() == [0.1, 0.3]
    assert len(held.of(2)) == 0
    assert held.of(2).box.shape == (0, 4)


def test_of_two_boxes_on_one_person_the_surer_one_stays() -> None:
    kept = suppress_overlaps(
        boxes((10, 10, 20, 60, 0.5), (12, 11, 20, 60, 0.9), (90, 0, 20, 60, 0.4)), 0.65
    )
    assert kept.score.tolist() == [0.9, 0.4]


@pytest.mark.parametrize(
    ("inner", "max_overlap", "scores"),
    [
        ((10, 50, 20, 48), 0.65, [0.9]),
        ((10, 10, 20, 60), 0.65, [0.9, 0.8]),  # feet farther up: somebody behind
        ((10, 50, 20, 48), 1.0, [0.9, 0.8]),
    ],
)
def test_a_box_inside_a_surer_one_is_of_the_same_person_if_their_feet_are(
    inner, max_overlap, scores
) -> None:
    kept = suppress_overlaps(boxes((0, 0, 50, 100, 0.9), (*inner, 0.8)), max_overlap)
    assert kept.score.tolist() == scores


def test_a_box_dropped_for_a_surer_one_drops_no_other() -> None:
    row = boxes((0, 0, 20, 60, 0.9), (5, 0, 20, 60, 0.8), (10, 0, 20, 60, 0.7))
    assert suppress_overlaps(row, 0.5).score.tolist() == [0.9, 0.7]


def test_neighbours_keep_their_boxes() -> None:
    assert len(suppress_overlaps(boxes((0, 0, 20, 60, 0.9), (8, 0, 20, 60, 0.8)), 0.65)) == 2


def test_a_frame_gives_its_surest_boxes_and_not_too_many() -> None:
    rows = [(30.0 * k, 0, 20, 60, k / 1000) for k in range(3 * MOST_BOXES)]
    kept = suppress_overlaps(boxes(*rows), 0.65)
    assert len(kept) == MOST_BOXES
    assert kept.score.min() == 2 * MOST_BOXES / 1000


def test_boxes_given_are_sure_and_of_the_camera_asked_for() -> None:
    left, right = (
        DetectionsFile(Path(f"{name}.txt"), "mot", "MOTChallenge text", name, held, ())
        for name, held in (
            ("left", table([0, 0, 1], [0.9, 0.1, 0.8])),
            ("right", table([0], [0.7])),
        )
    )
    settings = DetectionSettings(file="det.txt", use="only", min_score="0.5")
    detections = RecordingDetections(left, right, settings=settings)
    assert detections.detections_only
    assert detections.of(0).score.tolist() == [0.9]
    found = detections.of_right(0)
    assert found is not None
    assert found.score.tolist() == [0.7]
    assert [one.camera for one in detections.inputs] == ["left", "right"]
    assert [one.count for one in detections.inputs] == [3, 1]
    assert "2 of 3 boxes are used, those with a score from 0.8 on" in detections.notes[0]
    assert RecordingDetections(left, settings=DetectionSettings()).of_right(0) is None
    assert not detections.unused
    none = RecordingDetections(left, right, settings=replace(settings, min_score="0.95"))
    assert none.unused
    assert none.notes[0] == (
        "warning: none of the 3 boxes of left.txt (MOTChallenge text) is used; lower "
        "detections.min_score"
    )


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"use": "instead"}, "must be beside or only"),
        ({"min_score": "high"}, "must be a number or auto"),
        ({"min_score": "nan"}, "must be a number or auto"),
        ({"file_right": "det.txt"}, "detections.file"),
        ({"use": "only"}, "detections.use=only: there are no detections"),
    ],
)
def test_settings_that_make_no_sense_are_refused_by_name(values: dict[str, str], said: str) -> None:
    with pytest.raises(SettingsError, match=r"setting detections\.") as error:
        DetectionSettings(**values)
    assert said in str(error.value)
