"""How long a project takes: `python -m tests.benchmarks.project [--recordings 500]`.

So many recordings of 24 small images, tracked by a batch, every other one with ground truth. Told
are seconds by the clock and of the processor, the reading process's included.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import TypeVar

from app.features.project.presenter import scene_of
from tests.batch.walks import make_walk
from tracking.project import Project, ProjectList, ReaderProcess

_ROOT = Path(__file__).parents[2]
_T = TypeVar("_T")


def main() -> None:
    """Make the recordings, track them, and look through them."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.project", description=__doc__)
    parser.add_argument("--recordings", type=int, default=500)
    count = parser.parse_args().recordings
    with tempfile.TemporaryDirectory() as temporary:
        top = Path(temporary) / "recordings"
        for number in range(count):
            make_walk(top / f"walk{number:04}", number, truth=number % 2 == 0)
        measure(top, Path(temporary) / "cache")
        track_all(top)
        measure(top, Path(temporary) / "cache")
    print(f"load {os.getloadavg()[0]:.1f}")


def track_all(top: Path) -> None:
    """A session for each recording, by the real command."""
    words = ("batch", str(top), "-o", str(top / "results"), "--tracker", "three-part")
    command = [sys.executable, "-m", "app", *words, "--no-pages"]
    subprocess.run(command, cwd=_ROOT, check=True, capture_output=True)


def measure(top: Path, cache: Path) -> None:
    """Print what the window does with a folder, step by step."""
    with closing(Project(top, cache)) as project:
        found = timed("names, times and locks", project.look)
        sessions = sum(len(row.sessions) for row in found.rows)
        print(f"{len(found.rows)} recordings, {sessions} sessions, {len(found.wanted)} to be read")
        timed("reading them", lambda: read_all(project, found))
        found = timed("looked through once more", project.look)
        assert not found.wanted
        timed("the list in words", lambda: scene_of(found, top, None))
    with closing(Project(top, cache)) as project:
        found = timed("opened again", project.look)
        assert not found.wanted


def read_all(project: Project, found: ProjectList) -> None:
    """Read what is wanted as the window does, in a process beside it."""
    with ReaderProcess() as reader:
        project.read(found.wanted, reader, lambda *_: None)


def timed(name: str, work: Callable[[], _T]) -> _T:
    """Do it, and print how long it took."""
    began_s, before = time.perf_counter(), os.times()
    done = work()
    after = os.times()
    spent_s = sum(after[:4]) - sum(before[:4])
    print(f"{name:28} {time.perf_counter() - began_s:8.2f} s, processor {spent_s:6.2f} s")
    return done


if __name__ == "__main__":
    main()
