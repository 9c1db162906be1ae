"""Folders of X-AnyLabeling in and out."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, assert_same, known_rows, table, tracks

from tracking.errors import FormatError, OutputError
from tracking.formats import format_of
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported, no_progress
from tracking.formats.xanylabeling import X_ANYLABELING, export_xanylabeling, import_xanylabeling
from tracking.tracks import TrackLabel, TrackTable

SIZE = (640, 480)
CORNERS = [[10, 20], [40, 20], [40, 60], [10, 60]]


def shape(**changed: Any) -> dict[str, Any]:
    return {
        "label": "person",
        "points": CORNERS,
        "group_id": 3,
        "shape_type": "rectangle",
        **changed,
    }


def frame(folder: Path, name: str, *shapes: Any, **changed: Any) -> None:
    folder.mkdir(exist_ok=True)
    document = {
        "version": "4.0.2",
        "flags": {},
        "shapes": list(shapes),
        "imagePath": f"{name}.jpg",
        "imageData": None,
        "imageHeight": 480,
        "imageWidth": 640,
        **changed,
    }
    (folder / f"{name}.json").write_text(json.dumps(document), encoding="utf-8")


def imported(folder: Path) -> Imported:
    return import_xanylabeling(folder, Filmed())


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_what_has_a_box_comes_back(tmp_path: Path, made: TrackTable) -> None:
    boxed = known_rows(made.columns(), "left")
    exported = Exported.of_table(made, frames=41, size_px=SIZE)
    folder = tmp_path / "frames"
    if not len(boxed["frame"]):
        with pytest.raises(FormatError, match="nobody has a box"):
            export_xanylabeling(folder, exported, no_progress)
        assert not list(tmp_path.iterdir())
        return
    assert export_xanylabeling(folder, exported, no_progress) == (folder,)
    assert format_of(folder) is X_ANYLABELING
    assert_same(imported(folder).columns, boxed, BOX)
    shutil.rmtree(folder)


def test_names_attributes_and_confidence_travel(tmp_path: Path) -> None:
    made = table([(0, 3), (0, 8), (7, 3)], [(1, 2, 3, 4)] * 3)
    rows = {**made.columns(), "confidence": np.array([0.59, np.nan, 0], np.float32)}
    labels = {3: TrackLabel("Zoë", {"bag": "yes"}), 8: TrackLabel(attributes={"class": "dog"})}
    exported = Exported(rows, frames=9, size_px=SIZE, labels=labels, dont_cares=True)
    export_xanylabeling(tmp_path / "f", exported, no_progress)
    assert sorted(file.name for file in (tmp_path / "f").iterdir()) == [
        "frame_00000.json",
        "frame_00007.json",
    ]
    back = imported(tmp_path / "f")
    assert back.labels == labels
    np.testing.assert_array_equal(back.columns["confidence"], rows["confidence"])
    last = json.loads((tmp_path / "f" / "frame_00007.json").read_text(encoding="utf-8"))
    assert last["shapes"][0]["difficult"] is True  # what does not count


def test_nothing_that_is_there_is_written_over(tmp_path: Path) -> None:
    exported = Exported.of_table(table([(0, 1)], [(1, 2, 3, 4)]), frames=1, size_px=SIZE)
    full, file, link = tmp_path / "full", tmp_path / "file", tmp_path / "link"
    full.mkdir()
    (full / "mine.json").write_text("mine")
    file.write_text("mine")
    link.symlink_to(full, target_is_directory=True)
    for path in (full, file, link):
        with pytest.raises(OutputError, match=r"not an empty folder|and a folder is written"):
            export_xanylabeling(path, exported, no_progress)
    assert sorted(tmp_path.iterdir()) == [file, full, link]
    assert (full / "mine.json").read_text() == file.read_text() == "mine"
    empty = tmp_path / "empty"
    empty.mkdir()
    assert export_xanylabeling(empty, exported, no_progress) == (empty,)


def test_frames_are_the_places_of_pictures_in_natural_order(tmp_path: Path) -> None:
    for name in ("p2", "p10", "p9"):
        (tmp_path / f"{name}.jpg").touch()
    frame(tmp_path, "p10", shape())
    frame(tmp_path, "p9", shape(group_id=4))
    found = imported(tmp_path)
    assert found.columns["frame"].tolist() == [1, 2]
    assert found.columns["track"].tolist() == [4, 3]
    assert found.frames == 3
    assert found.notes == ()


def test_without_pictures_frames_are_the_numbers_behind_the_last_underscore(tmp_path: Path) -> None:
    frame(tmp_path, "cam2_000007", shape())
    frame(tmp_path, "cam2_12b", shape())
    assert imported(tmp_path).columns["frame"].tolist() == [7, 12]
    frame(tmp_path, "cam3_7", shape())
    with pytest.raises(FormatError, match="both of frame 7"):
        imported(tmp_path)


@pytest.mark.parametrize(
    ("kind", "points", "box"),
    [
        ("rectangle", [[40, 60], [10, 20]], (10, 20, 30, 40)),
        ("rotation", [[5, 0], [10, 5], [5, 10], [0, 5]], (0, 0, 10, 10)),
        ("polygon", [[1, 2], [3, 8], [5, 4]], (1, 2, 4, 6)),
        ("circle", [[10, 10], [13, 14]], (5, 5, 10, 10)),
    ],
)
def test_boxes_are_read_around_every_kind_of_area(
    tmp_path: Path, kind: str, points: Any, box: tuple[float, ...]
) -> None:
    frame(tmp_path, "frame_0", shape(shape_type=kind, points=points))
    columns = imported(tmp_path).columns
    assert tuple(columns[name][0] for name in BOX) == box


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (7, "is no object"),
        (shape(group_id="3"), "group_id"),
        (shape(group_id=-1), "group_id"),
        (shape(points=[[1, 2]]), "two or more"),
        (shape(points=[[1, 2], [3]]), "two numbers"),
        (shape(points=[[1, 2], [3, None]]), "two numbers"),
        (shape(score="high"), "score"),
        (shape(shape_type="heart"), "heart"),
        (shape(), "its id stands twice"),
    ],
)
def test_an_invalid_shape_is_told_with_its_file(tmp_path: Path, wrong: Any, reason: str) -> None:
    frame(tmp_path, "frame_4", shape(), wrong)
    found = imported(tmp_path)
    assert found.columns["frame"].tolist() == [4]
    (bad,) = found.bad_rows
    assert bad.place == "frame_4.json, shapes[1]"
    assert reason in bad.reason


def test_shapes_without_any_group_are_no_tracks(tmp_path: Path) -> None:
    frame(tmp_path, "frame_4", shape(group_id=None))
    with pytest.raises(FormatError, match="group them first"):
        imported(tmp_path)


def test_no_link_is_followed_out_of_the_folder(tmp_path: Path) -> None:
    frame(tmp_path / "other", "frame_1", shape())
    frame(tmp_path / "mine", "frame_0", shape())
    (tmp_path / "mine" / "frame_1.json").symlink_to(tmp_path / "other" / "frame_1.json")
    found = imported(tmp_path / "mine")
    assert found.columns["frame"].tolist() == [0]
    assert [(bad.place, "link" in bad.reason) for bad in found.bad_rows] == [("frame_1.json", True)]


def test_a_picture_inside_of_a_file_is_passed_over(tmp_path: Path) -> None:
    frame(tmp_path, "frame_0", shape(), imageData="A" * (9 << 20) + '\\"')
    assert len(imported(tmp_path).columns["frame"]) == 1


def test_a_folder_of_something_else_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text('{"a": 1}')
    with pytest.raises(FormatError, match="is a folder"):
        format_of(tmp_path)


@pytest.mark.parametrize("text", ['{"version": "1", "shapes": [', '{"shapes": [1', "{" * 100_000])
def test_what_is_no_such_json_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "frame_0.json").write_text(text)
    with pytest.raises(FormatError, match=r"frame_0\.json"):
        imported(tmp_path)
