from __future__ import annotations

import errno
import os
import tracemalloc
from contextlib import closing
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.errors import SessionError
from tracking.session.image_file import ImageFile
from tracking.session.runs import copy_group
from tracking.session.table_writer import Packer

ROWS = 300_000
FLOAT = np.dtype(np.float64)


def write(path: Path, values: NDArray[np.float64], texts: list[str]) -> None:
    with closing(ImageFile(path)) as image:
        with h5py.File(image, "w") as file:
            file.attrs["name"] = "a session"
            group = file.create_group("runs/0/tracks")
            Packer(image).column(group, "x", values, FLOAT).attrs["unit"] = "m"
            group.create_dataset("text", data=texts, dtype=h5py.string_dtype())
        image.finish()
        image.verify()


def noise(rows: int) -> NDArray[np.float64]:
    return np.random.default_rng(3101).random(rows)


@settings(deadline=None)  # it waits for the disk
@given(rows=st.sampled_from([0, 1, 7, 65_535, 65_536, 65_537, 200_000]), text=st.text("aä\n"))
def test_what_is_written_is_an_ordinary_file_of_the_library(tmp_path_factory, rows, text):
    path = tmp_path_factory.mktemp("image") / "s.h5"
    values = noise(rows)
    write(path, values, [text] * 3)
    with h5py.File(path) as file:
        assert file.attrs["name"] == "a session"
        assert file["runs/0/tracks/x"][()].tobytes() == values.tobytes()
        assert list(file["runs/0/tracks/text"].asstr()[()]) == [text] * 3


def test_columns_are_not_held_in_memory(tmp_path):
    values = noise(4_000_000)
    write(tmp_path / "warm.h5", values[:10], [])
    tracemalloc.start()
    write(tmp_path / "s.h5", values, [])
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    packed = (tmp_path / "s.h5").stat().st_size
    # A few pieces are held, more of them the more threads pack at the same moment: some 12 MB.
    assert most < 0.6 * min(packed, values.nbytes)


@pytest.mark.parametrize("after", range(7))
def test_a_disk_that_refuses_raises_its_own_error_and_leaves_the_library_whole(
    tmp_path, monkeypatch, after
):
    write_bytes, calls = os.write, []

    def refusing(handle: int, data: memoryview) -> int:
        calls.append(len(data))
        if len(calls) > after:
            raise OSError(errno.ENOSPC, "No space left on device")
        return write_bytes(handle, data)

    monkeypatch.setattr(os, "write", refusing)
    with pytest.raises(OSError, match="No space left"):
        write(tmp_path / "s.h5", noise(ROWS), ["text"])
    monkeypatch.undo()
    write(tmp_path / "s.h5", noise(ROWS), ["text"])
    with h5py.File(tmp_path / "s.h5") as file:
        assert len(file["runs/0/tracks/x"]) == ROWS


@pytest.mark.parametrize("part", ["piece", "structure"])
def test_one_byte_that_reads_back_otherwise_is_found(tmp_path, part):
    path = tmp_path / "s.h5"
    with closing(ImageFile(path)) as image:
        with h5py.File(image, "w") as file:
            dataset = Packer(image).column(file, "x", noise(ROWS), FLOAT)
            place = dataset.id.get_chunk_info(2).byte_offset + 100 if part == "piece" else 30
        image.finish()
        image.verify()
        with path.open("r+b") as changed:
            changed.seek(place)
            byte = changed.read(1)[0]
            changed.seek(place)
            changed.write(bytes([byte ^ 1]))
        with pytest.raises(OSError, match="reads back otherwise"):
            image.verify()


def test_a_file_that_was_cut_short_is_found(tmp_path):
    path = tmp_path / "s.h5"
    with closing(ImageFile(path)) as image:
        with h5py.File(image, "w") as file:
            Packer(image).column(file, "x", noise(ROWS), FLOAT)
        image.finish()
        os.truncate(path, path.stat().st_size - 1)
        with pytest.raises(OSError, match="reads back with"):
            image.verify()


def copied(source: Path, target: Path) -> None:
    with closing(ImageFile(target)) as image:
        with h5py.File(image, "w") as file:
            copy_group(source, "runs", image, file.create_group("runs"))
        image.finish()
        image.verify()


def test_a_group_is_copied_with_all_it_holds(tmp_path):
    write(tmp_path / "s.h5", noise(ROWS), ["one", "two"])
    copied(tmp_path / "s.h5", tmp_path / "copy.h5")
    with h5py.File(tmp_path / "copy.h5") as file:
        assert file["runs/0/tracks/x"][()].tobytes() == noise(ROWS).tobytes()
        assert file["runs/0/tracks/x"].attrs["unit"] == "m"
        assert list(file["runs/0/tracks/text"].asstr()[()]) == ["one", "two"]


def test_what_fails_on_the_new_disk_is_not_blamed_on_the_old_file(tmp_path, monkeypatch):
    write(tmp_path / "s.h5", noise(ROWS), [])

    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "write", full)
    with pytest.raises(OSError, match="No space left"):
        copied(tmp_path / "s.h5", tmp_path / "copy.h5")


def test_an_old_file_that_lost_its_end_is_blamed(tmp_path):
    source = tmp_path / "s.h5"
    write(source, noise(ROWS), [])
    os.truncate(source, source.stat().st_size // 2)
    with pytest.raises(SessionError, match="damaged or cut short"):
        copied(source, tmp_path / "copy.h5")
