"""The tasks of a batch on an existing Dask cluster, of which the package `distributed` is needed.

On the cluster each thread of a worker has a worker process of its own (`WorkerProcess`), as on one
machine: what a recording does to it, it does to that process alone, and the limits are the same.
All machines share the disk with recordings and results, and have the same trackwright.
"""

from __future__ import annotations

import asyncio
import atexit
import contextlib
import json
import os
import secrets
import threading
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tracking.batch.order import Limits
from tracking.batch.outcome import Cause, Outcome, failure
from tracking.batch.task import HIDDEN, Task
from tracking.batch.worker_process import Doing, WorkerProcess
from tracking.batch.workers import Collected, Ended, Event
from tracking.errors import OutputError
from tracking.translation import msg

_CONNECT_S = 10
_TOPIC = "trackwright-batch"
_BEAT_S = 2.0
_SILENT_S = 60.0
"""So long after the last sign of life of whoever gave a task, its worker gives it up."""
_local = threading.local()


class ClusterWorkers:
    """The workers of a cluster; new ones are used as they join it."""

    def __init__(self, address: str, limits: Limits, out: Path) -> None:
        """Connect to a scheduler, e.g. at "tcp://host:8786".

        Raises OutputError where `distributed` is missing, nothing answers, or the cluster is empty.
        """
        self._client: Any = _connected(address)
        self._limits = limits
        self._events = Collected()
        self._futures: dict[str, Any] = {}
        self._alive = out / f"{HIDDEN}alive-{secrets.token_hex(8)}"
        self._ended = threading.Event()
        self._threads = self._count()
        self._counted_s = time.monotonic()
        if not self._threads:
            self._client.close()
            raise OutputError(
                "the cluster at {address} has no workers; start some", address=address
            )
        self._alive.touch()
        threading.Thread(target=self._beat, daemon=True).start()
        self._client.subscribe_topic(_TOPIC, self._heard)

    @property
    def count(self) -> int:
        """See `Workers`."""
        if time.monotonic() - self._counted_s > _BEAT_S:
            self._counted_s = time.monotonic()
            self._threads = self._count() or self._threads
        return self._threads

    @property
    def ahead(self) -> int:
        """See `Workers`; a cluster is farther away than a thread."""
        return self._threads

    def start(self, task: Task) -> None:
        """See `Workers`."""
        limits = [self._limits.time_s, self._limits.stall_s, self._limits.memory_bytes]
        said = json.dumps({"task": task.as_data(), "limits": limits, "alive": str(self._alive)})
        future = self._client.submit(
            do_on_cluster, said, key=f"{task.name}-{task.token}", pure=False
        )
        self._futures[task.token] = future
        future.add_done_callback(lambda done: self._done(task.token, done))

    def events(self, wait_s: float) -> list[Event]:
        """See `Workers`."""
        return self._events.take(wait_s)

    def stop(self) -> None:
        """See `Workers`; processes on other machines end a moment later."""
        self._ended.set()
        self._alive.unlink(missing_ok=True)
        with contextlib.suppress(Exception):  # a cluster that has gone cannot be told
            self._client.cancel(list(self._futures.values()))
        self._client.close()

    def _count(self) -> int:
        workers = self._client.scheduler_info(n_workers=-1)["workers"]
        return sum(int(each["nthreads"]) for each in workers.values())

    def _beat(self) -> None:
        while not self._ended.wait(_BEAT_S):
            with contextlib.suppress(OSError):
                os.utime(self._alive)

    def _heard(self, event: tuple[float, Any]) -> None:
        said = event[1]
        if isinstance(said, Mapping) and said.get("alive") == str(self._alive):
            fields = ("worker", "name", "stage", "done", "total")
            self._events.put(Doing(*(said[name] for name in fields)))

    def _done(self, token: str, future: Any) -> None:
        """Collect what became of a task, whatever the cluster says: each ends once."""
        self._futures.pop(token, None)
        worker = ""
        try:
            worker, outcome = _answer_of(future)
        except (
            Exception,
            asyncio.CancelledError,
        ) as error:  # of the cluster's, or of an answer that is damaged
            outcome = failure(
                Cause.WORKER, msg("its worker died ({how})", how=type(error).__name__)
            )
        if outcome is None and not self._ended.is_set():  # not by us
            outcome = failure(Cause.WORKER, msg("the cluster gave it up"))
        self._events.put(Ended(token, worker, outcome))
        if worker:
            self._events.put(Doing(worker))


def _answer_of(future: Any) -> tuple[str, Outcome | None]:
    """Which worker did a task, and the outcome; None: it was given up.

    Raises what the task raised, ValueError where the answer is none.
    """
    if future.status in ("cancelled", "lost"):
        return "", None
    if future.status == "error":
        raise future.exception()
    worker, text = future.result()
    return str(worker), Outcome.from_text(text) if text else None


def do_on_cluster(said: str) -> tuple[str, str]:
    """Do a task in a worker of the cluster: which one did it, and the outcome as text; "": none."""
    from distributed import get_worker

    told = json.loads(said)
    limits, alive = Limits(*told["limits"]), Path(told["alive"])
    worker = get_worker()
    process = _own_process(str(worker.name), limits)
    sign = _SignOfLife(alive)

    def tell(doing: Doing) -> None:
        data: dict[str, Any] = {"alive": str(alive), "worker": doing.worker, "name": doing.name}
        data |= {"stage": doing.stage, "done": doing.done, "total": doing.total}
        worker.log_event(_TOPIC, data)

    outcome = process.do(Task.from_data(told["task"]), tell, sign.is_missing)
    return process.name, "" if outcome is None else outcome.as_text()


class _SignOfLife:
    """Whether whoever gave a task still lives: a file of theirs is touched all the time."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._seen, self._seen_s, self._asked_s = self._state(), time.monotonic(), 0.0

    def is_missing(self) -> bool:
        """Whether nobody waits any more; the clocks of two machines are never compared."""
        now_s = time.monotonic()
        if now_s - self._asked_s < _BEAT_S:
            return False
        self._asked_s = now_s
        state = self._state()
        if state != self._seen:
            self._seen, self._seen_s = state, now_s
        return state is None or now_s - self._seen_s > _SILENT_S

    def _state(self) -> int | None:
        try:
            return self._path.stat().st_mtime_ns
        except OSError:
            return None


def _own_process(worker: str, limits: Limits) -> WorkerProcess:
    """The worker process of this thread; it ends with the program, or for other limits."""
    held: WorkerProcess | None = getattr(_local, "process", None)
    if held is None or _local.limits != limits:
        if held is not None:
            held.close()
        name = f"{worker}/{threading.get_ident() % 1000}"
        held = _local.process = WorkerProcess(name, limits)
        _local.limits = limits
        atexit.register(held.close)
    return held


def _connected(address: str) -> Any:
    try:
        from distributed import Client  # an extra
    except ImportError as error:
        raise OutputError("--scheduler needs Dask: pip install 'trackwright[cluster]'") from error
    connect: Any = Client
    try:
        return connect(address, timeout=_CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise OutputError(
            "no Dask scheduler answers at {address}; check the address, e.g. tcp://host:8786",
            address=address,
        ) from error
