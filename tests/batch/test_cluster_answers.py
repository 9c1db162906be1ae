"""Whatever a cluster says became of a task: nothing that was asked for is lost."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.batch.batches import QUICK
from tracking.batch import Cause, Limits, Outcome, State, cluster
from tracking.batch.cluster import ClusterWorkers
from tracking.batch.task import Task
from tracking.batch.workers import Ended


class Answered:
    """A future that ends as it begins."""

    def __init__(self, status: str, answer: object = None) -> None:
        self.status = status
        self._answer = answer

    def add_done_callback(self, told: Callable[[Any], None]) -> None:
        told(self)

    def exception(self) -> object:
        return self._answer

    def result(self) -> object:
        if isinstance(self._answer, BaseException):
            raise self._answer
        return self._answer


@pytest.fixture
def client(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """A cluster of one thread whose answer is `answered`."""
    made = SimpleNamespace(answered=None)
    made.submit = lambda *_, **__: made.answered
    made.scheduler_info = lambda **_: {"workers": {"one": {"nthreads": 1}}}
    made.subscribe_topic = made.cancel = made.close = lambda *_: None
    monkeypatch.setattr(cluster, "_connected", lambda _: made)
    return made


def ended_with(client: SimpleNamespace, answered: Answered, out: Path, *, stop: bool) -> Ended:
    client.answered = answered
    workers = ClusterWorkers("tcp://nowhere:1", Limits(), out)
    if stop:
        workers.stop()
    workers.start(Task("walk", out, out, "00ff", QUICK, "", ""))
    workers.stop()
    (ended,) = (event for event in workers.events(0.0) if isinstance(event, Ended))
    return ended


@pytest.mark.parametrize(
    "answered",
    [
        Answered("cancelled"),
        Answered("lost"),
        Answered("error", MemoryError()),
        Answered("finished", asyncio.CancelledError()),
        Answered("finished", RuntimeError("no such key")),
        Answered("finished", None),
        Answered("finished", ("one", "no outcome")),
        Answered("finished", ("one", "")),
    ],
)
def test_what_the_cluster_gives_up_may_pass(
    client: SimpleNamespace, answered: Answered, tmp_path: Path
) -> None:
    outcome = ended_with(client, answered, tmp_path, stop=False).outcome
    assert outcome is not None
    assert (outcome.state, outcome.cause) == (State.FAILED, Cause.WORKER)


def test_what_we_stopped_did_not_fail(client: SimpleNamespace, tmp_path: Path) -> None:
    assert ended_with(client, Answered("cancelled"), tmp_path, stop=True).outcome is None


def test_an_outcome_comes_back(client: SimpleNamespace, tmp_path: Path) -> None:
    done = Outcome(State.DONE, people=2, exports={}, export_problems={})
    answered = Answered("finished", ("one", done.as_text()))
    assert ended_with(client, answered, tmp_path, stop=False) == Ended("00ff", "one", done)
