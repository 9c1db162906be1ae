"""Output files appear whole or not at all, and only in the place of regular files."""

from __future__ import annotations

import errno
import os
import stat
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tracking.atomic_output import (
    part_of,
    replace_with,
    replacing,
    replacing_bytes,
    replacing_folder,
)
from tracking.errors import OutputError
from tracking.geometry import Camera, StereoCalibration, write_calibration
from tracking.recording import Manifest, write_manifest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")


@pytest.fixture
def victim(tmp_path: Path) -> Path:
    file = tmp_path / "elsewhere" / "victim"
    file.parent.mkdir()
    file.write_bytes(b"precious")
    return file


def as_link(place: Path, victim: Path) -> None:
    place.symlink_to(victim)


def as_dangling_link(place: Path, victim: Path) -> None:
    place.symlink_to(victim.with_name("made"))


def as_link_to_device(place: Path, _: Path) -> None:
    place.symlink_to("/dev/null")


def as_pipe(place: Path, _: Path) -> None:
    os.mkfifo(place)


def as_folder(place: Path, _: Path) -> None:
    place.mkdir()


@pytest.mark.parametrize("trap", [as_link, as_dangling_link, as_link_to_device, as_pipe, as_folder])
def test_only_a_regular_file_is_replaced(
    tmp_path: Path, victim: Path, trap: Callable[[Path, Path], None]
) -> None:
    out = tmp_path / "out.csv"
    trap(out, victim)
    kind = stat.S_IFMT(out.lstat().st_mode)
    with pytest.raises(OutputError, match=r"cannot write .*out\.csv: it is a (link|pipe|folder)"):
        replace_with(out, b"new")
    assert stat.S_IFMT(out.lstat().st_mode) == kind
    assert [file.name for file in victim.parent.iterdir()] == ["victim"]
    assert victim.read_bytes() == b"precious"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["elsewhere", "out.csv"]


def test_a_second_name_of_another_file_is_replaced_and_that_file_is_left_alone(
    tmp_path: Path, victim: Path
) -> None:
    (tmp_path / "out.csv").hardlink_to(victim)
    replace_with(tmp_path / "out.csv", b"new")
    assert (tmp_path / "out.csv").read_bytes() == b"new"
    assert victim.read_bytes() == b"precious"


def test_a_new_file_may_be_read_by_whom_the_umask_lets(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        replace_with(tmp_path / "out.csv", b"new")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "out.csv").stat().st_mode) == 0o640


def test_a_file_that_is_replaced_keeps_its_permissions(tmp_path: Path) -> None:
    (tmp_path / "out.csv").touch()
    (tmp_path / "out.csv").chmod(0o4600)
    with replacing(tmp_path / "out.csv") as stream:
        stream.write("private")
    assert stat.S_IMODE((tmp_path / "out.csv").stat().st_mode) == 0o600


def test_the_umask_of_the_process_is_never_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Other threads make files meanwhile: they would get the wrong permissions."""

    def changed(_: int) -> int:
        raise AssertionError("the umask was changed")

    monkeypatch.setattr(os, "umask", changed)
    replace_with(tmp_path / "out.csv", b"new")
    write_manifest(tmp_path, Manifest(name="a", left="left.mp4"))
    assert (tmp_path / "out.csv").read_bytes() == b"new"
    assert (tmp_path / "recording.toml").is_file()


def test_a_file_is_on_the_disk_before_its_name_and_its_name_before_it_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps: list[str] = []
    sync, replace = os.fsync, Path.replace

    def noted_sync(handle: int) -> None:
        steps.append("folder" if stat.S_ISDIR(os.fstat(handle).st_mode) else "file")
        sync(handle)

    def noted_replace(self: Path, target: Path) -> Path:
        steps.append("name")
        return replace(self, target)

    monkeypatch.setattr(os, "fsync", noted_sync)
    monkeypatch.setattr(Path, "replace", noted_replace)
    with part_of(tmp_path / "out.h5") as part:
        part.write_bytes(b"by a library")
    assert steps == ["file", "name", "folder"]


def test_a_manifest_and_a_calibration_are_not_written_through_planted_links(
    tmp_path: Path, victim: Path
) -> None:
    for name in (".recording.toml.unfinished", ".calibration.yaml.unfinished"):
        (tmp_path / name).symlink_to(victim)
    write_manifest(tmp_path, Manifest(name="a", left="left.mp4"))
    camera = Camera(np.eye(3), np.zeros(5), 640, 480)
    both = StereoCalibration(camera, camera, np.eye(3), np.array([-0.1, 0, 0]))
    write_calibration(tmp_path / "calibration.yaml", both)
    assert victim.read_bytes() == b"precious"
    assert not (tmp_path / "recording.toml").is_symlink()
    (tmp_path / "recording.toml").unlink()
    (tmp_path / "recording.toml").symlink_to(victim)
    with pytest.raises(OutputError, match="is a link, which is not written through"):
        write_manifest(tmp_path, Manifest(name="a", left="left.mp4"))
    assert victim.read_bytes() == b"precious"


def test_a_name_as_long_as_a_disk_takes_is_written(tmp_path: Path) -> None:
    replace_with(tmp_path / f"{'n' * 251}.csv", b"new")
    assert (tmp_path / f"{'n' * 251}.csv").read_bytes() == b"new"


def test_an_error_within_the_block_leaves_nothing_new(tmp_path: Path) -> None:
    (tmp_path / "out.csv").write_bytes(b"old")

    def stopped() -> None:
        with replacing(tmp_path / "out.csv") as stream:
            stream.write("half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        stopped()
    assert [file.name for file in tmp_path.iterdir()] == ["out.csv"]
    assert (tmp_path / "out.csv").read_bytes() == b"old"


def test_a_new_folder_may_be_read_by_whom_the_umask_lets(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        with replacing_folder(tmp_path / "made") as folder:
            (folder / "a").write_text("a")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "made").stat().st_mode) == 0o700
    assert [file.name for file in tmp_path.iterdir()] == ["made"]


def test_an_empty_folder_keeps_its_permissions(tmp_path: Path) -> None:
    (tmp_path / "made").mkdir()
    (tmp_path / "made").chmod(0o2750)
    with replacing_folder(tmp_path / "made") as folder:
        (folder / "a").write_text("a")
    assert stat.S_IMODE((tmp_path / "made").stat().st_mode) == 0o2750
    assert (tmp_path / "made" / "a").read_text() == "a"


def test_an_unfinished_folder_leaves_nothing(tmp_path: Path) -> None:
    def interrupted() -> None:
        with replacing_folder(tmp_path / "a" / "b") as folder:
            (folder / "c").write_text("c")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_is_made_on_a_disk_that_cannot_sync_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    really = os.fsync

    def only_files(handle: int) -> None:
        if stat.S_ISDIR(os.fstat(handle).st_mode):
            raise OSError(22, "Invalid argument")
        really(handle)

    monkeypatch.setattr(os, "fsync", only_files)
    with replacing_folder(tmp_path / "made") as folder:
        (folder / "a").write_text("a")
    assert (tmp_path / "made" / "a").read_text() == "a"


@pytest.mark.parametrize("open_one", [replacing, replacing_bytes, part_of, replacing_folder])
@pytest.mark.parametrize(
    "error",
    [
        OSError(errno.EIO, "Input/output error", "/footage/left.mp4"),
        BrokenPipeError(errno.EPIPE, "Broken pipe"),
    ],
    ids=["a file that is read", "whoever reads along is gone"],
)
def test_an_error_of_another_file_is_not_told_as_one_of_the_output(
    tmp_path: Path, open_one: Callable[[Path], AbstractContextManager[Any]], error: OSError
) -> None:
    with pytest.raises(OSError, match=error.strerror) as told, open_one(tmp_path / "out"):
        raise error
    assert told.value is error
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("open_one", [part_of, replacing_folder])
@pytest.mark.parametrize("names_it", [True, False])
def test_an_error_of_the_unfinished_output_is_told_of_the_output(
    tmp_path: Path, open_one: Callable[[Path], AbstractContextManager[Path]], names_it: bool
) -> None:
    def fails() -> None:
        with open_one(tmp_path / "out") as part:
            name = (str(part / "0.png"),) if names_it else ()
            raise OSError(errno.ENOSPC, "No space left on device", *name)

    with pytest.raises(OutputError, match=r"cannot write .*/out: No space left"):
        fails()


def test_every_folder_that_is_made_above_a_new_one_lasts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[Path] = []
    monkeypatch.setattr("tracking.atomic_output.sync_folder", synced.append)
    with replacing_folder(tmp_path / "a" / "b" / "made") as folder:
        (folder / "c").write_text("c")
    assert {tmp_path, tmp_path / "a", tmp_path / "a" / "b"} <= set(synced)
