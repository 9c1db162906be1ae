"""Where results may go, and where not."""

from __future__ import annotations

import os
import shutil
import sys
from collections import namedtuple
from pathlib import Path

import h5py
import numpy as np
import pytest

from app.cli.destination import (
    check_file,
    check_folder,
    check_replaced,
    check_text_replaced,
    nearest_folder,
    read_file_kind,
)
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


posix = pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")


@posix
@pytest.mark.parametrize("leads_to", [None, "/dev/null", "pipe", "circle"])
def test_a_pipe_or_a_device_is_refused_before_the_work(
    tmp_path: Path, leads_to: str | None
) -> None:
    out = tmp_path / "out.h5"
    os.mkfifo(tmp_path / "pipe" if leads_to else out)
    if leads_to:
        (tmp_path / "circle").symlink_to(tmp_path / "circle")
        out.symlink_to(tmp_path / leads_to)
    with pytest.raises(OutputError, match=r"cannot write .* it is a (pipe|device|link)"):
        check_file(out)


@posix
def test_a_link_may_name_a_session_and_nothing_else(tmp_path: Path) -> None:
    (tmp_path / "text.csv").write_text("precious")
    (tmp_path / "out.csv").symlink_to(tmp_path / "text.csv")
    check_file(tmp_path / "out.csv")
    with pytest.raises(OutputError, match=r"out\.csv: it is a link, which is not written through"):
        check_text_replaced(tmp_path / "out.csv")
    with pytest.raises(OutputError, match=r"out\.csv: it is a link, which is not written through"):
        check_replaced(tmp_path / "out.csv", "trackwright-samples")


def odd_format(file: h5py.File, kind: str) -> None:
    """A root attribute `format` like no program's."""
    odd = {
        "numbers": np.arange(8),
        "many": np.array(["trackwright-detector"] * 3, h5py.string_dtype()),
        "reference": np.array(file.ref, h5py.ref_dtype),
        "long": np.bytes_(b"x" * 60_000),
    }
    file.attrs["format"] = odd[kind]


@pytest.mark.parametrize("kind", ["numbers", "many", "reference", "long"])
def test_an_odd_format_says_nothing(tmp_path: Path, kind: str) -> None:
    with h5py.File(tmp_path / "odd.h5", "w") as file:
        odd_format(file, kind)
    assert read_file_kind(tmp_path / "odd.h5") == ""


def test_what_stands_in_the_way_is_never_opened_by_hdf5_in_this_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, cut, text = tmp_path / "out.h5", tmp_path / "cut.h5", tmp_path / "text.h5"
    with h5py.File(out, "w") as file:
        file.attrs["format"] = "trackwright-detector"
    cut.write_bytes(out.read_bytes()[:300])
    text.write_text("no HDF5")

    def opened(*_: object, **__: object) -> None:
        raise AssertionError("the HDF5 library would read a file from anywhere")

    monkeypatch.setattr(h5py, "File", opened)
    check_replaced(out, "trackwright-detector")
    assert [read_file_kind(path) for path in (out, cut, text)] == ["trackwright-detector", "", None]
    with pytest.raises(OutputError, match="is a detector and would be lost"):
        check_replaced(out, "trackwright-samples")
    with pytest.raises(OutputError, match="is an HDF5 file and would be lost"):
        check_replaced(cut, "trackwright-samples")
    with pytest.raises(OutputError, match="is a detector and would be lost"):
        check_text_replaced(out)
