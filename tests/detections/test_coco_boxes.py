"""Detections as COCO's results, and as a data set with images and categories."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tracking.detections import DetectionsFile, Footage, coco_boxes, read_detections
from tracking.errors import FormatError

FOOTAGE = Footage(600, (640, 480))
NAMED = Footage(3, (640, 480), ("a", "b", "c"))


def read(folder: Path, held: Any, footage: Footage = FOOTAGE) -> DetectionsFile:
    path = folder / "boxes"
    path.write_text(json.dumps(held), encoding="utf-8")
    return read_detections(path, footage)


def result(image: Any, score: Any = 0.5, kind: int = 1, box: Any = (10, 20, 30, 40)) -> dict:
    return {"image_id": image, "category_id": kind, "bbox": box, "score": score}


@pytest.mark.parametrize(("ids", "frames"), [((1, 2, 5), [0, 1, 4]), ((5, 0, 2), [0, 2, 5])])
def test_results_count_images_from_1_unless_there_is_a_0_and_say_so(tmp_path, ids, frames) -> None:
    file = read(tmp_path, [result(number) for number in ids])
    assert file.format == "coco"
    assert file.table.frame.tolist() == frames
    assert file.table.box.tolist() == [[10, 20, 30, 40]] * 3
    assert "is frame 0" in file.notes[0]


def test_categories_without_names_are_cocos_and_only_the_first_is_people(tmp_path) -> None:
    file = read(tmp_path, [result(1, kind=3), result(1, kind=1), result(2, kind=44)])
    assert len(file.table) == 1
    assert any("taken for people" in note for note in file.notes)


def data_set(images: list[dict], annotations: list[dict], names: tuple[str, ...]) -> dict:
    kinds = [{"id": k + 1, "name": name} for k, name in enumerate(names)]
    return {"images": images, "annotations": annotations, "categories": kinds}


def test_of_a_data_set_only_people_are_read(tmp_path) -> None:
    rows = [result(7, kind=1), result(7, 0.9, kind=2), {**result(7, kind=2), "iscrowd": 1}]
    images = [{"id": 7, "frame_index": 4}]
    file = read(tmp_path, data_set(images, rows, ("bicycle", "Person")))
    assert file.table.frame.tolist() == [4]
    assert file.table.score.tolist() == [0.9]


def test_a_box_of_an_image_that_is_not_listed_is_told_as_such(tmp_path) -> None:
    images = [{"id": 7, "frame_index": 4}]
    file = read(tmp_path, data_set(images, [result(7), result(8)], ("person",)))
    assert file.table.frame.tolist() == [4]
    assert "annotations[1]: its image tells no frame: it is not listed" in file.notes[0]


def test_a_data_set_without_people_is_refused(tmp_path) -> None:
    held = data_set([{"id": 1}], [result(1)], ("car", "dog"))
    with pytest.raises(FormatError, match="none of its categories is person"):
        read(tmp_path, held)


@pytest.mark.parametrize(
    ("names", "footage", "frames"),
    [
        (("img/c.png", "img/a.png"), NAMED, [0, 2]),
        (("v_0003.jpg", "v_0001.jpg"), FOOTAGE, [0, 2]),
        (("v_0003.jpg", "v_0000.jpg"), FOOTAGE, [0, 3]),
        (("", ""), FOOTAGE, [10, 11]),
    ],
)
def test_images_are_frames_by_their_names_else_by_their_numbers(
    tmp_path, names, footage, frames
) -> None:
    images = [{"id": 11 + k, "file_name": name} for k, name in enumerate(names)]
    held = data_set(images, [result(11), result(12)], ("person",))
    assert read(tmp_path, held, footage).table.frame.tolist() == frames


def test_boxes_of_images_of_another_size_are_scaled_and_that_is_told(tmp_path) -> None:
    images = [{"id": 1, "frame_index": 0, "width": 1280, "height": 1920}]
    file = read(tmp_path, data_set(images, [result(1)], ("person",)))
    assert file.table.box.tolist() == [[5, 5, 15, 10]]
    assert "its boxes are scaled" in file.notes[0]


@pytest.mark.parametrize(
    "bad",
    [
        result("x"),
        result(1, box=[1, 2, 3]),
        result(1, box=[1, 2, "3", 4]),
        result(1, box=[1, 2, -3, 4]),
        result(1, box=[1, 2, 1e300, 4]),
        result(1, box=[1, 2, float("nan"), 4]),
        result(99999999),
        "text",
    ],
)
def test_what_is_no_box_is_left_out_and_told(tmp_path, bad) -> None:
    file = read(tmp_path, [result(1), bad, result(2)])
    assert file.table.frame.tolist() == [0, 1]
    assert any("1 box cannot be used, the first in annotations[1]" in note for note in file.notes)


def test_more_elements_than_a_member_may_have_are_refused(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(coco_boxes, "_MOST_CATEGORIES", 1)
    with pytest.raises(FormatError, match="more than 1 categories; split it first"):
        read(tmp_path, data_set([{"id": 1}], [result(1)], ("person", "dog")))


@pytest.mark.parametrize(
    "text", ['[{"image_id": 1, "bbox": [1', "[]", "{}", '[{"x": 1}]', "[" * 9999]
)
def test_json_that_is_cut_short_or_something_else_is_refused_in_one_line(tmp_path, text) -> None:
    path = tmp_path / "boxes"
    path.write_text(text)
    with pytest.raises(FormatError) as error:
        read_detections(path, FOOTAGE)
    assert "\n" not in str(error.value)
    assert str(path) in str(error.value)
