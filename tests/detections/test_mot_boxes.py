"""Detections as MOTChallenge's det.txt."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from tracking.detections import DetectionsFile, Footage, detections_file
from tracking.errors import FormatError


def read_detections(path: Path) -> DetectionsFile:
    """Of a recording with pictures of 640 x 480 px."""
    return detections_file.read_detections(path, Footage(600, (640, 480)))


def written(folder: Path, text: str) -> Path:
    path = folder / "boxes"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "row",
    [
        "{frame},-1,11,21,30,40",
        "{frame},-1,11,21,30,40,0.5",
        "{frame},-1,11,21,30,40,0.5,-1,-1",
        "{frame},-1,11,21,30,40,0.5,-1,-1,-1",
    ],
)
def test_frames_and_corners_counted_from_1_are_counted_from_0_here(tmp_path, row) -> None:
    file = read_detections(written(tmp_path, "\n".join(row.format(frame=n) for n in (3, 1, 2))))
    assert file.format == "mot"
    assert file.table.frame.tolist() == [0, 1, 2]
    assert file.table.box.tolist() == [[10, 20, 30, 40]] * 3
    assert file.notes == ()


def test_with_a_frame_0_frames_and_corners_count_from_0_and_that_is_told(tmp_path) -> None:
    rows = "".join(f"{n},-1,11,21,30,40,0.5\n" for n in (2, 0, 1))
    file = read_detections(written(tmp_path, rows))
    assert file.table.frame.tolist() == [0, 1, 2]
    assert file.table.box.tolist() == [[11, 21, 30, 40]] * 3
    assert "counted from 0" in file.notes[0]


@pytest.mark.parametrize("zero", ["left", "right"])
def test_both_cameras_count_from_where_either_does(tmp_path, zero) -> None:
    given = []
    for name in ("left", "right"):
        folder = tmp_path / name
        folder.mkdir()
        numbers = (0, 3) if name == zero else (2, 3)
        path = written(folder, "".join(f"{n},-1,11,21,30,40,0.5\n" for n in numbers))
        given.append((path, Footage(600, (640, 480))))
    files = dict(zip(("left", "right"), detections_file.read_cameras(given), strict=True))
    assert files.pop(zero).table.frame.tolist() == [0, 3]
    ((_, other),) = files.items()
    assert other.table.frame.tolist() == [2, 3]
    assert other.table.box[0].tolist() == [11, 21, 30, 40]
    assert "counted from 0" in other.notes[0]


@pytest.mark.parametrize(
    ("scores", "read"),
    [((-1, -1), [1, 1]), ((-1, 2.5, 0.5, 2), [2, 2.5, 0.5, 2]), ((-2, 2), [-2, 2])],
)
def test_scores_stay_in_their_unit_and_minus_1_is_as_sure_as_half_of_them(tmp_path, scores, read):
    rows = "\n".join(f"{k + 1},-1,1,1,30,40,{score}" for k, score in enumerate(scores))
    assert read_detections(written(tmp_path, rows)).table.score.tolist() == read


BAD = [
    "nan,-1,1,1,9,9,1",
    "2.5,-1,1,1,9,9,1",
    "-1,-1,1,1,9,9,1",
    "inf,-1,1,1,9,9,1",
    "99999999,-1,1,1,9,9,1",
    "2,-1,inf,1,9,9,1",
    "2,-1,1,1,-9,9,1",
    "2,-1,1,1,9,0,1",
    "2,-1,1e300,1,9,9,1",
    "2,-1,1,1,9,9,1e300",
    "2,-1,one,1,9,9,1",
    "2,-1,1",
]


@pytest.mark.parametrize("bad", BAD)
def test_a_box_that_cannot_be_is_left_out_and_told_with_its_line(tmp_path, bad) -> None:
    file = read_detections(written(tmp_path, f"1,-1,1,1,9,9,1\n{bad}\n3,-1,1,1,9,9,1\n"))
    assert file.table.frame.tolist() == [0, 2]
    (note,) = file.notes
    assert "1 box cannot be used" in note
    assert "line 2" in note


def test_a_file_of_bad_boxes_alone_is_refused_in_one_line(tmp_path) -> None:
    with pytest.raises(FormatError) as error:
        read_detections(written(tmp_path, "1,-1,1,1,-9,9,1\n"))
    assert "line 1" in str(error.value)
    assert "\n" not in str(error.value)


def test_what_is_no_plain_file_of_detections_is_refused_in_one_line(tmp_path) -> None:
    text = written(tmp_path, "1,-1,1,1,9,9,1\n")
    (tmp_path / "link").symlink_to(text)
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "empty").touch()
    (tmp_path / "prose").write_text("People walk here.\n")
    (tmp_path / "spaces").write_text("1 -1 1 1 9 9 1\n2 -1 1 1 9 9 1\n")
    (tmp_path / "bytes").write_bytes(bytes(range(256)) * 9)
    said = {"link": "link", "pipe": "no file", "empty": "empty", "missing": "No such file"}
    said |= {"prose": "no file of detections", "spaces": "commas", "bytes": "no file of detections"}
    for name, reason in said.items():
        with pytest.raises(FormatError) as error:
            read_detections(tmp_path / name)
        assert reason in str(error.value)
        assert name in str(error.value)
        assert "\n" not in str(error.value)


def test_a_file_larger_than_any_is_refused_before_it_is_read(tmp_path) -> None:
    path = written(tmp_path, "1,-1,1,1,9,9,1\n")
    os.truncate(path, detections_file.MOST_BYTES + 1)
    with pytest.raises(FormatError, match="larger than 200 MB"):
        read_detections(path)


def test_more_boxes_than_any_recording_has_are_refused(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("tracking.detections.box_collector.MOST_IN_ALL", 3)
    rows = written(tmp_path, "1,-1,1,1,9,9,1\n" * 4)
    with pytest.raises(FormatError, match="more than 3 boxes"):
        read_detections(rows)


def test_the_fingerprint_is_of_every_byte(tmp_path) -> None:
    rows = "".join(f"{k + 1},-1,1,1,9,9,1\n" for k in range(500))
    one = read_detections(written(tmp_path, rows)).fingerprint
    assert one == read_detections(written(tmp_path, rows)).fingerprint
    other = rows.replace("\n250,-1,1,", "\n250,-1,2,")
    assert one != read_detections(written(tmp_path, other)).fingerprint
    assert np.isclose(len(one), 64)


def test_the_boxes_are_those_that_the_fingerprint_is_of(tmp_path, monkeypatch) -> None:
    path, format_of = written(tmp_path, "1,-1,11,21,30,40,1\n"), detections_file._format_of

    def changed_meanwhile(*given):
        path.write_text("1,-1,51,61,70,80,1\n")
        return format_of(*given)

    monkeypatch.setattr(detections_file, "_format_of", changed_meanwhile)
    assert read_detections(path).table.box.tolist() == [[10, 20, 30, 40]]


def test_boxes_in_shares_of_the_image_are_told_as_such(tmp_path) -> None:
    with pytest.raises(FormatError, match="as shares of an image are; give pixels"):
        read_detections(written(tmp_path, "1,-1,0.5,0.5,0.1,0.2,0.9\n2,-1,0.4,0.5,0.1,0.2,0.9\n"))


def test_a_line_of_names_above_the_numbers_is_told(tmp_path) -> None:
    with pytest.raises(FormatError, match="line 1 is no row of numbers"):
        read_detections(written(tmp_path, "frame,id,x,y,w,h,conf\n1,-1,11,21,30,40,0.5\n"))
