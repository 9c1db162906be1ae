"""Batches in tests: workers that are this process, and what is asked of a batch as one call."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from tracking.batch import (
    BatchOrder,
    BatchRun,
    Doing,
    Entry,
    Limits,
    Listener,
    Outcome,
    batch_folder,
)
from tracking.batch.job import do_task
from tracking.batch.ledger import Attempt, Ledger, Row
from tracking.batch.task import Task
from tracking.batch.workers import ThreadedWorkers

QUICK = BatchOrder(tracker="three-part", report=False)
Do = Callable[[Task], Outcome | None]


def do_here(task: Task) -> Outcome:
    """Do a task in this process."""
    return do_task(task, lambda *_: None)


def here(do: Do = do_here, count: int = 1) -> ThreadedWorkers:
    """Workers that are threads of this process."""

    def work(task: Task, tell: Callable[[Doing], None]) -> Outcome | None:
        tell(Doing("1", task.name, "tracking"))
        return do(task)

    return ThreadedWorkers([work] * count)


def entries_of(*folders: Path) -> list[Entry]:
    """Recordings called after their folders."""
    return [Entry(folder.name, folder) for folder in folders]


def batch(
    out: Path,
    folders: Sequence[Path],
    order: BatchOrder = QUICK,
    do: Do = do_here,
    *,
    limits: Limits | None = None,
    retry: bool = False,
    listener: Listener | None = None,
) -> Mapping[str, Outcome]:
    """What became of recordings, once all was done that is left."""
    with batch_folder(out) as ledger:
        run = BatchRun(ledger, out, order, limits or Limits(), listener=listener, retry=retry)
        plan = run.plan(entries_of(*folders))
        return run.work(here(do)) if plan.to_do else plan.finished


class Counting:
    """Does tasks here and counts them; `names` of the recordings that were worked on, in order."""

    def __init__(self, do: Do = do_here) -> None:
        self.names: list[str] = []
        self.tracked: list[str] = []
        self._do = do

    def __call__(self, task: Task) -> Outcome | None:
        self.names.append(task.name)
        outcome = self._do(task)
        if outcome is not None and outcome.tracked:
            self.tracked.append(task.name)
        return outcome


def ledger_of(out: Path) -> tuple[dict[str, Row], list[Attempt]]:
    """All rows, by name, and all attempts."""
    with Ledger(out / "batch.sqlite") as ledger:
        return {row.name: row for row in ledger.rows()}, ledger.attempts()


def leftovers(out: Path) -> list[str]:
    """Names of hidden files and folders in an output folder."""
    return sorted(path.name for path in out.iterdir() if path.name.startswith("."))
