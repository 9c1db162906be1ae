"""What batches cost: `python -m tests.benchmarks.batch resume | speed-up | simulate`.

resume: a batch of N finished recordings begun again, by the real command.
speed-up: recordings tracked by one process, and by two workers; see `measure_speed_up` for how that
is told on a machine whose cores are not idle.
simulate: 64 workers that sleep, and 100,000 recordings: what handing out and the ledger cost.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tests.batch.walks import make_walk, write_manifest
from tracking.batch import (
    BatchOrder,
    BatchRun,
    Doing,
    Limits,
    Outcome,
    State,
    batch_folder,
    find_recordings,
    named_entries,
    write_batch_report,
)
from tracking.batch.order import content_digest
from tracking.batch.signature import signature_of
from tracking.batch.task import Task
from tracking.batch.workers import Do, ThreadedWorkers

_ROOT = Path(__file__).parents[2]
_TRIES = 5
ASKED = BatchOrder(tracker="three-part")


def measure_resume(folder: Path, count: int) -> dict[str, Any]:
    """Seconds that the command takes where all is done, by the clock and of the processor.

    The recordings are folders with a manifest, a calibration and two files, as stereo recordings
    are; what they hold does not count, as nothing of it is read.
    """
    top, out = folder / "recordings", folder / "out"
    for number in range(count):
        one = top / f"rec{number:06}"
        one.mkdir(parents=True)
        write_manifest(one, "left.mp4")
        for name in ("left.mp4", "right.mp4", "calibration.yaml"):
            (one / name).write_bytes(b"x" * 100)
    fill(top, out, sleeping(0.0), 8)
    tried = [
        timed_command("batch", top, "-o", out, "--tracker", "three-part") for _ in range(_TRIES)
    ]
    none = [timed_command("--version") for _ in range(_TRIES)]
    best = min(tried, key=lambda each: each["processor_s"])
    return {
        "finished": count,
        **best,
        "allowed_s": 1.0 + 0.005 * count,
        "version_alone_s": min(each["processor_s"] for each in none),
        "load": os.getloadavg()[0],
    }


def timed_command(*words: object) -> dict[str, float]:
    """Seconds of the real command."""
    began_s, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-m", "app", *map(str, words)]
    subprocess.run(command, cwd=_ROOT, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"clock_s": time.perf_counter() - began_s, "processor_s": spent_s}


def measure_speed_up(folder: Path, count: int, frames: int) -> dict[str, Any]:
    """How much faster two workers are than one process that tracks the same recordings.

    Other programs use the cores, so the clock says nothing. What is measured is the processor time
    of each process: workers compute with one thread each, and wait for nobody (the next task is
    with them before they end one). On two idle cores the batch would therefore take as long as the
    worker that computes longest, but at least half of all that is computed, the program that hands
    out included; and one process as long as it computes. The clock's figures stand beside it.
    """
    top = folder / "recordings"
    for number in range(count):
        make_walk(top / f"walk{number:02}", number, frames)
    alone = measured_batch(top, folder / "one", 1)
    two = measured_batch(top, folder / "two", 2)
    # One process: what hands out is not needed for it, so it does not count.
    one_s = sum(alone["workers_s"])
    lasts_s = max(*two["workers_s"], (sum(two["workers_s"]) + two["driver_s"]) / 2)
    return {
        "recordings": count,
        "one_process_s": one_s,
        "two_workers_s": two["workers_s"],
        "driver_s": two["driver_s"],
        "speed_up": one_s / lasts_s,
        "of_ideal": one_s / lasts_s / 2,
        "clock": {"one_s": alone["clock_s"], "two_s": two["clock_s"]},
        "load": os.getloadavg()[0],
    }


def measured_batch(top: Path, out: Path, workers: int) -> dict[str, Any]:
    """Processor time of each worker (its start included) and of the program that hands out."""
    code = (
        "import json, os, resource, sys, time; from tests.benchmarks.batch import work_and_tell;"
        "work_and_tell(sys.argv[1], sys.argv[2], int(sys.argv[3]))"
    )
    command = [sys.executable, "-c", code, str(top), str(out), str(workers)]
    said = subprocess.run(command, cwd=_ROOT, check=True, capture_output=True, text=True).stdout
    found: dict[str, Any] = json.loads(said.splitlines()[-1])
    return found


def work_and_tell(top: str, out: str, count: int) -> None:
    """Do a batch and print what each process took, as JSON."""
    from tracking.batch import Listener, LocalWorkers

    spent: dict[int, float] = {}

    class Watch(Listener):
        def moved(self, *_: object) -> None:
            for pid in children():
                spent[pid] = processor_s(pid) or spent.get(pid, 0.0)

    began_s = time.perf_counter()
    limits = Limits()
    with batch_folder(Path(out)) as ledger:
        run = BatchRun(ledger, Path(out), ASKED, limits, listener=Watch())
        run.plan(named_entries(find_recordings([top]).paths))
        outcomes = run.work(LocalWorkers(count, limits))
        write_batch_report(ledger, Path(out))
    assert all(outcome.is_done for outcome in outcomes.values())
    print(
        json.dumps(
            {
                "clock_s": time.perf_counter() - began_s,
                "workers_s": sorted(spent.values()),
                "driver_s": time.process_time(),
            }
        )
    )


def children() -> list[int]:
    """The workers of this process."""
    tasks = Path("/proc/self/task").glob("*/children")
    return [int(word) for task in tasks for word in task.read_text().split()]


def processor_s(pid: int) -> float:
    """What a process computed so far; 0: it has gone."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def simulate(folder: Path, count: int, workers: int, sleep_s: float) -> dict[str, Any]:
    """What handing out and the ledger cost with many workers that sleep for a task each."""
    top, out = folder / "recordings", folder / "out"
    top.mkdir()
    for number in range(count):
        (top / f"rec{number:06}.mp4").write_bytes(b"x")
    told = fill(top, out, sleeping(sleep_s), workers)
    again = fill(top, out, sleeping(sleep_s), workers)
    page_s, _ = timed(lambda: _report(out))
    ideal_s = count * sleep_s / workers
    return {
        "recordings": count,
        "workers": workers,
        "sleep_s": sleep_s,
        "ideal_s": ideal_s,
        **told,
        "cost_ms_a_recording": 1000 * (told["work_s"] - ideal_s) / count,
        "processor_ms_a_recording": 1000 * told["processor_s"] / count,
        "again_plan_s": again["plan_s"],
        "report_s": page_s,
        "ledger_mb": (out / "batch.sqlite").stat().st_size / 1e6,
        "load": os.getloadavg()[0],
    }


def _report(out: Path) -> None:
    with batch_folder(out) as ledger:
        write_batch_report(ledger, out)


def sleeping(sleep_s: float) -> Do:
    """A worker that sleeps, and leaves what a real one leaves in the place of a session."""

    def do(task: Task, tell: Callable[[Doing], None]) -> Outcome:
        tell(Doing("", task.name, "tracking"))
        place = task.workplace
        place.session.write_bytes(task.name.encode())
        if sleep_s:
            time.sleep(sleep_s)
        return Outcome(
            State.DONE,
            tracked=True,
            fingerprint="f" * 64,
            signature=signature_of(task.path, (), (), task.out),
            session=content_digest([place.session]),
            tracker="three-part",
            frames=100,
            people=1,
            fps=10.0,
        )

    return do


def fill(top: Path, out: Path, do: Do, workers: int) -> dict[str, float]:
    """Do a batch with workers that are threads; seconds of planning and of working."""
    find_s, found = timed(lambda: find_recordings([str(top)], out).paths)
    began_s = time.process_time()
    with batch_folder(out) as ledger:
        run = BatchRun(ledger, out, ASKED, Limits())
        entries = named_entries(found)
        plan_s, plan = timed(lambda: run.plan(entries))
        work_s = 0.0
        if plan.to_do:
            pool = ThreadedWorkers([do] * workers, ahead=workers)
            work_s, _ = timed(lambda: run.work(pool))
    spent_s = time.process_time() - began_s
    return {"find_s": find_s, "plan_s": plan_s, "work_s": work_s, "processor_s": spent_s}


def timed(act: Callable[[], Any]) -> tuple[float, Any]:
    """Seconds by the clock, and what came of it."""
    began_s = time.perf_counter()
    found = act()
    return time.perf_counter() - began_s, found


@contextmanager
def _folder(named: Path | None) -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="trackwright-batch-", dir=named) as folder:
        yield Path(folder)


def main() -> None:
    """Measure what is asked for and print it as JSON."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("what", choices=("resume", "speed-up", "simulate"))
    parser.add_argument("--recordings", type=int)
    parser.add_argument("--frames", type=int, default=150)
    parser.add_argument("--workers", type=int, default=64)
    parser.add_argument("--sleep", type=float, default=0.05)
    parser.add_argument("--folder", type=Path, help="on the disk that is to be measured")
    asked = parser.parse_args()
    with _folder(asked.folder) as folder:
        if asked.what == "resume":
            found = measure_resume(folder, asked.recordings or 1000)
        elif asked.what == "speed-up":
            found = measure_speed_up(folder, asked.recordings or 12, asked.frames)
        else:
            found = simulate(folder, asked.recordings or 100_000, asked.workers, asked.sleep)
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
