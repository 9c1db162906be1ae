"""Which recordings words mean, and how they are called."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.batch.walks import make_walk, write_manifest
from tracking.batch import Entry, find_recordings, named_entries, shard_of
from tracking.batch.recordings import detections_of
from tracking.errors import RecordingError


@pytest.fixture
def top(tmp_path: Path) -> Path:
    """Recordings in folders, a bare video, and what is none."""
    for name in ("day1/one", "day1/two", "day2/one"):
        folder = tmp_path / name
        folder.mkdir(parents=True)
        write_manifest(folder, "left.mp4")
    (tmp_path / "day2" / "bare.mp4").write_bytes(b"")
    (tmp_path / "day2" / "notes.txt").write_text("")
    (tmp_path / "empty").mkdir()
    (tmp_path / "out").mkdir()
    return tmp_path


def names(top: Path, *words: object, **asked) -> list[str]:
    found = find_recordings([str(word) for word in words], **asked)
    return [path.relative_to(top).as_posix() for path in found.paths]


def test_a_folder_is_searched(top: Path) -> None:
    found = find_recordings([str(top)], leave_out=top / "out")
    assert names(top, top) == ["day1/one", "day1/two", "day2/bare.mp4", "day2/one"]
    assert [path.name for path in found.empty] == ["empty"]
    assert found.missing == {}


def test_a_pattern_a_list_and_paths_mean_each_recording_once(top: Path) -> None:
    (top / "list.txt").write_text("# of today\n\nday1/two\nday2\n")
    assert names(top, top / "day*" / "one", top / "day1" / "one", top / "list.txt") == [
        "day1/one",
        "day2/one",
        "day1/two",
        "day2/bare.mp4",
    ]
    assert names(top, listed=top / "list.txt") == ["day1/two", "day2/bare.mp4", "day2/one"]


def test_a_manifest_is_its_folder(top: Path) -> None:
    assert names(top, top / "day1" / "one" / "recording.toml") == ["day1/one"]


def test_what_is_not_there_is_told_by_name(top: Path) -> None:
    found = find_recordings([str(top / "day3"), str(top / "*.avi"), str(top / "empty")])
    assert [path.name for path in found.missing] == ["day3", "*.avi", "empty"]
    assert found.paths == []


def test_a_list_that_is_no_text_is_refused(top: Path) -> None:
    (top / "list.txt").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(RecordingError, match="UTF-8"):
        find_recordings([str(top / "list.txt")])


def test_a_folder_of_images_is_one_recording(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "walk")
    (walk / "recording.toml").unlink()
    assert names(tmp_path, walk / "left") == ["walk/left"]


def entry_names(*paths: str, known: dict[Path, str] | None = None) -> list[str]:
    return [entry.name for entry in named_entries([Path(path) for path in paths], known)]


def test_recordings_are_called_after_their_folder_or_file() -> None:
    assert entry_names("/d/one", "/d/two.mp4", "/d/v1.2") == ["one", "two", "v1.2"]


def test_recordings_of_one_name_are_told_apart_by_their_folders() -> None:
    assert entry_names("/x/a/one", "/x/b/one", "/x/two") == ["a-one", "b-one", "two"]
    first, second = entry_names("/d/one.mp4", "/d/one.avi")
    assert first.startswith("d-one-")
    assert first != second


def test_names_differ_also_on_disks_that_know_no_case() -> None:
    found = entry_names("/d/One", "/d/one")
    assert len({name.casefold() for name in found}) == 2


def test_a_name_that_is_taken_stays_its_own() -> None:
    known = {Path("/old/one"): "one"}
    assert entry_names("/old/one", known=known) == ["one"]
    (name,) = entry_names("/new/one", known=known)
    assert name.startswith("one-")


def test_a_new_name_does_not_hang_on_what_is_known() -> None:
    paths = ("/a/x", "/b/x", "/c/y")
    for known in ({Path("/b/x"): "x"}, {Path("/b/x"): "x", Path("/c/y"): "y"}):
        assert entry_names(*paths, known=known) == ["a-x", "x", "y"]
    (taken,) = entry_names("/a/x", known={Path("/b/x"): "x"})
    assert taken.startswith("x-")


def test_no_name_leaves_the_folder() -> None:
    (name,) = entry_names("/d/..hid\x1b[1mden")
    assert "/" not in name
    assert not name.startswith(".")
    assert name.isprintable()


def test_shards_are_all_of_a_batch_and_share_nothing() -> None:
    entries = [Entry(f"{number}", Path(f"/{number}")) for number in range(10)]
    parts = [shard_of(entries, number, 3) for number in (1, 2, 3)]
    assert sorted((entry for part in parts for entry in part), key=lambda e: e.name) == entries
    assert sorted(map(len, parts)) == [3, 3, 4]


@pytest.mark.parametrize(
    "pattern", ["det.txt", "d*.txt", "{folder}/det.txt", "{folder}/../{name}/det.txt"]
)
def test_detections_are_found_by_a_pattern(tmp_path: Path, pattern: str) -> None:
    folder = tmp_path / "walk[1]"
    folder.mkdir()
    (folder / "det.txt").write_text("")
    found = detections_of(pattern, Entry("walk[1]", folder))
    assert found.samefile(folder / "det.txt")


def test_detections_that_are_missing_or_several_are_refused(tmp_path: Path) -> None:
    for name in ("d1.txt", "d2.txt"):
        (tmp_path / name).write_text("")
    entry = Entry("walk", tmp_path)
    with pytest.raises(RecordingError, match="no detections are at"):
        detections_of("det.txt", entry)
    with pytest.raises(RecordingError, match="2 files fit"):
        detections_of("d*.txt", entry)
