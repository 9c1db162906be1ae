"""Where results may go, and where not."""

from __future__ import annotations

import shutil
from collections import namedtuple
from pathlib import Path

import pytest

from app.cli.destination import check_file, check_folder, nearest_folder
from app.cli.display import has_display
from tracking.errors import OutputError

Usage = namedtuple("Usage", "total used free")


def test_a_good_place_passes(tmp_path: Path) -> None:
    check_file(tmp_path / "out.h5", 1000)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="is a folder"):
        check_file(tmp_path)


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="does not exist"):
        check_file(tmp_path / "no" / "out.h5")


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(OutputError, match="is not a folder"):
        check_folder(tmp_path / "file")


def test_a_folder_nobody_can_write_in_is_told() -> None:
    if not Path("/proc/self").is_dir():
        pytest.skip("no folder here that even root cannot write in")
    with pytest.raises(OutputError, match="cannot write in folder /proc/self"):
        check_folder(Path("/proc/self"))


def test_a_full_disk_is_told_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: Usage(2 << 30, 1 << 30, 20 << 20))
    check_folder(tmp_path, 1 << 20)
    with pytest.raises(OutputError, match="has 20 MB of free space"):
        check_folder(tmp_path, 1 << 30)


@pytest.mark.parametrize(
    ("free", "told"), [(700 << 10, "has 700 kB of free"), (12, "has 12 bytes of free")]
)
def test_little_space_is_told_in_small_units(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, free: int, told: str
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: Usage(2 << 30, 1 << 30, free))
    with pytest.raises(OutputError, match=told):
        check_folder(tmp_path, 0)


def test_the_nearest_folder_is_the_one_that_exists(tmp_path: Path) -> None:
    assert nearest_folder(tmp_path / "a" / "b") == tmp_path
    assert nearest_folder(tmp_path) == tmp_path


@pytest.mark.parametrize(
    ("environment", "system", "seen"),
    [
        ({}, "linux", False),
        ({"DISPLAY": ""}, "linux", False),
        ({"DISPLAY": ":0"}, "linux", True),
        ({"WAYLAND_DISPLAY": "wayland-0"}, "linux", True),
        ({"DISPLAY": ":0", "QT_QPA_PLATFORM": "offscreen"}, "linux", False),
        ({"DISPLAY": ":0", "QT_QPA_PLATFORM": "minimal:size=3x4"}, "linux", False),
        ({}, "darwin", True),
        ({}, "win32", True),
    ],
)
def test_a_display_is_seen(environment: dict[str, str], system: str, seen: bool) -> None:
    assert has_display(environment, system) is seen
