"""Reading in a process of its own: what it tells, and what is told where it dies or hangs."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.batch.walks import FRAMES, make_walk
from tracking.project import ReaderProcess, RecordingFacts, reader_process
from tracking.project.readings import Reading

_DIES = "import os; os._exit(9)"
_HANGS = "import time; time.sleep(600)"
_LIES = """
import sys
for line in sys.stdin.buffer:
    sys.stdout.buffer.write(b'{"facts": "{\\\\"name\\\\": 5}", "bytes": 0}\\n')
    sys.stdout.buffer.flush()
"""


def _reading(path: Path) -> Reading:
    return Reading(path, of_session=False)


def test_facts_and_image_come_from_another_process(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "a", truth=True)
    with ReaderProcess() as reader:
        first = reader.read(_reading(walk))
        missing = reader.read(_reading(tmp_path / "none"))
        again = reader.read(_reading(walk))
    assert isinstance(first.facts, RecordingFacts)
    assert (first.facts.frames, first.facts.has_truth) == (FRAMES, True)
    assert first.image.startswith(b"\xff\xd8")
    assert "no such recording" in str(missing.facts.problem)
    assert again == first
    assert str(reader.read(_reading(walk)).facts.problem) == "stopped"


@pytest.mark.parametrize(
    ("program", "patience_s", "why"),
    [
        (_DIES, 60.0, "it is damaged: it cannot be read safely"),
        (_HANGS, 0.5, "reading it took longer than 0.5 s"),
        (_LIES, 60.0, "it is damaged: it cannot be read safely"),
    ],
    ids=["dies", "hangs", "lies"],
)
def test_a_file_that_ends_or_holds_up_its_reader_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, program: str, patience_s: float, why: str
) -> None:
    import subprocess

    began = subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    real = reader_process._started
    children = iter([began])
    monkeypatch.setattr(reader_process, "_started", lambda: next(children, None) or real())
    walk = make_walk(tmp_path / "a")
    with ReaderProcess(patience_s) as reader:
        read = reader.read(_reading(walk))
        assert str(read.facts.problem) == why
        if patience_s > 1:
            assert not reader.read(_reading(walk)).facts.problem  # a new one goes on
