"""A batch on a Dask cluster."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.batch.batches import ledger_of, leftovers
from tests.batch.test_worker_limits import same_rows, tracked_alone
from tests.batch.walks import make_damaged, make_walk

pytest.importorskip("distributed", reason="the extra cluster is not installed")
_ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def scheduler() -> Iterator[str]:
    """The address of a cluster's scheduler."""
    command = [sys.executable, "-m", "tests.batch.local_cluster"]
    with subprocess.Popen(
        command, cwd=_ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as cluster:
        assert cluster.stdout is not None
        yield cluster.stdout.readline().strip()
        assert cluster.stdin is not None
        cluster.stdin.close()


def started(*words: object) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "app", "batch", *map(str, words)]
    return subprocess.Popen(
        command, cwd=_ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


@pytest.mark.slow
def test_a_cluster_makes_what_this_machine_makes(scheduler: str, tmp_path: Path) -> None:
    walks = [make_walk(tmp_path / "walks" / f"walk{n}", n) for n in range(3)]
    make_damaged(tmp_path / "walks" / "bad", 2)
    out = tmp_path / "out"
    asked = (tmp_path / "walks", "-o", out, "--scheduler", scheduler, "--json", "--no-pages")
    program = started(*asked, "--tracker", "three-part")
    said, told = program.communicate(timeout=300)
    assert program.returncode == 3, told
    assert json.loads(said)["done"] == ["walk0", "walk1", "walk2"]
    assert list(json.loads(said)["failed"]) == ["bad"]
    for walk in walks:
        assert same_rows(out / f"{walk.name}.h5", tracked_alone(walk, tmp_path / "alone"))
    attempts = ledger_of(out)[1]
    assert len(attempts) == 4
    assert all(attempt.worker for attempt in attempts)
    assert leftovers(out) == []


@pytest.mark.slow
def test_ctrl_c_ends_the_work_on_a_cluster(scheduler: str, tmp_path: Path) -> None:
    make_walk(tmp_path / "walk", frames=400)
    out = tmp_path / "out"
    program = started(tmp_path / "walk", "-o", out, "--scheduler", scheduler)
    while not list(out.glob(".batch-alive-*")):
        time.sleep(0.1)
    time.sleep(1.0)
    program.send_signal(signal.SIGINT)
    _, told = program.communicate(timeout=60)
    assert program.returncode == 130, told
    assert "the same command goes on" in told


def test_a_scheduler_that_does_not_answer_is_told(tmp_path: Path) -> None:
    make_walk(tmp_path / "walk")
    program = started(tmp_path / "walk", "-o", tmp_path / "out", "--scheduler", "tcp://127.0.0.1:9")
    _, told = program.communicate(timeout=120)
    assert program.returncode == 1
    assert "no Dask scheduler answers" in told
    assert "Traceback" not in told
