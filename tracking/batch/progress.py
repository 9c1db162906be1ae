"""How far a batch is: what whoever shows it is told, and how long the rest may take."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, field

from tracking.batch.outcome import Outcome
from tracking.batch.worker_process import Doing


@dataclass(slots=True)
class BatchState:
    """How far a batch is, for whoever shows it.

    Attributes:
        total: recordings. done, failed, skipped: how many of them so far.
        finished: how many of these were so when the batch began.
        doing: by worker. seconds_left: None while it cannot be told.
        left: names of recordings that have not come to their end.
    """

    total: int = 0
    done: int = 0
    failed: int = 0
    skipped: int = 0
    finished: int = 0
    doing: dict[str, Doing] = field(default_factory=dict)
    seconds_left: float | None = None
    left: dict[str, None] = field(default_factory=dict)
    """An ordered set."""


class Listener:
    """Told what happens; a batch that nobody listens to has this one."""

    def began(self, state: BatchState) -> None:
        """What is finished is known, and the rest begins."""

    def ended(self, name: str, outcome: Outcome) -> None:
        """A recording came to its end; the ledger says so on disk."""

    def again(self, name: str, outcome: Outcome) -> None:
        """A recording failed, and is tried once more."""

    def moved(self, state: BatchState) -> None:
        """Called a few times each second."""


class Pace:
    """How long the rest will take, by what was worked through so far.

    A recording counts half as one and half by its bytes, as some take long whatever their size.
    """

    def __init__(self) -> None:
        self._total = self._done = 0.0
        self._mean_bytes = 1.0
        self._began_s = time.monotonic()

    def begin(self, sizes_bytes: Sequence[int]) -> None:
        """Begin with recordings of these sizes."""
        self._mean_bytes = max(1.0, sum(sizes_bytes) / max(1, len(sizes_bytes)))
        self._total, self._done = sum(map(self.weight, sizes_bytes)), 0.0
        self._began_s = time.monotonic()

    def weight(self, size_bytes: int) -> float:
        """How much a recording counts."""
        return 0.5 + 0.5 * size_bytes / self._mean_bytes

    def end(self, size_bytes: int) -> None:
        """A recording came to its end."""
        self._done += self.weight(size_bytes)

    def seconds_left(self, begun: float) -> float | None:
        """Seconds for the rest; begun: weight of what is done of recordings in work."""
        done = self._done + begun
        spent_s = time.monotonic() - self._began_s
        if done <= 0:
            return None
        return max(0.0, spent_s * (self._total - done) / done)
