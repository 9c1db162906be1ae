"""How sure a tracker was, in files that scorers read."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from made_tracks import table, through

from tracking.formats import FORMATS, Exported, Filmed, no_progress
from tracking.tracks import TrackLabel

SURE = [0.59, 0.0, 1.0, np.nan]
BOXES = [(5.0, 5.0, 20.0, 40.0)] * len(SURE)
SCORED = ["mot", "mot16", "kitti", "coco"]


def tracks(**known: bool) -> Exported:
    made = table([(frame, 1) for frame in range(len(SURE))], BOXES).columns()
    rows = {**made, "confidence": np.array(SURE, np.float32)}
    return Exported(rows, None, len(SURE), **known)


@pytest.mark.parametrize("name", SCORED)
@pytest.mark.parametrize("corrected", [True, False])
def test_confidence_comes_back_from_results(tmp_path: Path, name: str, corrected: bool) -> None:
    found = through(FORMATS[name], tmp_path / "out", tracks(corrected=corrected)).columns
    np.testing.assert_allclose(found["confidence"], SURE, atol=2e-6)


@pytest.mark.parametrize("name", [*SCORED, "viame", "x-anylabeling"])
def test_confidence_comes_back_to_the_last_bit(tmp_path: Path, name: str) -> None:
    places = [(frame, 1) for frame in range(500)]
    made = table(places, [BOXES[0]] * len(places)).columns()
    sure = np.random.default_rng(4).random(len(places), np.float32)
    exported = Exported({**made, "confidence": sure}, None, len(places), size_px=(640, 480))
    kind, path = FORMATS[name], tmp_path / "out"
    assert kind.write is not None
    assert kind.read is not None
    kind.write(path, exported, no_progress)
    np.testing.assert_array_equal(kind.read(path, Filmed()).columns["confidence"], sure)


@pytest.mark.parametrize("name", SCORED)
def test_a_row_that_counts_is_never_a_dont_care_when_read_as_ground_truth(
    tmp_path: Path, name: str
) -> None:
    found = through(FORMATS[name], tmp_path / "out", tracks()).columns
    assert (found["confidence"] != 0).all()


@pytest.mark.parametrize("name", ["mot", "mot16"])
def test_conf_of_ground_truth_says_whether_a_row_counts(tmp_path: Path, name: str) -> None:
    (tmp_path / "gt").mkdir()
    kind = FORMATS[name]
    for number, known in enumerate(({}, {"dont_cares": True})):
        expected = [1, 1 - number, 1, 1]
        for path, told in (("gt/gt.txt", {}), ("any.txt", {"ground_truth": True})):
            found = through(kind, tmp_path / path, tracks(**known, **told)).columns
            assert found["confidence"].tolist() == expected


def test_ground_truth_of_kitti_has_no_score_and_marks_what_does_not_count(tmp_path: Path) -> None:
    through(FORMATS["kitti"], tmp_path / "truth.txt", tracks(dont_cares=True))
    rows = [line.split() for line in (tmp_path / "truth.txt").read_text().splitlines()]
    assert {len(row) for row in rows} == {17}
    # Scorers count who is truncated 0 and occluded 0 to 2.
    assert [row[3:5] for row in rows] == [["0", "0"], ["0", "3"], ["0", "0"], ["0", "0"]]


def test_nobody_who_reaches_over_the_picture_s_edge_is_left_out_by_scorers(tmp_path: Path) -> None:
    boxes = [(-5.0, -5.0, 20.0, 40.0), (630.0, 470.0, 20.0, 40.0)]
    exported = Exported.of_table(table([(0, 1), (0, 2)], boxes), size_px=(640, 480))
    through(FORMATS["kitti"], tmp_path / "0000.txt", exported)
    rows = [line.split() for line in (tmp_path / "0000.txt").read_text().splitlines()]
    assert [row[3] for row in rows] == ["0", "0"]


def test_of_ground_truth_of_mot16_only_people_count(tmp_path: Path) -> None:
    made = table([(0, 1), (0, 2), (0, 3)], BOXES[:3]).columns()
    rows = {**made, "confidence": np.full(3, 0.5, np.float32)}
    # MOTChallenge has a number for cars, and none for dogs.
    labels = {
        track: TrackLabel(attributes={"class": kind}) for track, kind in ((2, "car"), (3, "dog"))
    }
    for told, expected in ((True, [1, 0, 0]), (False, [0.5, 0.5, 0.5])):
        exported = Exported(rows, None, 1, labels=labels, ground_truth=told)
        found = through(FORMATS["mot16"], tmp_path / "out.txt", exported)
        assert found.columns["confidence"].tolist() == expected


def test_coco_says_apart_how_sure_a_tracker_was_and_what_counts(tmp_path: Path) -> None:
    through(FORMATS["coco"], tmp_path / "t.json", tracks(corrected=True, dont_cares=True))
    rows = json.loads((tmp_path / "t.json").read_text())["annotations"]
    assert [row.get("score") for row in rows] == [0.59, 0, 1, None]
    assert [row["iscrowd"] for row in rows] == [0, 1, 0, 0]
    assert [row["attributes"]["track_id"] for row in rows] == [1] * len(SURE)
