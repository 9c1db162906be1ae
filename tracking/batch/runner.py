"""A batch from its first recording to its last: hand out, take in, write down, try again.

The ledger and the results in the output folder are all there is to know: whoever begins again goes
on from them.
"""

from __future__ import annotations

import contextlib
import secrets
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tracking.batch.ledger import Ledger, Row, limits_text
from tracking.batch.order import BatchOrder, Limits
from tracking.batch.outcome import Cause, Outcome, State, failure
from tracking.batch.output_folder import Shard
from tracking.batch.plan import Plan, Planned, Planner
from tracking.batch.progress import BatchState, Listener, Pace
from tracking.batch.publication import (
    clear,
    clear_parts,
    clear_unfinished,
    is_whole,
    publish,
    sync_published,
    workplaces,
)
from tracking.batch.recordings import Entry
from tracking.batch.task import Finished, Task, Workplace
from tracking.batch.worker_process import Doing
from tracking.batch.workers import Ended, Event, Workers
from tracking.stamps import make_id
from tracking.translation import msg

TRIES: Final = 3
"""The first one, and two more where what went wrong may pass."""
_WAIT_S = 0.25
_STOPPED = failure(Cause.WORKER, msg("stopped"))


class BatchRun:
    """One go at a batch."""

    def __init__(
        self,
        ledger: Ledger,
        out: Path,
        order: BatchOrder,
        limits: Limits,
        *,
        listener: Listener | None = None,
        retry: bool = False,
        shard: Shard | None = None,
    ) -> None:
        """retry: see `Planner`."""
        self._ledger, self._out, self._order, self._limits = ledger, out, order, limits
        self._listener = listener or Listener()
        self._planner = Planner(order, limits, out, retry=retry)
        self._prefix = "" if shard is None else f"s{shard.number}of{shard.count}-"
        self._run = make_id()
        self._waiting: deque[Planned] = deque()
        self._in_work: dict[str, _InWork] = {}
        self._by_name: dict[str, _InWork] = {}
        self._tries: dict[str, int] = {}
        self._outcomes: dict[str, Outcome] = {}
        self._pace = Pace()
        self.state = BatchState()

    def plan(self, entries: Sequence[Entry]) -> Plan:
        """Take in what workers finished unseen, and see what is left."""
        self._take_in()
        rows = {row.name: row for row in self._ledger.rows()}
        plan = self._planner.plan(entries, rows)
        self._waiting.extend(plan.to_do)
        self.state.left |= dict.fromkeys(each.entry.name for each in plan.to_do)
        self._pace.begin([each.size_bytes for each in plan.to_do])
        self.state.total = len(entries)
        for name, outcome in plan.finished.items():
            self._outcomes[name] = outcome
            self._count(outcome)
        self.state.finished = len(plan.finished)
        return plan

    def work(self, workers: Workers) -> Mapping[str, Outcome]:
        """Do what is left; what became of every recording, by name.

        Whatever ends it early, what is finished by then is kept.
        """
        self._listener.began(self.state)
        try:
            while self._waiting or self._in_work:
                self._hand_out(workers)
                self._take(workers.events(_WAIT_S))
                self._look_ahead()
                self._listener.moved(self.state)
        finally:
            workers.stop()
            self._take(workers.events(0.0))
            self._clear_all()
        return self._outcomes

    def _hand_out(self, workers: Workers) -> None:
        while self._waiting and len(self._in_work) < workers.count + workers.ahead:
            planned = self._waiting.popleft()
            token = f"{self._prefix}{secrets.token_hex(8)}"
            entry = planned.entry
            task = Task(
                *(entry.name, entry.path, self._out, token, self._order),
                *(self._planner.asked, planned.signature, planned.known),
                self._limits.memory_bytes,
            )
            self._in_work[token] = self._by_name[entry.name] = _InWork(planned, task)
            workers.start(task)

    def _take(self, events: Sequence[Event]) -> None:
        """Write down what happened, on disk, and then tell it."""
        ended = [each for each in events if isinstance(each, Ended)]
        for each in events:
            if isinstance(each, Doing):
                self._note(each)
        told: list[tuple[_InWork, Outcome]] = []
        for each in ended:
            work = self._in_work.pop(each.token, None)
            if work is None:
                continue
            self._by_name.pop(work.task.name, None)
            if each.outcome is None:  # stopped
                self._end_attempt(work, each.worker, _STOPPED)
                continue
            told.append((work, self._publish(work, each)))
        if told:
            sync_published(self._out)
        self._ledger.commit()
        for work, outcome in told:
            (clear if outcome.is_done else clear_unfinished)(work.task.workplace)
            self._tell(work, outcome)

    def _publish(self, work: _InWork, ended: Ended) -> Outcome:
        """Put a result in its place, and into the ledger."""
        assert ended.outcome is not None
        task, place = work.task, work.task.workplace
        outcome = publish(place, task.name, ended.outcome)
        self._end_attempt(work, ended.worker, outcome)
        signature = outcome.signature or task.signature
        outcome = _with_known(outcome, work.planned.known)
        self._put(task.name, task.path, task.asked, signature, outcome, place)
        return outcome

    def _put(
        self, name: str, path: Path, asked: str, signature: str, outcome: Outcome, place: Workplace
    ) -> None:
        limits = self._limits
        text = limits_text(limits.time_s, limits.stall_s, limits.memory_bytes)
        image: bytes | None = None
        with contextlib.suppress(OSError):
            image = place.thumbnail.read_bytes()
        self._ledger.put(Row(name, path, asked, signature, text, outcome), image)

    def _end_attempt(self, work: _InWork, worker: str, outcome: Outcome) -> None:
        if work.attempt == 0:
            work.attempt = self._ledger.begin_attempt(
                work.task.name, self._run, work.task.token, worker
            )
        self._ledger.end_attempt(work.attempt, outcome)

    def _tell(self, work: _InWork, outcome: Outcome) -> None:
        name = work.task.name
        tries = self._tries[name] = self._tries.get(name, 0) + 1
        if not outcome.is_done and outcome.cause.may_pass and tries < TRIES:
            self._waiting.append(work.planned)
            self._listener.again(name, outcome)
            return
        self._outcomes[name] = outcome
        self._count(outcome)
        self.state.left.pop(name, None)
        self._pace.end(work.planned.size_bytes)
        self._listener.ended(name, outcome)

    def _note(self, doing: Doing) -> None:
        """Note what a worker does; that it began is in the ledger with the next commit."""
        self.state.doing[doing.worker] = doing
        work = self._by_name.get(doing.name)
        if work is None:
            return
        work.share = doing.done / doing.total if doing.total else work.share
        if work.attempt == 0:
            token = work.task.token
            work.attempt = self._ledger.begin_attempt(doing.name, self._run, token, doing.worker)

    def _look_ahead(self) -> None:
        """Tell how long the rest may take."""
        weight = self._pace.weight
        works = self._in_work.values()
        begun = sum(each.share * weight(each.planned.size_bytes) for each in works)
        self.state.seconds_left = self._pace.seconds_left(begun)

    def _count(self, outcome: Outcome) -> None:
        name = {State.DONE: "done", State.FAILED: "failed", State.SKIPPED: "skipped"}[outcome.state]
        setattr(self.state, name, getattr(self.state, name) + 1)

    def _take_in(self) -> None:
        """Publish what workers finished for a program that was killed; remove all else."""
        places = list(workplaces(self._out, self._prefix))
        known = {row.name: row.outcome for row in self._ledger.rows()} if places else {}
        taken = False
        for place in places:
            finished = Finished.read(place)
            if finished is None or finished.outcome.cause.may_pass:
                continue
            if not is_whole(place, finished.name, finished.outcome):
                continue
            outcome = publish(place, finished.name, finished.outcome)
            if outcome.is_done or not finished.outcome.is_done:
                seen = outcome.signature
                outcome = _with_known(outcome, known.get(finished.name))
                self._put(finished.name, finished.path, finished.asked, seen, outcome, place)
                taken = True
                self._ledger.end_attempt_of(place.token, outcome)
        if taken:
            sync_published(self._out)
        self._ledger.end_open_attempts()
        self._ledger.commit()
        for place in places:
            clear(place)
        clear_parts(self._out, self._prefix)

    def _clear_all(self) -> None:
        for work in self._in_work.values():
            clear_unfinished(work.task.workplace)


def _with_known(outcome: Outcome, known: Outcome | None) -> Outcome:
    """An outcome for the ledger: one without a session tells nothing new of the one in place."""
    if outcome.is_done or outcome.session or known is None:
        return outcome
    return outcome.on_top_of(known)


@dataclass(slots=True)
class _InWork:
    """A task that a worker has; share: of it that is done."""

    planned: Planned
    task: Task
    attempt: int = 0
    share: float = 0.0
