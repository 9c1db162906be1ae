from __future__ import annotations

import gc
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tracking.errors import OutputError
from tracking.pipeline import spool as room
from tracking.pipeline.spool import Spool


def test_what_is_put_aside_is_read_again_from_memory_and_from_the_disk(tmp_path: Path):
    spool = Spool(tmp_path, in_memory=10)
    first = spool.append(b"eight by")
    assert not spool.is_on_disk
    second = spool.append(b"tes more")
    assert spool.is_on_disk
    assert (spool.read(first, 8), spool.read(second, 8)) == (b"eight by", b"tes more")
    assert spool.read(first + 6, 5) == b"bytes"
    assert spool.size == 16


@pytest.mark.skipif(sys.platform == "win32", reason="the name goes with the last handle there")
def test_the_file_has_no_name(tmp_path: Path):
    spool = Spool(tmp_path, in_memory=0)
    spool.append(b"particles")
    assert list(tmp_path.iterdir()) == []


def open_files() -> int:
    return sum(1 for _ in Path("/proc/self/fd").iterdir())


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="the system does not tell")
def test_the_file_is_let_go_with_the_last_who_uses_it(tmp_path: Path):
    gc.collect()  # what earlier tests left
    before = open_files()
    spool = Spool(tmp_path, in_memory=0)
    spool.append(b"particles")
    assert open_files() == before + 1
    del spool
    gc.collect()
    assert open_files() == before


KILLED = """
import os, signal, sys
from pathlib import Path
from tracking.pipeline.spool import Spool
spool = Spool(Path(sys.argv[1]), in_memory=0)
spool.append(b"particles" * 100_000)
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
def test_nothing_is_left_where_the_program_is_killed(tmp_path: Path):
    done = subprocess.run([sys.executable, "-c", KILLED, str(tmp_path)], check=False)
    assert done.returncode < 0
    assert list(tmp_path.iterdir()) == []


def test_a_disk_without_room_is_told_in_a_line_and_what_is_held_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    spool = Spool(tmp_path, in_memory=10)
    place = spool.append(b"kept")
    full = SimpleNamespace(disk_usage=lambda _: SimpleNamespace(free=room.LEAST_FREE_BYTES))
    monkeypatch.setattr(room, "shutil", full)
    with pytest.raises(OutputError) as told:
        spool.append(b"too many bytes")
    assert str(told.value) == (
        f"{tmp_path}: particles cannot be put aside while tracking: too little space is left; "
        "make room there, or track a shorter range"
    )
    monkeypatch.undo()
    assert spool.read(place, 4) == b"kept"
    assert spool.read(spool.append(b"room by now"), 11) == b"room by now"


def test_a_folder_that_is_not_there_is_told_in_a_line(tmp_path: Path):
    with pytest.raises(OutputError, match="gone: particles cannot be put aside while tracking: "):
        Spool(tmp_path / "gone", in_memory=0).append(b"particles")


def test_without_a_folder_it_lies_in_the_users_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(room, "user_cache_path", lambda *_, **__: tmp_path / "cache")
    spool = Spool(in_memory=0)
    assert spool.read(spool.append(b"particles"), 9) == b"particles"
    assert (tmp_path / "cache").is_dir()
