"""Worker processes and recordings that are bad for them."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from tests.batch.batches import QUICK, entries_of, ledger_of, leftovers
from tests.batch.walks import make_damaged, make_walk
from tracking.batch import (
    BatchRun,
    Cause,
    Limits,
    LocalWorkers,
    Outcome,
    State,
    batch_folder,
    worker_process,
)
from tracking.batch.job import do_task
from tracking.batch.order import BatchOrder
from tracking.batch.plan import Planner
from tracking.batch.task import Task
from tracking.batch.worker_process import WorkerProcess
from tracking.session import Session

FAULTY = ("-m", "tests.batch.faulty_worker")
LIMITS = Limits(stall_s=4.0, memory_bytes=400 << 20)
pytestmark = pytest.mark.skipif(os.name == "nt", reason="workers are killed by signals here")


def batch_by_processes(
    out: Path, folders: list[Path], count: int, order: BatchOrder = QUICK
) -> dict[str, Outcome]:
    with batch_folder(out) as ledger:
        run = BatchRun(ledger, out, order, LIMITS)
        run.plan(entries_of(*folders))
        return dict(run.work(LocalWorkers(count, LIMITS, FAULTY)))


@pytest.mark.slow
def test_a_batch_survives_whatever_its_recordings_do(tmp_path: Path) -> None:
    good = [make_walk(tmp_path / f"walk{n}", n, truth=n == 0) for n in range(3)]
    damaged = [make_damaged(tmp_path / f"bad{n}", n) for n in range(5)]
    bad = [make_walk(tmp_path / name) for name in ("killer", "bomb", "hang", "flaky")]
    out = tmp_path / "out"
    outcomes = batch_by_processes(out, [*bad, *damaged, *good], 3)
    done = {name for name, outcome in outcomes.items() if outcome.is_done}
    assert done == {*(folder.name for folder in good), "flaky"}
    causes = {name: outcome.cause for name, outcome in outcomes.items() if name not in done}
    assert causes == {
        **{folder.name: Cause.INPUT for folder in damaged},
        "killer": Cause.WORKER,
        "bomb": Cause.LIMIT,
        "hang": Cause.LIMIT,
    }
    assert all(outcome.why for outcome in outcomes.values() if not outcome.is_done)
    assert "SIGKILL" in outcomes["killer"].why
    assert "memory" in outcomes["bomb"].why
    assert "--stall-limit" in outcomes["hang"].why
    tries = [attempt.name for attempt in ledger_of(out)[1]]
    assert {name: tries.count(name) for name in set(tries)} == {
        **{folder.name: 1 for folder in (*good, *damaged)},
        "killer": 3,
        "bomb": 1,
        "hang": 1,
        "flaky": 3,
    }
    assert leftovers(out) == []
    for folder in good:
        assert same_rows(out / f"{folder.name}.h5", tracked_alone(folder, tmp_path / "alone"))


def tracked_alone(folder: Path, out: Path) -> Path:
    """The session of a recording that this process tracked."""
    out.mkdir(exist_ok=True)
    task = Task(folder.name, folder, out, f"alone-{folder.name}", QUICK, "", "")
    assert do_task(task, lambda *_: None).is_done
    return task.workplace.session


def same_rows(a: Path, b: Path) -> bool:
    """Whether two sessions hold the same tracks to the last bit."""
    with closing(Session.look_into(a)) as one, closing(Session.look_into(b)) as other:
        mine, theirs = one.tracks.columns(), other.tracks.columns()
        return all(mine[name].tobytes() == theirs[name].tobytes() for name in theirs)


def task_of(walk: Path, out: Path, token: str = "01") -> Task:
    out.mkdir(exist_ok=True)
    asked = Planner(QUICK, LIMITS, out).asked
    return Task(walk.name, walk, out, token, QUICK, asked, "", memory_bytes=LIMITS.memory_bytes)


@pytest.fixture
def process() -> WorkerProcess:
    made = WorkerProcess("1", LIMITS, FAULTY)
    yield made
    made.close()
    made.wait()


def meanwhile(act: Callable[[], None]) -> threading.Thread:
    thread = threading.Thread(target=act)
    thread.start()
    return thread


def test_a_worker_ends_when_nobody_wants_its_work_any_more(
    process: WorkerProcess, tmp_path: Path
) -> None:
    task = task_of(make_walk(tmp_path / "hang"), tmp_path / "out")
    told = threading.Event()
    assert process.do(task, lambda _: told.set(), told.is_set) is None


def test_a_worker_ends_with_whoever_started_it(process: WorkerProcess, tmp_path: Path) -> None:
    task = task_of(make_walk(tmp_path / "hang"), tmp_path / "out")
    pids: list[int] = []

    def act() -> None:
        while not process.pid:
            time.sleep(0.01)
        pids.append(process.pid)
        assert process._child is not None
        assert process._child.stdin is not None
        time.sleep(1.0)
        process._child.stdin.close()  # as the system does when the program is killed

    thread = meanwhile(act)
    outcome = process.do(task, lambda _: None)
    thread.join()
    assert outcome is not None
    assert (outcome.state, outcome.cause) == (State.FAILED, Cause.WORKER)
    with pytest.raises(ProcessLookupError):
        os.kill(pids[0], signal.SIGKILL)


def test_a_worker_that_does_not_start_is_told_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(worker_process, "_BORN_WITHIN_S", 0.5)
    process = WorkerProcess("1", Limits(), ("-c", "import time; time.sleep(60)"))
    outcome = process.do(Task("walk", tmp_path, tmp_path, "token", QUICK, "", ""), lambda _: None)
    process.close()
    process.wait()
    assert outcome is not None
    assert outcome.cause is Cause.WORKER
    assert outcome.why == "its worker did not start within 0.5 s"
