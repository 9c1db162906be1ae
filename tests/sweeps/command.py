"""The real command in a fork: imported once, run with limits, and judged by what it left.

What takes long to import is imported by whoever forks; `run` is then called as `trackwright` would.
"""

from __future__ import annotations

import importlib
import os
import pkgutil
import re
import resource
import select
import signal
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import app.cli
from tests.sweeps.runner import forked, slowdown

LONGEST_S = 10.0
"""Of processor time, or of waiting for something that does not come: machines are shared."""
_SHARED = 8.0
"""So many times its processor time a command may take, on a machine of its own, and not wait."""
_KILLED_AFTER_S = 30.0
"""On a machine of its own."""
MOST_BYTES = 1 << 30
"""Resident memory a command may take beyond what it has when it begins."""
_ADDRESS_BYTES = 12 << 30
"""Of address space, threads' stacks and mapped libraries included: past it, memory is refused."""
_FILE_BYTES = 1 << 30
_LONGEST_LINE = 4000
_CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069]")
_READ_BYTES = 1 << 20


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a command ended.

    Attributes:
        status: the exit status; negative: the signal. hung: it took, or waited, longer than it may.
        grown_bytes: its greatest resident memory, or that of its children, beyond its first.
    """

    status: int
    stdout: str
    stderr: str
    hung: bool
    grown_bytes: int

    @property
    def line(self) -> str:
        """The last line on stderr."""
        return (self.stderr.splitlines() or [""])[-1]


def preload() -> None:
    """Import what commands need, so that forks have it."""
    import cv2

    for each in pkgutil.walk_packages(app.cli.__path__, "app.cli."):
        importlib.import_module(each.name)
    importlib.import_module("app.__main__")
    cv2.setNumThreads(1)  # threads do not come along into a fork


def command(words: Sequence[str | Path], folder: Path, longest_s: float = LONGEST_S) -> Outcome:
    """Run `trackwright WORDS`; what it says goes through files in the folder."""
    return in_child(lambda: _obey([str(word) for word in words]), folder, longest_s)


def _obey(words: list[str]) -> int:
    from app.__main__ import run

    return run(words)


def in_child(work: Callable[[], int], folder: Path, longest_s: float = LONGEST_S) -> Outcome:
    """Do work in a fork with limits on time, memory and size of files."""
    said = folder / "stdout.txt", folder / "stderr.txt"
    first = resident_bytes()
    return outcome_of(begin(work, said), said, first, longest_s)


def begin(work: Callable[[], int], said: tuple[Path, Path]) -> int:
    """Fork off the work; gives the process, which leads a group of its own."""
    # Opened here, where no fault is put into the calls.
    written = os.O_WRONLY | os.O_CREAT | os.O_TRUNC
    outputs = (os.open(file, written, 0o600) for file in said)
    handles = os.open(os.devnull, os.O_RDONLY), *outputs

    def limited() -> int:
        os.setsid()
        for number, handle in enumerate(handles):
            os.dup2(handle, number)
        _limit()
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        return work()

    pid = forked(limited)
    for handle in handles:
        os.close(handle)
    return pid


def outcome_of(pid: int, said: tuple[Path, Path], first: int, longest_s: float) -> Outcome:
    """Wait for a process, and kill its group where it takes far too long."""
    began_s, watched = time.monotonic(), os.pidfd_open(pid)
    slow = slowdown()
    hung = not select.select([watched], [], [], slow * max(_KILLED_AFTER_S, longest_s))[0]
    os.close(watched)
    if hung:
        os.killpg(pid, signal.SIGKILL)
    _, status, used = os.wait4(pid, 0)
    texts = [_beginning(file) for file in said]
    grown, worked_s = 1024 * used.ru_maxrss - first, used.ru_utime + used.ru_stime
    waited_s = time.monotonic() - began_s - _SHARED * slow * worked_s
    hung = hung or max(worked_s, waited_s) > longest_s
    return Outcome(os.waitstatus_to_exitcode(status), *texts, hung, grown)


def complaint(outcome: Outcome) -> str:
    """What is wrong with how a command ended, whatever it was asked; "" where nothing is."""
    told = [line for line in outcome.stderr.split("\n") if line.startswith("trackwright: ")]
    checks = (
        (outcome.hung, "took too long"),
        (outcome.status < 0, f"ended by signal {-outcome.status}"),
        ("Traceback (most recent" in outcome.stderr, "traceback"),
        ("this is a bug" in outcome.stderr, "bug"),
        (outcome.status not in (0, 1, 2), f"exit status {outcome.status}"),
        ("not enough memory" in outcome.stderr, "ran out of memory"),
        (outcome.grown_bytes > MOST_BYTES, f"took {outcome.grown_bytes >> 20} MiB"),
        (outcome.status in (1, 2) and len(told) != 1, f"{len(told)} lines for one error"),
        (any(len(line) > _LONGEST_LINE for line in told), "a line without end"),
        (_raw(outcome), "control characters on the terminal"),
    )
    found = [what for wrong, what in checks if wrong]
    return f"{', '.join(found)}: {outcome.stderr[-700:].strip()!r}" if found else ""


def _raw(outcome: Outcome) -> bool:
    lines = f"{outcome.stdout}\n{outcome.stderr}".split("\n")
    return any(_CONTROLS.search(line) for line in lines)


def _limit() -> None:
    limits = (resource.RLIMIT_AS, _ADDRESS_BYTES), (resource.RLIMIT_FSIZE, _FILE_BYTES)
    for kind, most in (*limits, (resource.RLIMIT_CORE, 0)):
        resource.setrlimit(kind, (most, resource.getrlimit(kind)[1]))
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def _beginning(file: Path) -> str:
    with file.open("rb") as stream:
        return stream.read(_READ_BYTES).decode(errors="replace")


def resident_bytes(pid: int | str = "self") -> int:
    """What a process has in memory now; 0 once it is gone."""
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0
    return pages * resource.getpagesize()
