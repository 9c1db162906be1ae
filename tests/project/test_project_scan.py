"""What is found in a project's folder, and what is left alone."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.batch.walks import make_walk
from tracking.errors import RecordingError
from tracking.project import folder_scan, holds_several, scan_folder


def _names(folder: Path) -> list[str]:
    return [file.path.relative_to(folder).as_posix() for file in scan_folder(folder).recordings]


def test_recordings_and_sessions_are_found_at_any_depth_up_to_a_limit(tmp_path: Path) -> None:
    make_walk(tmp_path / "a")
    make_walk(tmp_path / "day" / "cam" / "b")
    (tmp_path / "day" / "c.mp4").write_bytes(b"x")
    (tmp_path / "day" / "b.h5").write_bytes(b"x")
    (tmp_path / "a" / "a.h5").write_bytes(b"x")
    make_walk(tmp_path.joinpath(*"1234567", "deep"))
    scan = scan_folder(tmp_path)
    assert _names(tmp_path) == ["a", "day/c.mp4", "day/cam/b"]
    assert [file.path.name for file in scan.sessions] == ["a.h5", "b.h5"]
    assert [str(note) for note in scan.notes] == [
        "folders more than 6 levels down are not searched"
    ]


def test_links_and_hidden_files_are_not_looked_at(tmp_path: Path) -> None:
    top = tmp_path / "top"
    make_walk(top / "a")
    make_walk(tmp_path / "elsewhere")
    (top / "link").symlink_to(tmp_path / "elsewhere", target_is_directory=True)
    (top / "round").symlink_to(top, target_is_directory=True)
    (tmp_path / "s.h5").write_bytes(b"x")
    (top / "linked.h5").symlink_to(tmp_path / "s.h5")
    make_walk(top / ".hidden")
    os.mkfifo(top / "pipe.h5")
    scan = scan_folder(top)
    assert _names(top) == ["a"]
    assert scan.sessions == []


def test_no_more_than_so_many_are_listed_and_that_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(4):
        (tmp_path / f"{number}.mp4").write_bytes(b"x")
    monkeypatch.setattr(folder_scan, "MOST_RECORDINGS", 2)
    scan = scan_folder(tmp_path)
    assert _names(tmp_path) == ["0.mp4", "1.mp4"]
    assert str(scan.notes[0]).startswith("only the first 2 recordings and 0 sessions are listed")


def test_a_stamp_changes_with_the_recording_and_not_with_sessions_in_it(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "a")
    (before,) = scan_folder(tmp_path).recordings
    (walk / "a.h5").write_bytes(b"x")
    assert scan_folder(tmp_path).recordings == [before]
    (walk / "truth.txt").write_text("")
    assert scan_folder(tmp_path).recordings != [before]


def test_a_folder_that_is_a_recording_is_a_project_of_one(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "a")
    scan = scan_folder(walk)
    assert [file.path for file in scan.recordings] == [walk]


def test_a_folder_that_is_not_there_is_refused_in_a_line(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"cannot read the folder .*none.*check the path"):
        scan_folder(tmp_path / "none")


def test_only_a_folder_with_several_is_taken_for_a_project(tmp_path: Path) -> None:
    one = make_walk(tmp_path / "some" / "a")
    assert not holds_several(tmp_path / "some")
    assert not holds_several(one)
    make_walk(tmp_path / "some" / "b")
    assert holds_several(tmp_path / "some")
    (tmp_path / "link").symlink_to(tmp_path / "some", target_is_directory=True)
    assert not holds_several(tmp_path / "link")
