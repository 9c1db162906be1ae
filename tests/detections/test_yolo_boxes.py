"""Detections as a folder of YOLO text."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from tracking.arrays import Integers
from tracking.detections import Footage, read_detections, yolo_boxes
from tracking.errors import FormatError

FOOTAGE = Footage(600, (640, 480))
ROW = "0 0.5 0.5 0.25 0.5"


def folder_of(place: Path, **texts: str) -> Path:
    folder = place / "labels"
    folder.mkdir()
    for name, text in texts.items():
        (folder / f"{name}.txt").write_text(text)
    return folder


def test_shares_of_the_picture_become_pixels(tmp_path) -> None:
    file = read_detections(folder_of(tmp_path, clip_1=ROW, clip_3=f"{ROW} 0.75 12\n\n"), FOOTAGE)
    assert file.format == "yolo"
    assert file.table.frame.tolist() == [0, 2]
    assert file.table.box.tolist() == [[240, 120, 160, 240]] * 2
    assert file.table.score.tolist() == [0.75, 0.75]


def test_files_named_like_the_recordings_pictures_are_of_their_frames(tmp_path) -> None:
    footage = Footage(3, (640, 480), ("x9", "x10", "x11"))
    table = read_detections(folder_of(tmp_path, x10=ROW, x11=ROW), footage).table
    assert table.frame.tolist() == [1, 2]


def test_only_class_0_is_people_or_the_one_that_is_called_so(tmp_path) -> None:
    folder = folder_of(tmp_path, f_1=f"{ROW}\n1 0.5 0.5 0.5 0.5 0.5\n")
    assert read_detections(folder, FOOTAGE).table.box[:, 2].tolist() == [160]
    (folder / "classes.txt").write_text("car\nPerson\n")
    assert read_detections(folder, FOOTAGE).table.box[:, 2].tolist() == [320]
    (folder / "classes.txt").write_text("car\ndog\n")
    with pytest.raises(FormatError, match="none of the classes is person"):
        read_detections(folder, FOOTAGE)


@pytest.mark.parametrize(
    "bad",
    [
        "0 0.5 0.5 0.2",
        "0 0.5 0.5 -0.2 0.5",
        "0 nan 0.5 0.2 0.5",
        "0 0.5 0.5 1e9 0.5",
        "0 1.2.3 0.5 0.2 0.5",
        "person 0.5 0.5 0.2 0.5",
        "0 0.5 0.5 0.2 0.5 1 2 3 4",
    ],
)
def test_a_row_that_is_no_box_is_left_out_and_told_with_file_and_line(tmp_path, bad) -> None:
    file = read_detections(folder_of(tmp_path, f_1=f"{ROW}\n{bad}\n", f_2=ROW), FOOTAGE)
    assert file.table.frame.tolist() == [0, 1]
    assert any("the first in f_1.txt, line 2" in note for note in file.notes)


def test_links_in_the_folder_are_not_followed_and_told(tmp_path) -> None:
    folder = folder_of(tmp_path, f_1=ROW)
    (tmp_path / "elsewhere.txt").write_text(ROW)
    (folder / "f_2.txt").symlink_to(tmp_path / "elsewhere.txt")
    (folder / "classes.txt").symlink_to(tmp_path / "elsewhere.txt")
    file = read_detections(folder, FOOTAGE)
    assert file.table.frame.tolist() == [0]
    assert any("links are not followed" in note for note in file.notes)


def test_a_folder_without_boxes_or_with_a_huge_file_is_refused(tmp_path, monkeypatch) -> None:
    folder = folder_of(tmp_path)
    with pytest.raises(FormatError, match="without text files"):
        read_detections(folder, FOOTAGE)
    (folder / "f_1.txt").touch()
    with pytest.raises(FormatError, match="holds no boxes"):
        read_detections(folder, FOOTAGE)
    monkeypatch.setattr(yolo_boxes, "_MOST_FILE_BYTES", 10)
    (folder / "f_1.txt").write_text(ROW)
    with pytest.raises(FormatError, match="text of one frame"):
        read_detections(folder, FOOTAGE)


def test_the_fingerprint_is_of_names_and_contents(tmp_path) -> None:
    folder = folder_of(tmp_path, f_1=ROW, f_2=ROW)
    one = read_detections(folder, FOOTAGE).fingerprint
    (folder / "f_2.txt").rename(folder / "f_3.txt")
    assert one != read_detections(folder, FOOTAGE).fingerprint


def test_the_boxes_are_those_that_the_fingerprint_is_of(tmp_path) -> None:
    folder = folder_of(tmp_path, f_1=ROW)
    fingerprint = read_detections(folder, FOOTAGE).fingerprint

    class ChangedMeanwhile(Footage):
        """Asked for frames when the folder has been hashed, before its rows become boxes."""

        def numbers_of_names(self, names: Sequence[str]) -> tuple[Integers, bool]:
            (folder / "f_1.txt").write_text("0 0.5 0.5 0.5 0.5")
            (folder / "f_2.txt").write_text(ROW)
            (folder / "classes.txt").write_text("car\n")
            return Footage.numbers_of_names(self, names)

    file = read_detections(folder, ChangedMeanwhile(600, (640, 480)))
    assert file.fingerprint == fingerprint
    assert file.table.box.tolist() == [[240, 120, 160, 240]]


@pytest.mark.parametrize("name", ["classes.txt", "obj.names"])
def test_the_fingerprint_is_of_the_file_too_that_says_who_is_a_person(tmp_path, name) -> None:
    folder = folder_of(tmp_path, f_1=f"{ROW}\n1 0.5 0.5 0.5 0.5")
    known = [read_detections(folder, FOOTAGE).fingerprint]
    for text in ("car\nperson\n", "person\ncar\n"):
        (folder / name).write_text(text)
        known.append(read_detections(folder, FOOTAGE).fingerprint)
    assert len(set(known)) == 3


def test_boxes_of_later_frames_and_outside_of_the_picture_are_told(tmp_path) -> None:
    beside, edge = "0 1.5 0.5 0.2 0.5", "0 1.0 0.5 0.5 0.5"
    folder = folder_of(tmp_path, f_1=f"{ROW}\n{beside}\n{edge}", f_601=f"{ROW}\n{ROW}")
    file = read_detections(folder, FOOTAGE)
    assert file.table.box[:, 0].tolist() == [240, 480]
    assert any("not among them: 2 boxes after the last frame (599)" in n for n in file.notes)
    assert any("1 box outside of the image" in note for note in file.notes)
    (folder / "f_1.txt").unlink()
    with pytest.raises(FormatError, match="is it of this recording"):
        read_detections(folder, FOOTAGE)
