"""The other end of a worker: gives it tasks, and ends it where a task goes beyond its limits."""

from __future__ import annotations

import contextlib
import os
import queue
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO, Any

from tracking import child_program
from tracking.batch.order import Limits
from tracking.batch.outcome import Cause, Outcome, failure
from tracking.batch.task import Task
from tracking.translation import N_, Message, msg

WORKER: tuple[str, ...] = ("-m", "tracking.batch.worker")
"""What Python is given to be a worker."""
STARTING = N_("starting")
_LOOK_EVERY_S = 0.2
_BORN_WITHIN_S = 600.0
"""Machines are busy, and disks of clusters slow."""
_ENVIRONMENT = {**child_program.ONE_THREAD, "MALLOC_ARENA_MAX": "2"}
"""One thread each: there are as many workers as there are to be threads."""
_HEADROOM = 1.25
"""Memory that is used counts otherwise than memory that is asked for, which is refused at 1."""


@dataclass(frozen=True, slots=True)
class Doing:
    """What a worker does.

    Attributes:
        worker: which one. name: of the recording; "": it waits.
        stage: "tracking", "scoring" and so on. done, total: steps of it; total 0: not known.
        since_s: when it began with the recording, by the monotonic clock.
    """

    worker: str
    name: str = ""
    stage: str = ""
    done: int = 0
    total: int = 0
    since_s: float = 0.0


class WorkerProcess:
    """A worker that is started when it is needed, and again after it died.

    `do` belongs to one thread; `kill` may be called from any.
    """

    def __init__(self, name: str, limits: Limits, worker: Sequence[str] = WORKER) -> None:
        self.name = name
        self._limits = limits
        self._command = tuple(worker)
        self._child: subprocess.Popen[bytes] | None = None
        self._heard: queue.SimpleQueue[dict[str, Any] | None] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._closed = threading.Event()

    @property
    def pid(self) -> int:
        """Its number; 0 while there is none."""
        return self._child.pid if self._child is not None else 0

    def do(
        self,
        task: Task,
        tell: Callable[[Doing], None],
        unwanted: Callable[[], bool] = lambda: False,
    ) -> Outcome | None:
        """What became of a task; None where nobody wants to know any more.

        Args:
            tell: told what the worker does, each time that it says so.
            unwanted: asked all the time; True ends the worker.
        """
        from tracking.untrusted.pipe import send  # its room brings h5py

        began_s = time.monotonic()
        doing = Doing(self.name, task.name, STARTING, since_s=began_s)
        tell(doing)
        if not self._begin():
            return self._died(late=time.monotonic() - began_s >= _BORN_WITHIN_S)
        assert self._child is not None
        assert self._child.stdin is not None
        base_bytes = _used_bytes(self.pid)
        try:
            send(self._child.stdin, task.as_data())
        except (OSError, ValueError):
            return self._died()
        began_s = heard_s = time.monotonic()
        while True:
            try:
                said = self._heard.get(timeout=_LOOK_EVERY_S)
            except queue.Empty:
                said = {}
            if said is None:
                return self._died()
            if self._closed.is_set() or unwanted():
                self.kill()
                return None
            if said.get("token") == task.token:
                if "outcome" in said:
                    return _outcome(said)
                if said["done"] > doing.done or said["stage"] != doing.stage:
                    heard_s = time.monotonic()
                doing = replace(doing, stage=said["stage"], done=said["done"], total=said["total"])
                tell(doing)
            if why := self._beyond(began_s, heard_s, base_bytes, doing):
                self.kill()
                return failure(Cause.LIMIT, why, seconds=time.monotonic() - began_s)

    def kill(self) -> None:
        """End it at once; it has nothing to put in order."""
        with self._lock:
            if self._child is not None:
                self._child.kill()

    def close(self) -> None:
        """End it, and start no other."""
        self._closed.set()
        self.kill()

    def wait(self) -> None:
        """Until it has ended, for whoever looks at what it left."""
        if self._child is not None:
            self._child.wait()
            if self._child.stdin is not None:
                with contextlib.suppress(OSError):  # what was written and never read
                    self._child.stdin.close()

    def _begin(self) -> bool:
        """Have a worker that is ready; False where it died before."""
        if self._child is not None and self._child.poll() is None:
            return True
        self.wait()
        with self._lock:
            if self._closed.is_set():
                return False
            self._heard = queue.SimpleQueue()
            self._child = child_program.begin(*self._command, more=_ENVIRONMENT)
            heard, answers = self._heard, self._child.stdout
        assert answers is not None
        threading.Thread(target=_listen, args=(answers, heard), daemon=True).start()
        try:
            said = self._heard.get(timeout=_BORN_WITHIN_S)
        except queue.Empty:
            said = None
        return said is not None and "ready" in said

    def _died(self, *, late: bool = False) -> Outcome | None:
        """What is told of a task whose worker is no more; late: it never came to begin."""
        if self._closed.is_set():
            return None
        status: int | None = None
        if self._child is not None:
            self._child.kill()
            status = self._child.wait()
        if late:
            why = msg("its worker did not start within {limit:g} s", limit=_BORN_WITHIN_S)
            return failure(Cause.WORKER, why)
        return failure(Cause.WORKER, msg("its worker died ({how})", how=_how(status)))

    def _beyond(
        self, began_s: float, heard_s: float, base_bytes: int, doing: Doing
    ) -> Message | None:
        """Which limit is passed; None: none."""
        limits, now_s = self._limits, time.monotonic()
        if limits.time_s is not None and now_s - began_s > limits.time_s:
            return msg(
                "it took longer than {limit:g} s ({stage}); allow more with --time-limit",
                limit=limits.time_s,
                stage=msg(doing.stage),
            )
        if limits.stall_s is not None and now_s - heard_s > limits.stall_s:
            return msg(
                "nothing went on for {limit:g} s ({stage}); allow more with --stall-limit",
                limit=limits.stall_s,
                stage=msg(doing.stage),
            )
        if limits.memory_bytes is not None:
            used = _used_bytes(self.pid) - base_bytes
            if used > _HEADROOM * limits.memory_bytes:
                return msg(
                    "it used {used} MB of memory of {limit}; allow more with --memory-limit",
                    used=used >> 20,
                    limit=limits.memory_bytes >> 20,
                )
        return None


def _outcome(said: dict[str, Any]) -> Outcome:
    try:
        return Outcome.from_text(str(said["outcome"]))
    except ValueError:
        return failure(Cause.WORKER, msg("its worker said what cannot be read"))


def _listen(answers: IO[bytes], heard: queue.SimpleQueue[dict[str, Any] | None]) -> None:
    from tracking.untrusted.pipe import receive_head  # its room brings h5py

    with contextlib.suppress(ValueError, OSError), answers:
        while (said := receive_head(answers)) is not None:
            heard.put(said)
    heard.put(None)


def _used_bytes(pid: int) -> int:
    """Memory that a process uses, as far as the system tells."""
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError, AttributeError):
        return 0


def _how(status: int | None) -> Message:
    """How a process ended, in words."""
    if status is None:
        return msg("it did not start")
    if status < 0:
        with contextlib.suppress(ValueError):
            return msg("signal {name}", name=signal.Signals(-status).name)
    return msg("status {status}", status=status)
