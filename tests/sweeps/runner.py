"""What all sweeps share: options, workers, one summary line, and the exit status.

A sweep hands over a function that does the runs of the given numbers in a folder of its own and
notes what it sees in `Findings`. Each worker is a fork, so that what is imported is imported once.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import os
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

_TELL_EVERY_S = 60.0
_ROOM_BYTES = 4 << 30
_MOST_SHOWN = 2000
"""Letters of one violation that are printed."""


@dataclass(frozen=True, slots=True)
class Plan:
    """How much of a sweep is asked for.

    Attributes:
        runs, seed, workers: so many runs, drawn from a seed, by so many workers.
        seconds: it stops after so long, with what is done by then.
    """

    runs: int
    seed: int
    workers: int
    seconds: float = math.inf


@dataclass(slots=True)
class Findings:
    """What one worker saw: counts by name, and violations, which are printed at once.

    until_s: when it stops, by the clock that only goes on.
    """

    until_s: float = math.inf
    counts: Counter[str] = field(default_factory=Counter)
    violations: int = 0
    _told_s: float = field(default_factory=time.monotonic)

    @property
    def is_over(self) -> bool:
        """Whether the time is up."""
        return time.monotonic() > self.until_s

    def violation(self, what: str) -> None:
        """Note and print something that must not be."""
        self.violations += 1
        print(f"VIOLATION {what[:_MOST_SHOWN]}", flush=True)

    def count(self, what: str, many: int = 1) -> None:
        """Count something; now and then say how far it is."""
        self.counts[what] += many
        if time.monotonic() - self._told_s > _TELL_EVERY_S:
            self._told_s = time.monotonic()
            print(f"... {dict(self.counts)}, {self.violations} violations", flush=True)


Work = Callable[[Path, Sequence[int], Findings], None]
"""Does the runs of these numbers, in this folder."""


def asked_plan(
    description: str | None, runs: int, add: Callable[[argparse.ArgumentParser], None] | None = None
) -> tuple[Plan, argparse.Namespace]:
    """The plan of the command line, and the options a sweep adds to it."""
    parser = argparse.ArgumentParser(description=(description or "").splitlines()[0])
    parser.add_argument("--runs", type=int, default=runs)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=math.inf, help="stop after so long")
    if add is not None:
        add(parser)
    asked = parser.parse_args()
    return Plan(asked.runs, asked.seed, asked.workers, asked.seconds), asked


def sweep(name: str, plan: Plan, work: Work) -> int:
    """Do all runs; prints one line of JSON at the end and gives the exit status."""
    began_s, findings = time.monotonic(), Findings()
    until_s = began_s + plan.seconds
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with tempfile.TemporaryDirectory(prefix="trackwright-", dir=_in_memory()) as top:
        own_user(Path(top) / "user")
        workers = [
            _forked(Path(top) / str(worker), range(worker, plan.runs, plan.workers), until_s, work)
            for worker in range(min(plan.workers, plan.runs))
        ]
        try:
            for pid, result in workers:
                _hear(pid, result, findings)
        except KeyboardInterrupt:
            for pid, _ in workers:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            raise
    told = {"sweep": name, "runs": plan.runs, "seed": plan.seed}
    told |= {"seconds": round(time.monotonic() - began_s), "counts": dict(findings.counts)}
    print(json.dumps({**told, "violations": findings.violations}), flush=True)
    return int(findings.violations > 0)


def _hear(pid: int, result: Path, findings: Findings) -> None:
    """Wait for a worker, and take what it found."""
    status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    if status or not result.exists():
        findings.violation(f"a worker ended with {status}")
        return
    told = json.loads(result.read_text())
    findings.counts.update(told["counts"])
    findings.violations += told["violations"]


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


def _forked(folder: Path, numbers: Sequence[int], until_s: float, work: Work) -> tuple[int, Path]:
    result = folder / "result.json"
    folder.mkdir()
    sys.stdout.flush()
    pid = os.fork()
    if pid:
        return pid, result
    findings = Findings(until_s)
    try:
        work(folder, numbers, findings)
        told = {"counts": dict(findings.counts), "violations": findings.violations}
        result.write_text(json.dumps(told))
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    sys.stdout.flush()
    os._exit(0)
