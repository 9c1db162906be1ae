"""What all sweeps share: options, workers, progress, violations, figures and the exit status.

A sweep is a function that takes a `Worker`, goes through the runs the worker has for it, and yields
what must not be. What is random comes from `Worker.chance`, so that a run can be seen again alone.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import os
import random
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

_PROGRESS_EVERY_S = 60.0
_ROOM_BYTES = 4 << 30
_MOST_SHOWN = 2000
"""Letters of one violation that are printed."""
RAISED = 99
"""The exit status of a fork whose work raised something."""
Case = TypeVar("Case")


@dataclass(slots=True)
class Worker:
    """One of the forks that share a sweep's runs.

    Attributes:
        folder: of its own. asked: the options. place: which of the workers it is, from 0.
        command: what was typed. until_s: when it stops, by the monotonic clock.
        counts: what it did, by name. violations: how many it found. run: the one it is at.
    """

    folder: Path
    asked: argparse.Namespace
    place: int
    command: str
    until_s: float
    counts: Counter[str] = field(default_factory=Counter)
    violations: int = 0
    run: int = 0
    _told_s: float = field(default_factory=time.monotonic)

    @property
    def numbers(self) -> Iterator[int]:
        """The runs of this worker, until the time is up."""
        return self.of(range(self.asked.resume + self.asked.runs))

    def of(self, cases: Sequence[Case]) -> Iterator[Case]:
        """Those of a list of cases, a run each, that are this worker's, until the time is up."""
        first, end = self.asked.resume, self.asked.resume + self.asked.runs
        for run in range(first + self.place, min(end, len(cases)), self.asked.workers):
            self.run = run
            if self.is_over:
                break
            yield cases[run]
            if time.monotonic() - self._told_s > _PROGRESS_EVERY_S:
                self._told_s = time.monotonic()
                told = f"run {self.run}: {figures(self.counts)}; {self.violations} violations"
                print(f"... {told}", flush=True)
        else:
            self.run = end

    @property
    def is_over(self) -> bool:
        """Whether the time is up."""
        return time.monotonic() > self.until_s

    def chance(self, *what: object) -> random.Random:
        """Random numbers of this run, or of what else they are for."""
        return random.Random("/".join(map(str, (self.asked.seed, *(what or (self.run,))))))

    def count(self, what: str, many: int = 1) -> None:
        """Count something."""
        self.counts[what] += many

    def report(self, violation: str) -> None:
        """Print what must not be, and how to see it again."""
        self.violations += 1
        print(f"VIOLATION run {self.run}: {violation[:_MOST_SHOWN]}")
        print(f"  again: {self.command} --resume {self.run} --runs 1", flush=True)


Attack = Callable[[Worker], Iterator[str]]
"""Does the runs of a worker; yields violations."""
Options = Mapping[str, Mapping[str, Any]]


def sweep(attack: Attack, runs: int, workers: int = 2, options: Options | None = None) -> int:
    """Do all runs the command line asks for; gives the exit status.

    Violations are printed as they are found, then the run's row of `docs/reliability.md`, then one
    line of JSON.

    Args:
        runs, workers: where the command line says nothing.
        options: the sweep's own, as `argparse` takes them.
    """
    name, words = Path(sys.argv[0]).stem, sys.argv[1:]
    if words and words[0].isdigit():
        words.insert(0, "--runs")
    command = " ".join((f"python -m tests.sweeps.{name}", *words))
    asked, began_s = _asked(attack, words, runs, workers, options or {}), time.monotonic()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with tempfile.TemporaryDirectory(prefix="trackwright-", dir=_in_memory()) as top:
        own_user(Path(top) / "user")
        until_s = began_s + asked.seconds
        made = [
            Worker(Path(top) / str(place), asked, place, command, until_s)
            for place in range(min(asked.workers, asked.runs))
        ]
        if len(made) == 1:
            told = [_do(made[0], attack)]
        else:
            told = _heard(
                [(one.folder, forked(lambda one=one: _save(one, attack))) for one in made]
            )
    counts, lasted_s = Counter[str](), time.monotonic() - began_s
    for one in told:
        counts.update(one["counts"])
    is_whole = all(one["run"] >= asked.resume + asked.runs for one in told)
    lasted = f"{lasted_s / 60:.0f} minutes" if lasted_s > 99 else f"{lasted_s:.0f} s"
    print(f"| `{command}` | {'whole, ' * is_whole}{lasted}: {figures(counts)} |")
    said = {"sweep": name, "runs": asked.runs, "seed": asked.seed, "seconds": round(lasted_s)}
    said |= {"counts": counts, "violations": sum(one["violations"] for one in told)}
    print(json.dumps(said if is_whole else {**said, "resume": min(one["run"] for one in told)}))
    return int(said["violations"] > 0)


def _asked(
    attack: Attack, words: Sequence[str], runs: int, workers: int, options: Options
) -> argparse.Namespace:
    described = sys.modules[attack.__module__].__doc__ or ""
    parser = argparse.ArgumentParser(description=described.partition("\n")[0])
    parser.add_argument("--runs", type=int, default=runs)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=workers)
    parser.add_argument("--seconds", type=float, default=math.inf, help="stop after so long")
    parser.add_argument("--resume", type=int, default=0, metavar="RUN", help="the first run")
    for option, how in options.items():
        parser.add_argument(option, **how)
    return parser.parse_args(words)


def _do(worker: Worker, attack: Attack) -> dict[str, Any]:
    """A worker's whole life; what it found."""
    worker.folder.mkdir()
    try:
        for violation in attack(worker):
            worker.report(violation)
    except Exception:  # of the sweep itself, or of what it called: worth a look in any case
        worker.report(traceback.format_exc()[-_MOST_SHOWN:])
    return {"counts": worker.counts, "violations": worker.violations, "run": worker.run}


def _save(worker: Worker, attack: Attack) -> None:
    """The same in a fork."""
    told = _do(worker, attack)
    (worker.folder / "told.json").write_text(json.dumps(told))


def _heard(workers: Sequence[tuple[Path, int]]) -> list[dict[str, Any]]:
    """What each worker found, once it has ended."""
    told: list[dict[str, Any]] = []
    try:
        for folder, pid in workers:
            if status := ended(pid):
                print(f"VIOLATION a worker ended with {status}", flush=True)
                told.append({"counts": {}, "violations": 1, "run": 0})
            else:
                told.append(json.loads((folder / "told.json").read_text()))
    except KeyboardInterrupt:
        for _, pid in workers:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        raise
    return told


def figures(counts: Mapping[str, int]) -> str:
    """Counts in words."""
    return ", ".join(f"{many:,} {what}" for what, many in counts.items())


def forked(work: Callable[[], int | None]) -> int:
    """Fork off some work, whose result is the exit status; gives the process."""
    sys.stdout.flush()
    pid = os.fork()
    if pid:
        return pid
    status = RAISED
    try:
        status = work() or 0
    except SystemExit as stop:
        status = stop.code if isinstance(stop.code, int) else 1
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


def ended(pid: int) -> int:
    """Wait for a process; its exit status, or the signal that ended it below zero."""
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def _in_memory() -> Path | None:
    """A disk in memory, where there is room on one: waiting for a disk tells a sweep nothing."""
    folder = Path("/dev/shm")
    roomy = folder.is_dir() and shutil.disk_usage(folder).free > _ROOM_BYTES
    return folder if roomy else None


def slowdown() -> float:
    """How much longer things may take here and now than on a machine of one's own."""
    return 1.0 + os.getloadavg()[0]


def own_user(folder: Path) -> None:
    """Keys, settings, caches and logs of this sweep's own: not those of whoever runs it."""
    folder.mkdir(parents=True, exist_ok=True)
    os.environ["HOME"] = str(folder)
    for kind in ("DATA", "CONFIG", "CACHE", "STATE"):
        os.environ[f"XDG_{kind}_HOME"] = str(folder / kind.lower())
    for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
        os.environ[variable] = "1"
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


def emptied(folder: Path) -> Path:
    """The folder, made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder
