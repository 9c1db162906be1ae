"""Terminals whose encoding lacks letters of a name: escaped there, UTF-8 in files."""

from __future__ import annotations

import fcntl
import json
import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from tracking.editing import plan_rename
from tracking.session import Session

CHECKOUT = Path(__file__).parents[3]
NAME = "入口のé人"
ESCAPED = {
    "latin-1": "\\u5165\\u53e3\\u306e\xe9\\u4eba",
    "ascii": "\\u5165\\u53e3\\u306e\\xe9\\u4eba",
}


@pytest.fixture
def named(session: Path, tmp_path: Path) -> Path:
    """A session of a Japanese name in which somebody has one."""
    place = session.rename(tmp_path / f"{NAME}.h5")
    with closing(Session.open(place)) as opened:
        opened.author = NAME
        track = opened.tracks.track_ids[0]
        opened.apply(plan_rename(opened.tracks, opened.labels, track, NAME))
        opened.save()
    return place


def run_in(encoding: str, *words: str | Path) -> subprocess.CompletedProcess[bytes]:
    """A command as a process of its own, with that encoding of its stdout and stderr."""
    return subprocess.run(
        [sys.executable, "-m", "app", *map(str, words)],
        cwd=CHECKOUT,
        env={**os.environ, "PYTHONIOENCODING": encoding},
        capture_output=True,
        timeout=120,
    )


@pytest.mark.parametrize("encoding", ["latin-1", "ascii:strict"])
def test_every_command_escapes_what_the_terminal_lacks(
    named: Path, tmp_path: Path, encoding: str
) -> None:
    line = f"{NAME}:0,0:1,9"
    out = tmp_path / f"{NAME}.txt"
    told = ESCAPED[encoding.partition(":")[0]]
    for status, words in (
        (0, ("info", named)),
        (0, ("log", named)),
        (0, ("count", named, "--line", line)),
        (0, ("review", named)),
        (0, ("compare", named, named)),
        (0, ("export", named, "-o", out, "--format", "mot")),
        (0, ("restore", named, "--list")),
        (1, ("info", tmp_path / f"no {NAME}")),
        (1, ("import", out, "-r", tmp_path / NAME, "-o", tmp_path / "new.h5")),
        (2, ("track", named, "--tracker", NAME, "-o", tmp_path / "new.h5")),
        (2, (NAME,)),
        (2, ("info", f"--{NAME}")),
    ):
        done = run_in(encoding, *words)
        printed = (done.stdout + done.stderr).decode(encoding.partition(":")[0])
        assert done.returncode == status, printed
        assert "bug" not in printed
        assert told in printed or words[0] in ("review", "compare", "restore"), printed


def test_files_and_documents_on_stdout_are_utf_8_whatever_the_terminal_takes(
    named: Path, tmp_path: Path
) -> None:
    out = tmp_path / "log.csv"
    assert run_in("ascii:strict", "log", named, "--csv", out).returncode == 0
    assert NAME in out.read_text(encoding="utf-8")
    assert run_in("ascii:strict", "log", named, "--csv", "-").stdout == out.read_bytes()
    done = run_in("ascii:strict", "info", named, "--json")
    assert json.loads(done.stdout)["path"] == str(named)


def test_a_closed_stdout_and_a_full_one_are_no_bug(named: Path) -> None:
    command = f'"{sys.executable}" -m app info "{named}"'
    for where, status in ((">&-", 0), (">/dev/full", 1)):
        done = subprocess.run(
            ["bash", "-c", f"{command} {where}"], cwd=CHECKOUT, capture_output=True, timeout=120
        )
        assert done.returncode == status, done.stderr
        assert b"bug" not in done.stderr
        assert done.stderr.count(b"\n") == status, done.stderr


def sealed() -> int:
    """A file that nobody may write to any more, though it is open for writing."""
    descriptor = os.memfd_create("sealed", os.MFD_ALLOW_SEALING)
    fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_WRITE | fcntl.F_SEAL_GROW)
    return descriptor


def read_only() -> int:
    return os.open(os.devnull, os.O_RDONLY)


@pytest.mark.skipif(sys.platform != "linux", reason="sealed files")
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize(
    ("stdout", "why"),
    [(sealed, "Operation not permitted"), (read_only, "Bad file descriptor")],
)
def test_a_stdout_that_may_not_be_written_is_told_in_one_line(
    stdout: Callable[[], int], why: str, unbuffered: str
) -> None:
    descriptor = stdout()
    try:
        done = subprocess.run(
            [sys.executable, "-m", "app", "--help"],
            cwd=CHECKOUT,
            env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
            stdout=descriptor,
            stderr=subprocess.PIPE,
            text=True,
            timeout=120,
        )
    finally:
        os.close(descriptor)
    line = f"trackwright: cannot write to stdout: {why}; send it to another file or program\n"
    assert (done.returncode, done.stderr) == (1, line)
