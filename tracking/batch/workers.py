"""What does the tasks of a batch: the protocol, and worker processes on this machine."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from tracking.batch.order import Limits
from tracking.batch.outcome import Cause, Outcome, failure
from tracking.batch.task import Task
from tracking.batch.worker_process import WORKER, Doing, WorkerProcess
from tracking.translation import msg


@dataclass(frozen=True, slots=True)
class Ended:
    """A task that was done, or was given up; outcome None: the workers are being stopped."""

    token: str
    worker: str
    outcome: Outcome | None


Event = Doing | Ended


class Workers(Protocol):
    """Takes tasks and tells what becomes of them; used from one thread."""

    @property
    def count(self) -> int:
        """How many tasks are worked on at once."""

    @property
    def ahead(self) -> int:
        """How many more may wait with the workers, so that none of them idles."""

    def start(self, task: Task) -> None:
        """Have a task done as soon as a worker is free."""

    def events(self, wait_s: float) -> list[Event]:
        """What happened; the first thing is waited for that long."""

    def stop(self) -> None:
        """End all workers at once; returns when they have ended."""


class Collected:
    """Events of several threads, in the order in which they came."""

    def __init__(self) -> None:
        self._queue: queue.SimpleQueue[Event] = queue.SimpleQueue()

    def put(self, event: Event) -> None:
        """Add one; from any thread."""
        self._queue.put(event)

    def take(self, wait_s: float) -> list[Event]:
        """All there are; the first one is waited for."""
        events: list[Event] = []
        try:
            events.append(self._queue.get(timeout=wait_s))
            while True:
                events.append(self._queue.get_nowait())
        except queue.Empty:
            return events


Do = Callable[[Task, Callable[[Doing], None]], Outcome | None]


class ThreadedWorkers:
    """One thread for each worker; what a worker is, the caller says."""

    def __init__(self, work: Sequence[Do], ahead: int = 1) -> None:
        """work: of each worker what does one task after the other."""
        self.count = len(work)
        self.ahead = ahead
        self._tasks: queue.SimpleQueue[Task | None] = queue.SimpleQueue()
        self._events = Collected()
        self._threads = [
            threading.Thread(target=self._work, args=(f"{number}", do), daemon=True)
            for number, do in enumerate(work, 1)
        ]
        for thread in self._threads:
            thread.start()

    def start(self, task: Task) -> None:
        """See `Workers`."""
        self._tasks.put(task)

    def events(self, wait_s: float) -> list[Event]:
        """See `Workers`."""
        return self._events.take(wait_s)

    def stop(self) -> None:
        """See `Workers`; what waits is not begun any more."""
        for _ in self._threads:
            self._tasks.put(None)
        for thread in self._threads:
            thread.join()

    def _work(self, name: str, do: Do) -> None:
        while (task := self._tasks.get()) is not None:
            try:
                outcome = do(task, self._events.put)
            except Exception as error:  # a thread must not go and take its task with it
                why = msg(
                    "its worker failed: {kind}: {error}", kind=type(error).__name__, error=error
                )
                outcome = failure(Cause.WORKER, why)
            self._events.put(Ended(task.token, name, outcome))
            self._events.put(Doing(name))


class LocalWorkers(ThreadedWorkers):
    """Processes of one thread each on this machine."""

    def __init__(self, count: int, limits: Limits, worker: Sequence[str] = WORKER) -> None:
        """worker: what Python is given to be one."""
        self._processes = [WorkerProcess(str(n), limits, worker) for n in range(1, count + 1)]
        self._stopping = threading.Event()
        super().__init__([self._done_by(each) for each in self._processes])

    def stop(self) -> None:
        """See `Workers`."""
        self._stopping.set()
        for each in self._processes:
            each.close()
        super().stop()
        for each in self._processes:
            each.wait()

    def _done_by(self, process: WorkerProcess) -> Do:
        def do(task: Task, tell: Callable[[Doing], None]) -> Outcome | None:
            if self._stopping.is_set():
                return None
            outcome = process.do(task, tell)
            if outcome is not None and outcome.cause is Cause.LIMIT:
                process.kill()  # memory that was asked for may not be given back
                process.wait()
            return outcome

        return do
