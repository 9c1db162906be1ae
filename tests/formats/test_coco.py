"""COCO for video in and out."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, assert_same, known_rows, table, through, tracks

from tests.pace import spent
from tracking.errors import FormatError
from tracking.formats.coco import COCO, import_coco
from tracking.formats.read_result import Filmed
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackLabel, TrackTable

ONE_VIDEO: dict[str, Any] = {
    "videos": [{"id": 4, "name": "yard", "width": 640, "height": 480}],
    "images": [
        {"id": 9, "frame_index": 30, "video_id": 4},
        {"id": 3, "frame_index": 0, "video_id": 4},
    ],
    "categories": [{"id": 805, "name": "person"}, {"id": 95, "name": "bicycle"}],
    "tracks": [{"id": 7, "category_id": 805, "video_id": 4}],
    "annotations": [
        {"id": 1, "image_id": 9, "track_id": 7, "category_id": 805, "bbox": [4, 5, 6, 7]},
        {"id": 2, "image_id": 3, "track_id": 7, "category_id": 805, "bbox": [1.5, 2, 3, 4]},
        {"id": 3, "image_id": 3, "track_id": 2, "category_id": 95, "bbox": [0, 0, 9, 9]},
    ],
}


def written(folder: Path, **changed: Any) -> Path:
    path = folder / "tracks.json"
    path.write_text(json.dumps({**ONE_VIDEO, **changed}), encoding="utf-8")
    return path


def annotation(**changed: Any) -> list[dict[str, Any]]:
    return [*ONE_VIDEO["annotations"], {**ONE_VIDEO["annotations"][0], "track_id": 8, **changed}]


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_what_has_a_box_comes_back(tmp_path: Path, made: TrackTable) -> None:
    boxed = known_rows(made.columns(), "left")
    exported = Exported.of_table(made, frames=41, fps=12.5, size_px=(640, 480), name='a "b"')
    if not len(boxed["frame"]):
        with pytest.raises(FormatError, match="nobody has a box"):
            through(COCO, tmp_path / "t.json", exported)
        return
    back = through(COCO, tmp_path / "t.json", exported)
    assert_same(back.columns, boxed, BOX)
    assert np.isnan(back.columns["x"]).all()
    assert (back.fps, back.size_px, back.frames) == (12.5, (640, 480), 41)


def test_names_kinds_and_attributes_come_back(tmp_path: Path) -> None:
    made = table([(0, 1), (0, 4)], [(0, 0, 2, 2)] * 2)
    labels = {
        1: TrackLabel("red coat", {"bag": "yes"}),
        4: TrackLabel("", {"class": "bicycle"}),
    }
    back = through(COCO, tmp_path / "t.json", Exported.of_table(made, labels=labels))
    assert back.labels == labels


def test_what_does_not_count_is_a_crowd(tmp_path: Path) -> None:
    made = dict(table([(0, 1), (0, 2), (0, 3)], [(0, 0, 2, 2)] * 3).columns())
    made["confidence"] = np.array([0.0, 0.25, np.nan], np.float32)
    path = tmp_path / "t.json"
    back = through(COCO, path, Exported.of_table(TrackTable(made), dont_cares=True))
    rows = json.loads(path.read_text())["annotations"]
    assert [row["iscrowd"] for row in rows] == [1, 0, 0]
    assert back.columns["confidence"].tolist()[:2] == [0.0, 0.25]
    assert np.isnan(back.columns["confidence"][2])


def test_frames_are_those_of_the_images_and_kinds_those_of_the_categories(tmp_path: Path) -> None:
    found = import_coco(written(tmp_path), Filmed())
    assert found.columns["frame"].tolist() == [0, 0, 30]
    assert found.columns["track"].tolist() == [2, 7, 7]
    assert found.columns["left"].tolist() == [0, 1.5, 4]
    assert found.labels == {2: TrackLabel(attributes={"class": "bicycle"})}
    assert found.size_px == (640, 480)
    assert found.frames is None  # not every frame has an image
    assert found.bad_count == 0


def test_members_may_come_in_any_order(tmp_path: Path) -> None:
    path = tmp_path / "t.json"
    path.write_text(json.dumps(dict(reversed(ONE_VIDEO.items())), indent=1), encoding="utf-8")
    assert import_coco(path, Filmed()).columns["frame"].tolist() == [0, 0, 30]


def test_tracks_are_read_where_datumaro_and_cvat_write_them(tmp_path: Path) -> None:
    rows = annotation(track_id=None, attributes={"track_id": 8, "occluded": False})
    found = import_coco(written(tmp_path, annotations=rows), Filmed())
    assert found.columns["track"].tolist() == [2, 7, 7, 8]


def test_ids_from_zero_are_all_kept_but_zero(tmp_path: Path) -> None:
    found = import_coco(written(tmp_path, annotations=annotation(track_id=0)), Filmed())
    assert found.columns["track"].tolist() == [2, 7, 7, 8]
    assert (found.track_of_zero, found.notes) == (8, ())


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({"image_id": 77}, "no image"),
        ({"image_id": "a"}, "no whole number"),
        ({"track_id": 1.5}, "no whole number"),
        ({"track_id": 10**30}, "no whole number"),
        ({"track_id": -4}, "not a positive number"),
        ({"track_id": 7}, "stands twice"),
        ({"bbox": [1, 2, 3]}, "not four numbers"),
        ({"bbox": [1, 2, 3, None]}, "not four numbers"),
        ({"bbox": [1, 2, 3, 10**400]}, "not four numbers"),
        ({"bbox": [1, 2, 3, float("nan")]}, "not four numbers"),
        ({"bbox": [1, 2, 3, 1e400]}, "not four numbers"),
        ({"bbox": [1, 2, -3, 4]}, "negative size"),
        ({"bbox": [1e9, 2, 3, 4]}, "outside any image"),
    ],
)
def test_a_bad_row_is_told_by_its_place(
    tmp_path: Path, changed: dict[str, Any], reason: str
) -> None:
    found = import_coco(written(tmp_path, annotations=annotation(**changed)), Filmed())
    assert found.bad_count == 1
    assert found.bad_rows[0].place == "annotations[3]"
    assert reason in found.bad_rows[0].reason
    assert len(found.columns["frame"]) == 3


def test_images_of_impossible_frames_are_bad(tmp_path: Path) -> None:
    images = [*ONE_VIDEO["images"], {"id": 5, "frame_index": 10**12}, {"id": 6, "frame_index": -1}]
    found = import_coco(written(tmp_path, images=images), Filmed())
    assert [row.place for row in found.bad_rows] == ["images[2]", "images[3]"]


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({"videos": [{"id": 1}, {"id": 2}]}, "tracks of 2 videos"),
        ({"annotations": [{"id": 1, "image_id": 3, "bbox": [1, 2, 3, 4]}]}, "without track_id"),
    ],
)
def test_what_is_no_file_of_tracks_of_one_video_is_refused(
    tmp_path: Path, changed: dict[str, Any], reason: str
) -> None:
    with pytest.raises(FormatError, match=reason):
        import_coco(written(tmp_path, **changed), Filmed())


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{",
        '{"annotations": [',
        '{"annotations": [{}',
        '{"annotations": [{} {}]}',
        '{"annotations": [1,]}',
        "{1: 2}",
        '{"annotations" 1}',
        '{"annotations": ' + "[" * 200_000,
        '{"annotations": [' + '{"a":' * 200_000,
        '{"annotations": [' + "1" * 100_000 + "]}",
        '{"annotations": ["' + "a" * (5 << 20),
        '{"annotations": [' + " " * (20 << 20),
        '{"annotations": [' + '{"a":1} ,' * 200_000 + "{}]}",
        '{"other": [' + "1," * 200_000 + "1]}",
    ],
)
def test_bombs_and_broken_json_are_refused_in_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "t.json"
    path.write_text(text, encoding="utf-8")
    with spent() as time, pytest.raises(FormatError) as told:
        import_coco(path, Filmed())
    assert str(told.value).startswith(str(path))
    assert time.paces < 300
    assert "\n" not in str(told.value)
    assert len(str(told.value)) < 400


def test_elements_longer_than_a_piece_are_read(tmp_path: Path) -> None:
    rows = annotation(segmentation=[[0.5] * 400_000])
    found = import_coco(written(tmp_path, annotations=rows), Filmed())
    assert len(found.columns["frame"]) == 4


def test_what_is_no_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "t.json"
    path.write_bytes(b'{"info": "\xff\xfe"}')
    with pytest.raises(FormatError, match="not text"):
        import_coco(path, Filmed())
