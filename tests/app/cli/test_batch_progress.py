"""What is told while a batch runs: every recording counts once, and the time that is left."""

from __future__ import annotations

import re
import time
from itertools import pairwise
from pathlib import Path

import pytest

from app.cli import batch_progress
from app.cli.batch_progress import BatchProgress
from tests.batch.batches import QUICK, entries_of, here
from tracking.batch import BatchRun, Cause, Limits, Outcome, State, batch_folder, progress
from tracking.batch.outcome import failure
from tracking.batch.progress import Pace
from tracking.batch.task import Task
from tracking.translation import msg

_COUNTS = re.compile(r"(\d+) of (\d+) done, (\d+) failed, (\d+) skipped, (\d+) to do")
_WORK_S = 0.05


def do(task: Task) -> Outcome:
    """Sleep, and end as the recording's name says."""
    time.sleep(_WORK_S)
    if task.name.startswith("bad"):
        return failure(Cause.INPUT, msg("no video"))
    if task.name.startswith("weak"):
        return failure(Cause.WORKER, msg("its worker died"))
    return Outcome(State.SKIPPED, Cause.PROTECTED, msg("it was corrected"))


def run(out: Path, names: list[str], shown: BatchProgress) -> None:
    with batch_folder(out) as ledger:
        batch = BatchRun(ledger, out, QUICK, Limits(), listener=shown)
        batch.plan(entries_of(*(out / name for name in names)))
        batch.work(here(do, 2))


def test_every_recording_counts_once_at_each_moment(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(batch_progress, "_LINE_EVERY_S", 0.0)
    names = ["bad1", "weak1", "kept1", "kept2", "bad2", "weak2", "kept3"]
    run(tmp_path / "out", names, BatchProgress((State.FAILED, State.SKIPPED)))
    told = [tuple(map(int, each)) for each in _COUNTS.findall(capsys.readouterr().err)]
    assert len(told) > 3
    assert all(
        done + failed + skipped + left == total for done, total, failed, skipped, left in told
    )
    assert {total for _, total, *_ in told} == {len(names) + 2}
    assert told[-1] == (0, 9, 5, 4, 0)
    assert all(before[2:4] <= after[2:4] for before, after in pairwise(told))


def test_the_time_left_counts_recordings_and_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    now_s = 100.0
    monkeypatch.setattr(progress.time, "monotonic", lambda: now_s)
    pace = Pace()
    pace.begin([100, 100, 400])
    assert pace.seconds_left(0.0) is None
    now_s = 110.0
    pace.end(100)  # weight 0.75 of 3
    assert pace.seconds_left(0.0) == pytest.approx(30.0)
    assert pace.seconds_left(0.75) == pytest.approx(10.0)
    pace.end(100)
    pace.end(400)
    assert pace.seconds_left(0.0) == 0.0
