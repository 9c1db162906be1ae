"""The disk after a power cut, as the sweep of power cuts takes it."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.sweeps.disk_model import Disk, File, Folder


@pytest.fixture
def disk(tmp_path: Path) -> Disk:
    """A folder with one file of old text, all of it on the disk."""
    (tmp_path / "tree").mkdir()
    (tmp_path / "tree" / "old").write_bytes(b"old")
    return Disk(tmp_path / "tree")


def after_cuts(disk: Disk, folder: Path, *, in_order: bool = True) -> list[dict[str, bytes]]:
    """What forty power cuts leave, by name."""
    found = []
    for number in range(40):
        place = folder / f"cut-{number}"
        place.parent.mkdir(exist_ok=True)
        disk.cut(place, random.Random(number), 512, in_order=in_order)
        found.append({file.name: file.read_bytes() for file in place.rglob("*") if file.is_file()})
    return found


def write(disk: Disk, path: Path, data: bytes, *, sync: bool) -> File:
    file = File()
    disk.name((str(path), file))
    file.write(0, data)
    if sync:
        file.sync()
    return file


def test_a_write_that_was_not_synced_is_lost_kept_or_torn(disk: Disk, tmp_path: Path) -> None:
    old = disk.find(str(tmp_path / "tree" / "old"))
    assert isinstance(old, File)
    old.write(0, b"new" * 500)
    left = {found["old"] for found in after_cuts(disk, tmp_path)}
    assert {b"old", b"new" * 500} < left
    old.sync()
    assert {found["old"] for found in after_cuts(disk, tmp_path / "later")} == {b"new" * 500}


def test_a_name_lasts_only_once_its_folder_is_synced(disk: Disk, tmp_path: Path) -> None:
    write(disk, tmp_path / "tree" / "made", b"data", sync=True)
    assert {"made" in found for found in after_cuts(disk, tmp_path)} == {True, False}
    disk.sync_folder(disk.top, in_order=True)
    assert all(found["made"] == b"data" for found in after_cuts(disk, tmp_path / "later"))


def test_a_file_that_takes_the_place_of_another_is_one_of_both(disk: Disk, tmp_path: Path) -> None:
    tree = tmp_path / "tree"
    beside = write(disk, tree / "beside", b"whole", sync=True)
    disk.name((str(tree / "beside"), None), (str(tree / "old"), beside))
    for in_order in (True, False):
        left = after_cuts(disk, tmp_path / str(in_order), in_order=in_order)
        assert {found["old"] for found in left} == {b"old", b"whole"}


def test_what_lies_in_a_folder_that_was_not_synced_goes_with_it(disk: Disk, tmp_path: Path) -> None:
    disk.name((str(tmp_path / "tree" / "folder"), Folder()))
    folder = disk.find(str(tmp_path / "tree" / "folder"))
    assert isinstance(folder, Folder)
    write(disk, tmp_path / "tree" / "folder" / "made", b"data", sync=True)
    disk.sync_folder(folder, in_order=False)
    assert {"made" in found for found in after_cuts(disk, tmp_path)} == {True, False}
