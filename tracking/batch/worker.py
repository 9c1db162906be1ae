"""A worker: `python -m tracking.batch.worker`, driven through its pipes.

It gets one task after the other on standard input, and answers on standard output with how far it
is and what became of it; see `untrusted.pipe`. The end of input says that nobody waits any more,
and ends it at once. It computes with one thread; `WorkerProcess` says so to NumPy's libraries.
"""

from __future__ import annotations

import contextlib
import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable
from typing import IO, Any

import cv2

from tracking.batch.job import Tell, do_task
from tracking.batch.outcome import Outcome
from tracking.batch.task import Task
from tracking.untrusted.pipe import receive_head, send

Do = Callable[[Task, Tell], Outcome]
"""Does a task, and leaves its outcome on disk."""
_TOLD_EVERY_S = 0.2


def main(do: Do = do_task) -> None:
    """Do tasks until there are no more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # typed at whoever gives the tasks
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    cv2.setNumThreads(1)
    answers = own_output()
    tasks: queue.SimpleQueue[dict[str, Any]] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(tasks,), daemon=True).start()
    with contextlib.suppress(BrokenPipeError):
        send(answers, {"ready": os.getpid()})
        while True:
            _do(tasks.get(), do, answers)
    os._exit(0)


def _do(said: dict[str, Any], do: Do, answers: IO[bytes]) -> None:
    task = Task.from_data(said)
    free = _limit_memory(task.memory_bytes)
    told_s, stage_told = 0.0, ""

    def tell(stage: str, done: int, total: int) -> None:
        nonlocal told_s, stage_told
        now_s = time.monotonic()
        if stage != stage_told or now_s - told_s >= _TOLD_EVERY_S:
            told_s, stage_told = now_s, stage
            send(answers, {"token": task.token, "stage": stage, "done": done, "total": total})

    try:
        outcome = do(task, tell)
    finally:
        free()
    send(answers, {"token": task.token, "outcome": outcome.as_text()})


def _listen(tasks: queue.SimpleQueue[dict[str, Any]]) -> None:
    """Hand tasks on; the end of input ends the process, whatever it is doing."""
    while (said := receive_head(sys.stdin.buffer)) is not None:
        tasks.put(said)
    os._exit(0)


def own_output() -> IO[bytes]:
    """The pipe to whoever gives the tasks, kept from libraries that print."""
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    elsewhere = sys.stderr.fileno() if sys.stderr else os.open(os.devnull, os.O_WRONLY)
    os.dup2(elsewhere, sys.stdout.fileno())
    return answers


def _limit_memory(most_bytes: int | None) -> Callable[[], None]:
    """Refuse more memory than that beyond what is held; gives how to lift the limit.

    Where the system knows no such limit, only `WorkerProcess` watches.
    """
    try:
        import resource
    except ImportError:  # Windows
        return lambda: None
    kind = getattr(resource, "RLIMIT_DATA", None)
    held = _data_bytes()
    if most_bytes is None or kind is None or held is None:
        return lambda: None
    soft, hard = resource.getrlimit(kind)
    most = held + most_bytes
    if hard != resource.RLIM_INFINITY:
        most = min(most, hard)
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(kind, (most, hard))
    return lambda: resource.setrlimit(kind, (soft, hard))


def _data_bytes() -> int | None:
    """Private memory of this process that could be written, as RLIMIT_DATA counts it."""
    try:
        with open("/proc/self/status", encoding="ascii") as status:  # noqa: PTH123
            lines = [line for line in status if line.startswith("VmData:")]
        return int(lines[0].split()[1]) << 10
    except (OSError, ValueError, IndexError):
        return None


if __name__ == "__main__":
    main()
